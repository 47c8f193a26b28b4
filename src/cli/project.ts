import { readFile } from 'node:fs/promises';
import { dirname, isAbsolute, join } from 'node:path';
import { inputError } from '../formats/fail.ts';
import { applyCommand, type Command } from '../graph/commands.ts';
import { type GraphDocument, own, type ParamValue } from '../graph/document.ts';
import { type Evaluation, Evaluator, type RunHeavy } from '../graph/evaluate.ts';
import { type ParamSpec, type Problem, refuseValue } from '../graph/nodeType.ts';
import { parseDocument } from '../graph/read.ts';
import { validateDocument } from '../graph/validate.ts';
import { degrees } from '../math/angle.ts';
import { outputIn } from '../nodes/chain.ts';
import type { Picture } from '../nodes/define.ts';
import { surveyed } from '../nodes/geometry/surveyed.ts';
import { nodeLibrary } from '../nodes/library.ts';
import { pictureOf, startingBeta } from '../nodes/picture.ts';
import { PROJECT } from '../nodes/projectArchive.ts';
import type { Services } from '../nodes/services.ts';
import { drawableScene } from '../scene/drawable.ts';
import type { Plan } from '../scene/plan.ts';
import type { Scene } from '../scene/types.ts';
import { openDevice } from './device.ts';
import { inputProblem, usageError } from './exit.ts';
import { findScene, openSceneFile } from './files.ts';
import { readFont } from './fonts.ts';
import { heavyNodes } from './heavyNodes.ts';
import type { RenderFlags } from './render.ts';
import { traceHere } from './trace.ts';

const isArchive = (path: string): boolean => path.toLowerCase().endsWith('.zip');

/** Whether a file is a project, which is a node graph: by its name, or an archive that holds one. */
export async function isProject(path: string): Promise<boolean> {
  if (!isArchive(path)) return path.toLowerCase().endsWith('.slowlight.json');
  const { source, entry } = await findScene(inArchive(path, PROJECT));
  return (await source.list?.())?.includes(entry) ?? false;
}

const inArchive = (archive: string, file: string): string => `${archive}[${file}]`;

/** Reads a project of any version, of an archive the one in it, and checks nothing but that it is one. */
export async function readProject(path: string): Promise<GraphDocument> {
  const bytes = isArchive(path)
    ? await readPacked(path)
    : await readFile(path).catch((error) => refuseFile(path, error));
  try {
    return parseDocument(new TextDecoder().decode(bytes));
  } catch (error) {
    throw inputProblem(`${path}: ${error instanceof Error ? error.message : String(error)}`);
  }
}

/** A file on disk or in an archive; undefined where there is none. */
async function bytesAt(path: string): Promise<Uint8Array | undefined> {
  const { source, entry } = await findScene(path);
  return source.read(entry);
}

function refuseFile(path: string, { code, message }: NodeJS.ErrnoException): never {
  throw inputProblem(`${path}: ${code === 'ENOENT' ? 'no such file' : `cannot be read (${message})`}`);
}

async function readPacked(path: string): Promise<Uint8Array> {
  const bytes = await bytesAt(inArchive(path, PROJECT));
  if (!bytes) throw inputProblem(`${path}: it holds no ${PROJECT}; save the project with its files again`);
  return bytes;
}

/** Sets parameters as `--set node.param=value` has them. */
export function withParams(document: GraphDocument, sets: readonly string[]): GraphDocument {
  const commands = sets.map((text): Command => {
    const [, node, param, value] = /^([^.=]+)\.([^=]+)=(.*)$/s.exec(text) ?? [];
    if (node === undefined || param === undefined || value === undefined)
      throw usageError(`--set ${text}: write node.param=value, like console.speedOfLight=10`);
    return { kind: 'set-param', node, param, value: valueFor(document, node, param, value) };
  });
  return applyCommand(document, { kind: 'batch', commands }).document;
}

function valueFor(document: GraphDocument, node: string, param: string, text: string): ParamValue {
  const found = own(document.nodes, node);
  if (!found) {
    const known = Object.keys(document.nodes).join(', ');
    throw usageError(`--set ${node}.${param}: the project has no such node; it has ${known || 'none'}`);
  }
  const params = own(nodeLibrary, found.type)?.params ?? {};
  const spec = own(params, param);
  if (!spec) {
    const known = Object.keys(params).join(', ');
    throw usageError(`--set ${node}.${param}: a ${found.type} has no such parameter; it has ${known || 'none'}`);
  }
  const value = parsed(spec, text);
  const refusal = refuseValue(spec, value);
  if (refusal) throw usageError(`--set ${node}.${param}=${text}: ${refusal}`);
  return value;
}

function parsed(spec: ParamSpec, text: string): ParamValue {
  switch (spec.kind) {
    case 'number':
      return text.includes(',') ? text : (numbersIn(text)?.[0] ?? text);
    case 'boolean':
      return text === 'true' || text === 'on' ? true : text === 'false' || text === 'off' ? false : text;
    case 'vector':
    case 'color':
      return numbersIn(text) ?? text;
    case 'list':
      return text === '' ? [] : text.split(';');
    default:
      return text;
  }
}

/** Undefined where one of them is none; nothing is not 0. */
function numbersIn(text: string): number[] | undefined {
  const parts = text.split(',');
  return parts.some((part) => part.trim() === '' || Number.isNaN(Number(part))) ? undefined : parts.map(Number);
}

/** What is wrong with a project as it stands; files are not opened. */
export const faultsOf = (document: GraphDocument): readonly Problem[] => validateDocument(document, nodeLibrary);

/** One line for a person: place, what, and what to do. */
export const told = ({ place, message }: Problem): string => `${place}: ${message}`;

/** What nodes of a project give. */
export const evaluateNodes = (
  path: string,
  document: GraphDocument,
  nodes: readonly string[],
  progress: (node: string, part: number | undefined) => void,
  heavy: RunHeavy = heavyNodes(),
): Promise<Evaluation> =>
  new Evaluator(nodeLibrary, { heavy }).evaluate(document, nodes, servicesAt(path), { progress });

/** The picture that a project describes. Files are looked for beside it. */
async function evaluateProject(
  path: string,
  document: GraphDocument,
  progress: (node: string, part: number | undefined) => void,
): Promise<Picture> {
  const evaluation = await evaluateNodes(path, document, [outputOf(path, document)], progress);
  const picture = pictureOf(evaluation);
  if (picture) return picture;
  const faults = problemsIn(evaluation);
  throw inputProblem([`${path}: there is no picture`, ...faults.map((fault) => `  ${told(fault)}`)].join('\n'));
}

function outputOf(path: string, document: GraphDocument): string {
  const output = outputIn(document);
  if (output !== undefined) return output;
  throw inputProblem(`${path}: it has no output node, so that it makes no picture; add one`);
}

export const problemsIn = ({ results }: Evaluation): readonly Problem[] =>
  [...results.values()].flatMap((result) => (result.status === 'failed' ? [result.problem] : []));

/** Reads files here, from where the project is: beside it, or in its archive. */
function servicesAt(project: string): Services {
  const at = (source: string): string => {
    if (isArchive(project)) return inArchive(project, source);
    return isAbsolute(source) ? source : join(dirname(project), source);
  };
  return {
    readFont,
    trace: traceHere,
    openGpu: openDevice,
    async readScene(source, { variants, interpolation }) {
      const read = await openSceneFile(at(source), {
        ...(variants && { variants }),
        ...(interpolation && { interpolation }),
      });
      return surveyed(drawableScene(read).scene);
    },
    async readFile(name) {
      const bytes = await bytesAt(at(name));
      if (!bytes) throw inputError('file.missing', name, 'there is no such file; put it beside the project');
      return bytes;
    },
  };
}

/** A project's picture in the words of the command line; what the user says there comes before it. */
export async function projectFlags<Flags extends RenderFlags>(
  path: string,
  flags: Flags,
  given: ReadonlySet<string>,
  progress: (node: string, part: number | undefined) => void,
): Promise<Opened<Flags>> {
  refuseSceneFlags(given);
  const document = withParams(await readProject(path), flags.set ?? []);
  return pictureFlags(await evaluateProject(path, document, progress), flags, given, flags.frames !== undefined);
}

/**
 * A picture of a project, drawn as it says; what the user says on the command line comes before it. As in the page, an observer who does not ride the
 * camera begins at rest in it; in a film he goes with it.
 */
export function pictureFlags<Flags extends RenderFlags>(
  picture: Picture,
  flags: Flags,
  given: ReadonlySet<string>,
  film: boolean,
): Opened<Flags> {
  const said = Object.fromEntries(Object.entries(flagsOf(picture, film)).filter(([name]) => !given.has(name)));
  const { scenes, plan } = picture;
  return { scene: picture.scene, others: scenes.slice(1), ...(plan && { plan }), flags: { ...flags, ...said } };
}

/** What is drawn, and how. */
export interface Opened<Flags> {
  readonly scene: Scene;
  /** What the plan's other G-buffers are of. */
  readonly others: readonly Scene[];
  /** What a project makes of the light; undefined: nothing. */
  readonly plan?: Plan;
  readonly flags: Flags;
}

/** What a scene file is opened with is written in a project's own nodes. */
const SCENE_FLAGS = [
  'variant',
  'animation',
  'interpolation',
  'subdivision',
  'speedFactor',
  'startOffset',
  'fly',
  'flyShape',
];

export function refuseSceneFlags(given: ReadonlySet<string>): void {
  const odd = SCENE_FLAGS.find((name) => given.has(name));
  if (odd === undefined) return;
  const flag = `--${odd.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
  throw usageError(`${flag} is for scene files; a project says so in its nodes: use --set node.param=value`);
}

function flagsOf(picture: Picture, film: boolean): Partial<RenderFlags> {
  const { view, lightDelay, aberration, colors, dopplerMix, beaming, exposure, metering, tone } = picture;
  const {
    solver,
    iterations,
    damping,
    antialiasing,
    grid,
    speedOfLight,
    camera,
    fovY,
    falseColor,
    shadows,
    occlusion,
  } = picture;
  const beta = startingBeta(picture, film);
  return {
    ...{ view, lightDelay, aberration, colors, dopplerMix, beaming, exposure, metering, tone, shadows },
    ...(!occlusion && { occlusionRadius: 0 }),
    ...{ solver, iterations, damping, antialiasing, grid, c: speedOfLight },
    ...(camera && { camera }),
    ...(beta && { beta }),
    ...(fovY !== undefined && { fov: degrees(fovY) }),
    ...(falseColor !== 'none' && { falseColour: falseColor }),
  };
}
