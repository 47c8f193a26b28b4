import { join } from 'node:path';
import { extensionOf } from '../formats/source.ts';
import { DocumentError, type GraphDocument } from '../graph/document.ts';
import { framesOf, type ImageFile, type ProjectFile, type VideoFile } from '../nodes/files.ts';
import { filesOf, writersIn } from '../nodes/writers.ts';
import { writtenScene } from '../nodes/writtenScene.ts';
import { reportDiagnostics } from './diagnostics.ts';
import { drawFiles } from './drawFiles.ts';
import { inputProblem, usageError } from './exit.ts';
import { checkWritable, endIfStopped } from './output.ts';
import { checkPipeline } from './pipeline.ts';
import { Progress } from './progress.ts';
import {
  evaluateNodes,
  isProject,
  pictureFlags,
  problemsIn,
  readProject,
  refuseSceneFlags,
  told,
  withParams,
} from './project.ts';
import type { RenderFlags } from './render.ts';
import { anyScene, BINARY, checkPython, writeAll } from './sceneFiles.ts';
import { checkEncoder, FILM } from './video.ts';

export interface FilesFlags extends Omit<RenderFlags, 'output'> {
  readonly folder?: string;
}

/** Where files are written, of which project, and what somebody wants of them. */
interface Place {
  readonly folder: string;
  readonly flags: FilesFlags;
  /** Flags that somebody wrote. */
  readonly given: ReadonlySet<string>;
}

/** How each kind of file is written; gives the paths, the one that was asked for first. */
const WRITE: {
  readonly [K in ProjectFile['kind']]: (
    file: Extract<ProjectFile, { kind: K }>,
    place: Place,
  ) => Promise<readonly string[]>;
} = {
  scene: async (file, { folder }) => {
    const written = await anyScene(file.name, (name) => writtenScene(file, name));
    reportDiagnostics([...file.scene.diagnostics, ...written.diagnostics]);
    return writeAll(folder, written);
  },
  image: writeDrawn,
  video: (file, place) => writeDrawn(file, place, { fps: file.fps, hold: file.hold }),
};

/** As `render -o` does it. */
async function writeDrawn(
  file: ImageFile | VideoFile,
  { folder, flags, given }: Place,
  more: Partial<RenderFlags> = {},
): Promise<readonly string[]> {
  const { name, width, height, samples, picture } = file;
  const own = { output: join(folder, name), size: { width, height }, ...more };
  const opened = pictureFlags(picture, { ...flags, ...own }, given, file.kind === 'video');
  const sampled = opened.flags.antialiasing ? { ...opened, flags: { ...opened.flags, samples } } : opened;
  return (await drawFiles(sampled, framesOf(file), new Progress(`${name}: `))).files;
}

/** Writes every file that the nodes of a project ask for. Nothing is begun where one of them cannot be. */
export async function writeProjectFiles(path: string, flags: FilesFlags, given: ReadonlySet<string>): Promise<void> {
  if (!(await isProject(path)))
    throw usageError('name the file to write with -o; only projects say by themselves what they write');
  checkFlags(flags, given);
  const { folder = '.', set = [], json } = flags;
  const files = await wantedFiles(path, withParams(await readProject(path), set));
  checkFiles(files, folder);
  const paths: string[] = [];
  for (const file of files) {
    endIfStopped();
    paths.push(...(await write(file, { folder, flags, given })));
  }
  console.log(json ? JSON.stringify({ files: paths }, null, 2) : paths.join('\n'));
}

const write = (file: ProjectFile, place: Place): Promise<readonly string[]> =>
  (WRITE[file.kind] as (file: ProjectFile, place: Place) => Promise<readonly string[]>)(file, place);

/** Flags of which each node that writes has its own. */
const OF_NODES = ['time', 'frames', 'fps', 'hold', 'size', 'samples', 'aov'];

function checkFlags(flags: FilesFlags, given: ReadonlySet<string>): void {
  refuseSceneFlags(given);
  checkPipeline(flags);
  const odd = OF_NODES.find((name) => given.has(name));
  if (odd !== undefined)
    throw usageError(`--${odd} is for -o; without it each node that writes says so itself: use --set node.param=value`);
}

/** What the nodes ask for; refused where one of them cannot. */
async function wantedFiles(path: string, document: GraphDocument): Promise<readonly ProjectFile[]> {
  const writers = flatWriters(path, document);
  if (writers.size === 0)
    throw usageError(`${path}: none of its nodes writes a file; add one that does, or name a picture with -o`);
  const progress = new Progress();
  const evaluation = await evaluateNodes(path, document, [...writers.keys()], progress.node);
  progress.clear();
  const files = [...filesOf(evaluation, writers).values()];
  if (files.length === writers.size) return files;
  const faults = problemsIn(evaluation).map((fault) => `  ${told(fault)}`);
  throw inputProblem([`${path}: not all of its files can be written`, ...faults].join('\n'));
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
  const extensions = new Set(files.map(({ name }) => extensionOf(name)));
  if (extensions.has(BINARY)) checkPython();
  if (extensions.has(FILM)) checkEncoder();
}
