import { readFile } from 'node:fs/promises';
import { dirname, isAbsolute, join } from 'node:path';
import { inputError } from '../../formats/diagnostics/inputError.ts';
import { validateDocument } from '../../graph/analysis/validate.ts';
import { type GraphDocument, own, type ParamValue } from '../../graph/document/document.ts';
import { parseDocument } from '../../graph/document/parse.ts';
import { applyCommand, type Command } from '../../graph/edits/commands.ts';
import { type Evaluation, Evaluator, type RunHeavy } from '../../graph/evaluation/evaluator.ts';
import { type NodeProblem, type ParamSpec, valueError } from '../../graph/nodeType.ts';
import { degrees } from '../../math/angle.ts';
import { inLines, listed, msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { toLoadedScene } from '../../nodes/common/loadedScene.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { evaluatedPicture, initialBeta } from '../../nodes/pictures/renderSettings.ts';
import { outputNodeId } from '../../nodes/project/outputChain.ts';
import { PROJECT_FILE_NAME } from '../../nodes/project/projectArchive.ts';
import type { Services } from '../../nodes/services.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import { pickSettings, SETTING_NAMES } from '../../scene/settings/settings.ts';
import type { Scene } from '../../scene/types.ts';
import { renderableScene } from '../../scene/validation/renderableScene.ts';
import { choiceOf } from '../../scene/view/lenses/lensChoice.ts';
import type { PanoramicLens } from '../../scene/view/lenses/lenses.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { readFont } from '../files/fonts.ts';
import { locateScene, openSceneFile } from '../files/sceneFiles.ts';
import { flagName } from '../flags/viewFlags.ts';
import { openDevice } from '../gpu/device.ts';
import { renderStill } from '../pipelines/renderStill.ts';
import type { RenderFlags } from '../render/renderFlags.ts';
import { placed } from '../terminal/diagnostics.ts';
import { inputProblem, usageError } from '../terminal/exitCodes.ts';
import { heavyNodes } from './heavyNodes.ts';

const isArchive = (path: string): boolean => path.toLowerCase().endsWith('.zip');

/** Whether a file is a project, by its name, or an archive that contains one. */
export async function isProject(path: string): Promise<boolean> {
  if (!isArchive(path)) return path.toLowerCase().endsWith('.slowlight.json');
  const { source, entry } = await locateScene(pathInArchive(path, PROJECT_FILE_NAME));
  return (await source.list?.())?.includes(entry) ?? false;
}

const pathInArchive = (archive: string, file: string): string => `${archive}[${file}]`;

/** Reads a project of any version, from a file or an archive; its nodes are not validated. */
export async function readProject(path: string): Promise<GraphDocument> {
  const bytes = isArchive(path)
    ? await readPacked(path)
    : await readFile(path).catch((error) => throwUnreadable(path, error));
  try {
    return parseDocument(new TextDecoder().decode(bytes));
  } catch (error) {
    throw inputProblem(msg`${path}: ${messageOf(error)}`);
  }
}

/** A file on disk or in an archive; undefined if it does not exist. */
async function readBytes(path: string): Promise<Uint8Array | undefined> {
  const { source, entry } = await locateScene(path);
  return source.read(entry);
}

function throwUnreadable(path: string, { code, message }: NodeJS.ErrnoException): never {
  throw inputProblem(msg`${path}: ${code === 'ENOENT' ? msg`no such file` : msg`cannot be read (${message})`}`);
}

async function readPacked(path: string): Promise<Uint8Array> {
  const bytes = await readBytes(pathInArchive(path, PROJECT_FILE_NAME));
  if (!bytes) throw inputProblem(msg`${path}: it holds no ${PROJECT_FILE_NAME}; save the project with its files again`);
  return bytes;
}

/** Sets parameters by `node.param=value`. */
export function withParams(document: GraphDocument, sets: readonly string[]): GraphDocument {
  const commands = sets.map((text): Command => {
    const [, node, param, value] = /^([^.=]+)\.([^=]+)=(.*)$/s.exec(text) ?? [];
    if (node === undefined || param === undefined || value === undefined)
      throw usageError(msg`--set ${text}: write node.param=value, like console.speedOfLight=10`);
    return { kind: 'set-param', node, param, value: valueFor(document, node, param, value) };
  });
  return applyCommand(document, { kind: 'batch', commands }).document;
}

function valueFor(document: GraphDocument, node: string, param: string, text: string): ParamValue {
  const found = own(document.nodes, node);
  if (!found) {
    const known = listed(Object.keys(document.nodes));
    throw usageError(msg`--set ${node}.${param}: the project has no such node; it has ${known || msg`none`}`);
  }
  const params = own(nodeLibrary, found.type)?.params ?? {};
  const spec = own(params, param);
  if (!spec) {
    const known = listed(Object.keys(params));
    throw usageError(msg`--set ${node}.${param}: a ${found.type} has no such parameter; it has ${known || msg`none`}`);
  }
  const value = parseParam(spec, text);
  const refusal = valueError(spec, value);
  if (refusal) throw usageError(msg`--set ${node}.${param}=${text}: ${refusal}`);
  return value;
}

function parseParam(spec: ParamSpec, text: string): ParamValue {
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

/** Comma-separated numbers; undefined if one is empty or not a number. */
function numbersIn(text: string): number[] | undefined {
  const parts = text.split(',');
  return parts.some((part) => part.trim() === '' || Number.isNaN(Number(part))) ? undefined : parts.map(Number);
}

/** Problems of a project, without opening its files. */
export const projectProblems = (document: GraphDocument): readonly NodeProblem[] =>
  validateDocument(document, nodeLibrary);

/** Evaluates nodes of a project. */
export const evaluateNodes = (
  path: string,
  document: GraphDocument,
  nodes: readonly string[],
  progress: (node: string, part: number | undefined) => void,
  heavy: RunHeavy = heavyNodes(),
): Promise<Evaluation> =>
  new Evaluator(nodeLibrary, { heavy }).evaluate(document, nodes, servicesAt(path), { progress });

/** The picture that a project describes; its files are relative to it. */
async function evaluateProject(
  path: string,
  document: GraphDocument,
  progress: (node: string, part: number | undefined) => void,
): Promise<PictureSpec> {
  const evaluation = await evaluateNodes(path, document, [outputNodeOf(path, document)], progress);
  const picture = evaluatedPicture(evaluation);
  if (picture) return picture;
  const faults = problemsIn(evaluation);
  throw inputProblem(inLines([msg`${path}: there is no picture`, ...faults.map((fault) => msg`  ${placed(fault)}`)]));
}

function outputNodeOf(path: string, document: GraphDocument): string {
  const output = outputNodeId(document);
  if (output !== undefined) return output;
  throw inputProblem(msg`${path}: it has no output node, so that it makes no picture; add one`);
}

export const problemsIn = ({ results }: Evaluation): readonly NodeProblem[] =>
  [...results.values()].flatMap((result) => (result.status === 'failed' ? [result.problem] : []));

/** Services that read files relative to the project or from its archive. */
function servicesAt(project: string): Services {
  const at = (source: string): string => {
    if (isArchive(project)) return pathInArchive(project, source);
    return isAbsolute(source) ? source : join(dirname(project), source);
  };
  return {
    readFont,
    renderStill,
    openGpu: openDevice,
    async readScene(source, { signal: _, progress: __, ...how }) {
      const read = await openSceneFile(at(source), how);
      return toLoadedScene(renderableScene(read).scene);
    },
    async readFile(name) {
      const bytes = await readBytes(at(name));
      if (!bytes) throw inputError('file.missing', name, msg`there is no such file; put it beside the project`);
      return bytes;
    },
  };
}

/** A project's picture as a render job. */
export async function openProjectJob<Flags extends RenderFlags>(
  path: string,
  flags: Flags,
  given: ReadonlySet<string>,
  progress: (node: string, part: number | undefined) => void,
): Promise<RenderJob<Flags>> {
  const picture = await openProjectPicture(path, flags.set ?? [], given, progress);
  return renderJobOf(picture, flags, given, flags.frames !== undefined);
}

/** Throws if parameters of nodes are set for a scene file. */
export function refuseSets(sets: readonly string[] | undefined): void {
  if (sets) throw usageError(msg`--set is for projects, .slowlight.json; of a scene file there are no nodes to set`);
}

/** A project's picture, with parameters that are set by `node.param=value`. */
export async function openProjectPicture(
  path: string,
  sets: readonly string[],
  given: ReadonlySet<string>,
  progress: (node: string, part: number | undefined) => void,
): Promise<PictureSpec> {
  refuseSceneFlags(given);
  return evaluateProject(path, withParams(await readProject(path), sets), progress);
}

/** A lens is given as a whole. */
const LENS_FLAGS = ['aperture', 'domeTilt', 'eyeSeparation', 'fov'];

/** A picture as a render job; explicitly given flags take precedence. As in the page, an observer who does not ride the scene's moving camera is at rest in it; in a film the camera is followed. */
export function renderJobOf<Flags extends RenderFlags>(
  picture: PictureSpec,
  flags: Flags,
  given: ReadonlySet<string>,
  film: boolean,
): RenderJob<Flags> {
  const isOpen = (name: string): boolean => !given.has(name) && !(given.has('lens') && LENS_FLAGS.includes(name));
  const implied = Object.fromEntries(Object.entries(flagsOf(picture, film)).filter(([name]) => isOpen(name)));
  const { scene, scenes, frameGraph, outside, capture } = picture;
  return {
    scene,
    others: scenes.slice(1),
    projectSettings: { ...(frameGraph && { frameGraph }), ...(outside && { outside }), ...(capture && { capture }) },
    flags: { ...flags, ...implied },
  };
}

export interface RenderJob<Flags> {
  readonly scene: Scene;
  /** Scenes of the frame graph's other G-buffers. */
  readonly others: readonly Scene[];
  /** Settings that no flag sets; empty for scene files. */
  readonly projectSettings: Pick<RenderSettings, 'frameGraph' | 'outside' | 'capture'>;
  readonly flags: Flags;
}

/** Flags for opening scene files; in projects these are parameters of nodes. */
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
  const flag = `--${flagName(odd)}`;
  throw usageError(msg`${flag} is for scene files; a project says so in its nodes: use --set node.param=value`);
}

/** The flags of a lens, without those that it does not have. */
function lensFlags(panorama: PanoramicLens): Partial<RenderFlags> {
  const { lens, aperture, domeTilt, eyeSeparation } = choiceOf(panorama);
  return {
    lens,
    ...(panorama.kind === 'fisheye' && { aperture }),
    ...(lens === 'dome' && { domeTilt }),
    ...(lens === 'stereo' && { eyeSeparation }),
  };
}

function flagsOf(picture: PictureSpec, film: boolean): Partial<RenderFlags> {
  const { speedOfLight, camera, smooth, fovY, panorama, falseColor, occlusion } = picture;
  const beta = initialBeta(picture, film);
  return {
    ...pickSettings(SETTING_NAMES, picture),
    cameraPath: smooth ? 'smooth' : 'straight',
    ...(!occlusion && { occlusionRadius: 0 }),
    c: speedOfLight,
    ...(camera && { camera }),
    ...(beta && { beta }),
    ...(panorama ? lensFlags(panorama) : fovY !== undefined && { fov: degrees(fovY) }),
    ...(falseColor !== 'none' && { falseColour: falseColor }),
  };
}
