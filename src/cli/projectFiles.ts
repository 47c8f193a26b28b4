import { join } from 'node:path';
import { extensionOf } from '../formats/source.ts';
import { DocumentError, type GraphDocument } from '../graph/document.ts';
import type { ProjectFile } from '../nodes/files.ts';
import { filesOf, writersIn } from '../nodes/writers.ts';
import { writtenScene } from '../nodes/writtenScene.ts';
import { reportDiagnostics } from './diagnostics.ts';
import { inputProblem, usageError } from './exit.ts';
import { checkWritable } from './output.ts';
import { Progress } from './progress.ts';
import { evaluateNodes, isProject, problemsIn, readProject, told, withParams } from './project.ts';
import { anyScene, BINARY, checkPython, writeAll } from './sceneFiles.ts';

export interface FilesFlags {
  readonly folder?: string;
  readonly set?: readonly string[];
  readonly json?: boolean;
}

/** How each kind of file is written into a folder; gives the paths, the one that was asked for first. */
const WRITE: {
  readonly [K in ProjectFile['kind']]: (file: Extract<ProjectFile, { kind: K }>, folder: string) => Promise<string[]>;
} = {
  scene: async (file, folder) => {
    const written = await anyScene(file.name, (name) => writtenScene(file, name));
    reportDiagnostics([...file.scene.diagnostics, ...written.diagnostics]);
    return writeAll(folder, written);
  },
};

/** Writes every file that the nodes of a project ask for. Nothing is begun where one of them cannot be. */
export async function writeProjectFiles(path: string, { folder = '.', set = [], json }: FilesFlags): Promise<void> {
  if (!(await isProject(path)))
    throw usageError('name the file to write with -o; only projects say by themselves what they write');
  const document = withParams(await readProject(path), set);
  const writers = flatWriters(path, document);
  if (writers.size === 0)
    throw usageError(`${path}: none of its nodes writes a file; add one that does, or name a picture with -o`);
  const progress = new Progress();
  const evaluation = await evaluateNodes(path, document, [...writers.keys()], progress.node);
  progress.clear();
  const files = [...filesOf(evaluation, writers).values()];
  const faults = problemsIn(evaluation).map((fault) => `  ${told(fault)}`);
  if (files.length < writers.size)
    throw inputProblem([`${path}: not all of its files can be written`, ...faults].join('\n'));
  checkFiles(files, folder);
  const paths: string[] = [];
  for (const file of files) paths.push(...(await WRITE[file.kind](file, folder)));
  console.log(json ? JSON.stringify({ files: paths }, null, 2) : paths.join('\n'));
}

function flatWriters(path: string, document: GraphDocument): ReadonlyMap<string, string> {
  try {
    return writersIn(document);
  } catch (error) {
    if (error instanceof DocumentError) throw inputProblem(`${path}: ${error.message}`);
    throw error;
  }
}

function checkFiles(files: readonly ProjectFile[], folder: string): void {
  const names = files.map(({ name }) => name.toLowerCase());
  const twice = names.find((name, i) => names.indexOf(name) < i);
  if (twice !== undefined) throw inputProblem(`two nodes write ${twice}; give one of them another name`);
  for (const { name } of files) checkWritable(join(folder, name));
  if (files.some(({ name }) => extensionOf(name) === BINARY)) checkPython();
}
