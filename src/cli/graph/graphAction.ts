import { own } from '../../graph/document/document.ts';
import { serializeDocument } from '../../graph/document/serialize.ts';
import type { NodeProblem, NodeType } from '../../graph/nodeType.ts';
import { nodePage, nodeReference } from '../../nodes/docs/nodeReference.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { InputError } from '../../scene/types.ts';
import { checkWritable, writeFileAtomically } from '../files/outputFile.ts';
import { formatProblem, projectProblems, readProject } from '../project/project.ts';
import { CliError, EXIT, inputProblem, usageError } from '../terminal/exitCodes.ts';

/** What is wrong with one project; `error`: it cannot be read. */
interface ProjectReport {
  readonly project: string;
  readonly nodes: number;
  readonly faults: readonly NodeProblem[];
  readonly error?: string;
}

/** Checks every project, also after one with errors. With `json`, one project gives its report, several a list. */
export async function check(paths: readonly string[], { json }: { readonly json?: boolean }): Promise<void> {
  const reports: ProjectReport[] = [];
  for (const path of paths) reports.push(await reportOf(path));
  const hasErrors = ({ faults, error }: ProjectReport): boolean => faults.length > 0 || error !== undefined;
  if (json) {
    const [first] = reports;
    if (paths.length === 1 && first?.error !== undefined) throw inputProblem(first.error);
    const printed = paths.length === 1 && first ? { nodes: first.nodes, faults: first.faults } : reports;
    console.log(JSON.stringify(printed, null, 2));
    if (reports.some(hasErrors)) process.exitCode = EXIT.input;
    return;
  }
  for (const report of reports)
    if (!hasErrors(report)) console.log(`${report.project}: ${report.nodes} nodes, nothing is wrong`);
  const lines = reports.flatMap(({ project, faults, error }) => [
    ...(error === undefined ? [] : [error]),
    ...faults.map((fault) => `${project}: ${formatProblem(fault)}`),
  ]);
  if (lines.length > 0) throw inputProblem(lines.join('\n'));
}

async function reportOf(project: string): Promise<ProjectReport> {
  try {
    const document = await readProject(project);
    return { project, nodes: Object.keys(document.nodes).length, faults: projectProblems(document) };
  } catch (error) {
    const isUnreadable = error instanceof InputError || (error instanceof CliError && error.exitCode === EXIT.input);
    if (!isUnreadable) throw error;
    return { project, nodes: 0, faults: [], error: error.message };
  }
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
