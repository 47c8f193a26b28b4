import { own } from '../graph/document.ts';
import type { NodeType } from '../graph/nodeType.ts';
import { serializeDocument } from '../graph/serialize.ts';
import { nodeLibrary } from '../nodes/library.ts';
import { nodePage, nodeReference } from '../nodes/reference.ts';
import { EXIT, inputProblem, usageError } from './exit.ts';
import { checkWritable, writeWhole } from './output.ts';
import { faultsOf, readProject, told } from './project.ts';

export async function check(path: string, { json }: { readonly json?: boolean }): Promise<void> {
  const document = await readProject(path);
  const faults = faultsOf(document);
  const nodes = Object.keys(document.nodes).length;
  if (json) console.log(JSON.stringify({ nodes, faults }, null, 2));
  else if (faults.length === 0) console.log(`${path}: ${nodes} nodes, nothing is wrong`);
  if (faults.length === 0) return;
  if (json) process.exitCode = EXIT.input;
  else throw inputProblem(faults.map((fault) => `${path}: ${told(fault)}`).join('\n'));
}

export async function upgrade(path: string, { output = path }: { readonly output?: string }): Promise<void> {
  const document = await readProject(path);
  checkWritable(output);
  writeWhole(output, new TextEncoder().encode(serializeDocument(document)));
  console.log(output);
}

export async function docs(type?: string): Promise<void> {
  console.log(type === undefined ? nodeReference() : nodePage(typeNamed(type)));
}

function typeNamed(id: string): NodeType {
  const type = own(nodeLibrary, id);
  if (type) return type as NodeType;
  throw usageError(`there is no node type ${id}; there are ${Object.keys(nodeLibrary).join(', ')}`);
}
