import { own } from '../../graph/document/document.ts';
import { serializeDocument } from '../../graph/document/serialize.ts';
import type { NodeType } from '../../graph/nodeType.ts';
import { nodePage, nodeReference } from '../../nodes/docs/nodeReference.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { checkWritable, writeFileAtomically } from '../files/outputFile.ts';
import { formatProblem, projectProblems, readProject } from '../project/project.ts';
import { EXIT, inputProblem, usageError } from '../terminal/exitCodes.ts';

export async function check(path: string, { json }: { readonly json?: boolean }): Promise<void> {
  const document = await readProject(path);
  const faults = projectProblems(document);
  const nodes = Object.keys(document.nodes).length;
  if (json) console.log(JSON.stringify({ nodes, faults }, null, 2));
  else if (faults.length === 0) console.log(`${path}: ${nodes} nodes, nothing is wrong`);
  if (faults.length === 0) return;
  if (json) process.exitCode = EXIT.input;
  else throw inputProblem(faults.map((fault) => `${path}: ${formatProblem(fault)}`).join('\n'));
}

export async function upgrade(path: string, { output = path }: { readonly output?: string }): Promise<void> {
  const document = await readProject(path);
  checkWritable(output);
  writeFileAtomically(output, new TextEncoder().encode(serializeDocument(document)));
  console.log(output);
}

export async function docs(type?: string): Promise<void> {
  console.log(type === undefined ? nodeReference() : nodePage(nodeTypeOf(type)));
}

function nodeTypeOf(id: string): NodeType {
  const type = own(nodeLibrary, id);
  if (type) return type as NodeType;
  throw usageError(`there is no node type ${id}; there are ${Object.keys(nodeLibrary).join(', ')}`);
}
