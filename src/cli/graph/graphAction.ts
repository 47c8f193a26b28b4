import { own } from '../../graph/document/document.ts';
import { serializeDocument } from '../../graph/document/serialize.ts';
import type { NodeProblem, NodeType } from '../../graph/nodeType.ts';
import { inLines, listed, type Message, msg } from '../../messages/message.ts';
import { nodePage, nodeReference } from '../../nodes/docs/nodeReference.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { shaderTextFaults } from '../../nodes/project/shaderTextFaults.ts';
import { InputError } from '../../scene/types.ts';
import { checkWritable, writeFileAtomically } from '../files/outputFile.ts';
import { projectProblems, readProject } from '../project/project.ts';
import { placed } from '../terminal/diagnostics.ts';
import { CliError, EXIT, inputProblem, usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { localized } from '../terminal/language.ts';

/** What is wrong with one project; `error`: it cannot be read. */
interface ProjectReport {
  readonly project: string;
  readonly nodes: number;
  readonly faults: readonly NodeProblem[];
  readonly error?: Message;
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
    console.log(toJson(printed));
    if (reports.some(hasErrors)) process.exitCode = EXIT.input;
    return;
  }
  for (const report of reports)
    if (!hasErrors(report)) console.log(localized(msg`${report.project}: ${report.nodes} nodes, nothing is wrong`));
  const lines = reports.flatMap<Message>(({ project, faults, error }) => [
    ...(error === undefined ? [] : [error]),
    ...faults.map((fault) => msg`${project}: ${placed(fault)}`),
  ]);
  if (lines.length > 0) throw inputProblem(inLines(lines));
}

async function reportOf(project: string): Promise<ProjectReport> {
  try {
    const document = await readProject(project);
    const texts = await shaderTextFaults(document);
    const faults = [...projectProblems(document), ...texts.values()];
    return { project, nodes: Object.keys(document.nodes).length, faults };
  } catch (error) {
    const isUnreadable = error instanceof InputError || (error instanceof CliError && error.exitCode === EXIT.input);
    if (!isUnreadable) throw error;
    return { project, nodes: 0, faults: [], error: error.text };
  }
}

export async function upgrade(path: string, { output = path }: { readonly output?: string }): Promise<void> {
  const document = await readProject(path);
  checkWritable(output);
  writeFileAtomically(output, new TextEncoder().encode(serializeDocument(document)));
  console.log(output);
}

export async function docs(type?: string): Promise<void> {
  console.log(type === undefined ? nodeReference(localized) : nodePage(nodeTypeOf(type), localized));
}

function nodeTypeOf(id: string): NodeType {
  const type = own(nodeLibrary, id);
  if (type) return type as NodeType;
  throw usageError(msg`there is no node type ${id}; there are ${listed(Object.keys(nodeLibrary))}`);
}
