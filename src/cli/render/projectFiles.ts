import { join } from 'node:path';
import { FlightPlayback } from '../../flight/recording/playback.ts';
import { extensionOf } from '../../formats/files/fileSource.ts';
import { DocumentError, type GraphDocument } from '../../graph/document/document.ts';
import { inLines, msg } from '../../messages/message.ts';
import { flownFrames } from '../../nodes/pictures/fileSequence.ts';
import { exportSceneFile } from '../../nodes/project/exportSceneFile.ts';
import { fileNodesIn, requestedFiles } from '../../nodes/project/fileNodes.ts';
import {
  type FrameTime,
  frameTimes,
  type ImageOutput,
  type RequestedFile,
  type VideoOutput,
} from '../../nodes/project/outputFiles.ts';
import { writeExportedFiles } from '../files/exportScene.ts';
import { checkWritable, throwIfStopped } from '../files/outputFile.ts';
import { checkPipeline } from '../flags/pipelineFlags.ts';
import { flagName } from '../flags/viewFlags.ts';
import {
  evaluateNodes,
  isProject,
  problemsIn,
  readProject,
  refuseSceneFlags,
  renderJobOf,
  withParams,
} from '../project/project.ts';
import { placed, reportDiagnostics } from '../terminal/diagnostics.ts';
import { inputProblem, usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { Progress } from '../terminal/progress.ts';
import type { FilmedFlight } from './flightFilm.ts';
import type { ProjectFilesFlags, RenderFlags } from './renderFlags.ts';
import { renderFrames } from './renderFrames.ts';
import { checkEncoder, VIDEO_EXTENSION } from './videoWriter.ts';

interface WriteTarget {
  readonly folder: string;
  readonly flags: ProjectFilesFlags;
  /** Names of the explicitly given flags. */
  readonly given: ReadonlySet<string>;
}

/** Writers by kind of file; each returns the paths, the requested file first. */
const WRITERS: {
  readonly [K in RequestedFile['kind']]: (
    file: Extract<RequestedFile, { kind: K }>,
    place: WriteTarget,
  ) => Promise<readonly string[]>;
} = {
  scene: async (file, { folder }) => {
    const written = await exportSceneFile(file, file.name);
    reportDiagnostics([...file.scene.diagnostics, ...written.diagnostics]);
    return writeExportedFiles(folder, written);
  },
  image: writeRendered,
  video: (file, place) => {
    const how = { fps: file.fps, spacing: file.spacing, stayInPlace: file.stayInPlace };
    if (!file.flight) return writeRendered(file, place, how);
    const flight = { playback: new FlightPlayback(file.flight), speedOfLight: file.picture.speedOfLight };
    return writeRendered(file, place, how, flownFrames(file, flight.playback), flight);
  },
};

/** Renders to a file as `render -o` does. */
async function writeRendered(
  file: ImageOutput | VideoOutput,
  { folder, flags, given }: WriteTarget,
  more: Partial<RenderFlags> = {},
  frames: readonly FrameTime[] = frameTimes(file),
  flight?: FilmedFlight,
): Promise<readonly string[]> {
  const { name, width, height, samples, picture } = file;
  const own = { output: join(folder, name), size: { width, height }, ...more };
  const opened = renderJobOf(picture, { ...flags, ...own }, given, file.kind === 'video');
  const sampled = opened.flags.antialiasing ? { ...opened, flags: { ...opened.flags, samples } } : opened;
  return (await renderFrames(sampled, frames, new Progress(name), flight)).files;
}

/** Writes every file that the nodes of a project request; writes none if one of them cannot be written. */
export async function writeProjectFiles(
  path: string,
  flags: ProjectFilesFlags,
  given: ReadonlySet<string>,
): Promise<void> {
  if (!(await isProject(path)))
    throw usageError(msg`name the file to write with -o; only projects say by themselves what they write`);
  checkFlags(flags, given);
  const { folder = '.', set = [], json } = flags;
  const files = await collectFiles(path, withParams(await readProject(path), set));
  checkFiles(files, folder);
  const paths: string[] = [];
  for (const file of files) {
    throwIfStopped();
    paths.push(...(await write(file, { folder, flags, given })));
  }
  console.log(json ? toJson({ files: paths }) : paths.join('\n'));
}

const write = (file: RequestedFile, place: WriteTarget): Promise<readonly string[]> =>
  (WRITERS[file.kind] as (file: RequestedFile, place: WriteTarget) => Promise<readonly string[]>)(file, place);

/** Flags that are parameters of each node that writes a file. */
const NODE_FLAGS = ['time', 'frames', 'fps', 'spacing', 'stayInPlace', 'size', 'samples', 'aov'];

function checkFlags(flags: ProjectFilesFlags, given: ReadonlySet<string>): void {
  refuseSceneFlags(given);
  checkPipeline(flags);
  const odd = NODE_FLAGS.find((name) => given.has(name));
  if (odd !== undefined)
    throw usageError(
      msg`--${flagName(odd)} is for -o; without it each node that writes says so itself: use --set node.param=value`,
    );
}

/** The files that the nodes request; throws if a node has failed. */
async function collectFiles(path: string, document: GraphDocument): Promise<readonly RequestedFile[]> {
  const writers = flatWriters(path, document);
  if (writers.size === 0)
    throw usageError(msg`${path}: none of its nodes writes a file; add one that does, or name a picture with -o`);
  const progress = new Progress();
  const evaluation = await evaluateNodes(path, document, [...writers.keys()], progress.node);
  progress.clear();
  const files = [...requestedFiles(evaluation, writers).values()];
  if (files.length === writers.size) return files;
  const faults = problemsIn(evaluation).map((fault) => msg`  ${placed(fault)}`);
  throw inputProblem(inLines([msg`${path}: not all of its files can be written`, ...faults]));
}

function flatWriters(path: string, document: GraphDocument): ReadonlyMap<string, string> {
  try {
    return fileNodesIn(document);
  } catch (error) {
    if (error instanceof DocumentError) throw inputProblem(msg`${path}: ${error.text}`);
    throw error;
  }
}

function checkFiles(files: readonly RequestedFile[], folder: string): void {
  const names = files.map(({ name }) => name.toLowerCase());
  const twice = names.find((name, i) => names.indexOf(name) < i);
  if (twice !== undefined) throw inputProblem(msg`two nodes write ${twice}; give one of them another name`);
  for (const { name } of files) checkWritable(join(folder, name));
  const extensions = new Set(files.map(({ name }) => extensionOf(name)));
  if (extensions.has(VIDEO_EXTENSION)) checkEncoder();
}
