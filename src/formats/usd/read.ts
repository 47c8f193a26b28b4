import type { Scene } from '../../scene/types.ts';
import { inputError } from '../fail.ts';
import type { ReadOptions } from '../registry.ts';
import { type FileSource, resolvePath } from '../source.ts';
import { DiagnosticList, metadataNumber, report, type StageContext } from './context.ts';
import { noteUnreadLayers } from './coverage.ts';
import type { Layer } from './layer.ts';
import { readLayer } from './readLayer.ts';
import { hintsOf } from './slowlight.ts';
import { readStage, type StageContents, upAxisOf } from './stage.ts';
import { isZip, openPackage } from './usdz.ts';

/** Distance between a resampled path and the true one, as a fraction of the object's size, where none is asked for. */
const CHORD_TOLERANCE = 1e-4;

/** For all deforming meshes of a scene together [bytes]: a small file can ask for any number of samples of a large mesh. */
const POINT_BUDGET = 2 ** 30;

/**
 * Reads a USD layer, text or binary, or a package that holds one, as a scene. What it says and is not read is in the scene's
 * diagnostics. Throws an InputError where the file is not readable at all.
 */
export async function readUsd(files: FileSource, entry: string, options: ReadOptions = {}): Promise<Scene> {
  const bytes = await files.read(entry);
  if (!bytes) throw inputError('file.missing', entry, 'no such file');
  const { layer, source } = openLayer(files, entry, bytes);
  const context = contextOf(layer, source, options);
  noteUnreadLayers(context);
  const contents = await readStage(context);
  noteSubdivision(context);
  return {
    ...sceneHeader(context, entry),
    ...timeRange(context, contents),
    ...contents,
    diagnostics: context.diagnostics.list,
  };
}

function openLayer(files: FileSource, entry: string, bytes: Uint8Array): { layer: Layer; source: FileSource } {
  if (!isZip(bytes)) return { layer: readLayer(bytes, entry), source: files };
  const contents = openPackage(bytes, entry);
  // Within a package, paths are relative to its root; the layer's name tells both.
  const prefix = `${entry}/`;
  const source: FileSource = {
    read: async (path) => (path.startsWith(prefix) ? contents.files.get(path.slice(prefix.length)) : files.read(path)),
  };
  return { layer: readLayer(contents.files.get(contents.layer)!, resolvePath(prefix, contents.layer)), source };
}

function contextOf(layer: Layer, source: FileSource, options: ReadOptions): StageContext {
  const number = (key: string): number | undefined => metadataNumber(layer.metadata, key);
  const context: StageContext = {
    layer,
    source,
    unit: number('metersPerUnit') ?? 0.01,
    codesPerSecond: number('timeCodesPerSecond') ?? number('framesPerSecond') ?? 24,
    startCode: number('startTimeCode') ?? 0,
    chordTolerance: options.chordTolerance ?? CHORD_TOLERANCE,
    diagnostics: new DiagnosticList(),
    pointBudget: { bytes: POINT_BUDGET },
    subdivided: [],
  };
  for (const key of ['unit', 'codesPerSecond'] as const) {
    const value = context[key];
    if (value > 0 && Number.isFinite(value)) continue;
    const name = key === 'unit' ? 'metersPerUnit' : 'timeCodesPerSecond';
    throw inputError('usd.metadata', layer.name, `${name} = ${value} is not a positive number`);
  }
  if (!layer.metadata.has('metersPerUnit'))
    report(context, 'info', 'usd.units', '', 'metersPerUnit is not written; one unit is taken as 1 cm, as USD says');
  return context;
}

function sceneHeader(context: StageContext, entry: string) {
  return {
    name: entry.slice(entry.lastIndexOf('/') + 1),
    upAxis: upAxisOf(context),
    metersPerUnit: context.unit,
    timeCodesPerSecond: context.codesPerSecond,
    hints: hintsOf(context.layer),
  };
}

/** As written, else what the samples span [s]. */
function timeRange(context: StageContext, { objects, cameras }: StageContents) {
  const start = metadataNumber(context.layer.metadata, 'startTimeCode');
  const end = metadataNumber(context.layer.metadata, 'endTimeCode');
  let [first, last] = [Infinity, -Infinity];
  for (const { motion } of [...objects, ...cameras]) {
    if (!('times' in motion)) continue;
    first = Math.min(first, motion.times[0]);
    last = Math.max(last, motion.times[motion.times.length - 1]);
  }
  const startTime = start !== undefined ? start / context.codesPerSecond : Number.isFinite(first) ? first : 0;
  const endTime = end !== undefined ? end / context.codesPerSecond : Math.max(startTime, last);
  return { startTime, endTime: Math.max(startTime, endTime) };
}

function noteSubdivision(context: StageContext): void {
  const [first, ...rest] = context.subdivided;
  if (first === undefined) return;
  const who = rest.length > 0 ? `${rest.length + 1} meshes (the first is ${first}) are` : `${first} is`;
  const message = `${who} meant as subdivision surface; it is drawn as its polygons`;
  report(context, 'info', 'usd.subdivision', '', message);
}
