import { listed, type Message, msg } from '../../messages/message.ts';
import { FOREVER } from '../../scene/defaults.ts';
import { SamplingBudget } from '../../scene/motion/adaptiveSampling.ts';
import { sampleTimes } from '../../scene/motion/motion.ts';
import type { Lifetime, Motion, Scene } from '../../scene/types.ts';
import { DiagnosticList } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { FileSource } from '../files/fileSource.ts';
import type { ReadOptions } from '../readOptions.ts';
import { AssetFiles } from './assets/assetFiles.ts';
import { type ComposedStage, composeStage } from './compose/composeStage.ts';
import { LayerStore } from './compose/layers/layerStore.ts';
import type { VariantSelection } from './compose/sessionLayer.ts';
import { report } from './diagnostics.ts';
import type { Layer } from './layer/layer.ts';
import { metadataNumber, primAt, primsAlong, stageTimeCode } from './layer/query.ts';
import { layerParser } from './readLayer.ts';
import { type StageContext, upAxisOf } from './schema/context.ts';
import { saysDrawModes } from './schema/drawModes/saysDrawModes.ts';
import { SMOOTH_ROWS } from './schema/geometry/subdivisionScheme.ts';
import { SampleBudget } from './schema/sampleBudget.ts';
import { hintsOf } from './schema/slowlightAttributes.ts';
import { readStage, type StageContents } from './schema/stageReader.ts';

/** Distance between a resampled path and the true one, as a fraction of the object's greatest size, where none is asked for. */
export const CHORD_TOLERANCE = 1e-4;
export const BEND_TOLERANCE = 1e-3;

/** For all deforming meshes of a scene together [bytes]: a small file can ask for any number of samples of a large mesh. */
export const POINT_BUDGET = 2 ** 30;

export const MAX_SUBDIVISION_LEVELS = 8;

/** For the samples of deforming meshes that could as well stay in their file [bytes]. */
export const SAMPLE_MEMORY = 2 ** 28;
/** In a file a mesh takes at least such a part of what it takes in memory: three halves a point, not six floats. */
const MIN_STORED_RATIO = 4;

/** For the paths of all moving things together [ops]: about half a second. */
const MOTION_BUDGET = 2 ** 18;

/**
 * Reads the stage of a USD layer, or of a package, as a scene, with all layers that it is composed from. What it says
 * and is not read is in the scene's diagnostics. Throws an InputError where the file is not readable at all.
 */
export async function readUsd(source: FileSource, entry: string, options: ReadOptions = {}): Promise<Scene> {
  const diagnostics = new DiagnosticList();
  const sampleMemory = options.sampleMemory ?? SAMPLE_MEMORY;
  const files = new AssetFiles(source, entry, sampleMemory / MIN_STORED_RATIO);
  const content = await files.content(entry);
  if (!content) throw inputError('file.missing', entry, msg`no such file`);
  const store = new LayerStore(files, layerParser(files, diagnostics));
  const root = await store.root(entry, content);
  const stage = await composeStage(store, root, diagnostics, {
    variants: variantSelections(options.variants),
    fallbacks: options.variantFallbacks,
  });
  if (options.prim) assertPrim(stage.layer, options.prim, entry);
  const composed = contextOf(stage.layer, files, diagnostics, { ...options, sampleMemory });
  const context = saysDrawModes(composed.layer) ? await modelsDrawn(composed) : composed;
  const contents = await readStage(context);
  reportSubdivision(context);
  if (stage.missingArcs > 0 && contents.objects.length + contents.lights.length === 0)
    report(
      context,
      'error',
      'usd.empty-stage',
      '',
      msg`there is nothing to see: ${stage.missingArcs} references to layers that are not there, and nothing else; open the folder that holds them`,
    );
  const { error } = context.motionBudget;
  return {
    ...sceneHeader(context, entry),
    ...timeRange(context, contents),
    ...contents,
    diagnostics: diagnostics.list,
    ...variantsIn(stage),
    ...(error !== undefined && { pathError: error }),
  };
}

async function modelsDrawn(context: StageContext): Promise<StageContext> {
  const { withDrawModes } = await import('./schema/drawModes/drawModes.ts');
  return { ...context, layer: withDrawModes(context) };
}

function assertPrim(layer: Layer, path: string, entry: string): void {
  if (primAt(layer, path)) return;
  const above = primsAlong(layer, path).at(-1);
  const names = [...(above?.children ?? layer.rootPrims).keys()].slice(0, 8);
  const place = above?.path ?? '/';
  throw inputError(
    'prim.missing',
    entry,
    names.length > 0
      ? msg`there is no prim ${path}; below ${place} there is ${listed(names)}`
      : msg`there is no prim ${path}; ${place} has nothing below it`,
  );
}

/** `/World/Car{paint}` is how a scene calls the set `paint` of the prim `/World/Car`. */
function variantSelections(variants: ReadOptions['variants'] = new Map()): VariantSelection[] {
  return [...variants].map(([key, variant]) => {
    const [, path, set] = /^(.*)\{(.*)\}$/.exec(key) ?? ['', key, ''];
    return { path, set, variant };
  });
}

function variantsIn({ variantSets }: ComposedStage): Pick<Scene, 'variants'> {
  const variants = variantSets.map(({ path, set, variants: options, selected = '' }) => {
    return { set: `${path}{${set}}`, options, chosen: options.includes(selected) ? selected : '' };
  });
  return variants.length > 0 ? { variants } : {};
}

function contextOf(
  layer: Layer,
  files: AssetFiles,
  diagnostics: DiagnosticList,
  options: ReadOptions & { readonly sampleMemory: number },
): StageContext {
  const number = (key: string): number | undefined => metadataNumber(layer.metadata, key);
  const context: StageContext = {
    layer,
    files,
    unit: number('metersPerUnit') ?? 0.01,
    codesPerSecond: number('timeCodesPerSecond') ?? number('framesPerSecond') ?? 24,
    startCode: stageTimeCode(layer.metadata, 'start') ?? 0,
    cubic: options.interpolation === 'cubic',
    ...(options.prim && { prim: `/${options.prim.split('/').filter(Boolean).join('/')}` }),
    chordTolerance: options.chordTolerance ?? CHORD_TOLERANCE,
    bendTolerance: options.chordTolerance ?? BEND_TOLERANCE,
    diagnostics,
    pointBudget: { bytes: POINT_BUDGET },
    sampleBudget: new SampleBudget(layer),
    sampleMemory: { bytes: options.sampleMemory },
    progress: options.progress ?? (() => {}),
    motionBudget: new SamplingBudget(MOTION_BUDGET),
    subdivision: options.subdivision === undefined ? {} : { wanted: levelsWanted(options.subdivision) },
    subdivided: [],
    smooth: new Map(),
  };
  for (const key of ['unit', 'codesPerSecond'] as const) {
    const value = context[key];
    if (value > 0 && Number.isFinite(value)) continue;
    const name = key === 'unit' ? 'metersPerUnit' : 'timeCodesPerSecond';
    throw inputError('usd.metadata', layer.name, msg`${name} = ${value} is not a positive number`);
  }
  if (!layer.metadata.has('metersPerUnit'))
    report(context, 'info', 'usd.units', '', msg`metersPerUnit is not written; one unit is taken as 1 cm, as USD says`);
  return context;
}

/** Whole, and not so many that a single face would be more than a scene has. */
const levelsWanted = (levels: number): number => Math.max(0, Math.min(MAX_SUBDIVISION_LEVELS, Math.floor(levels) || 0));

function sceneHeader(context: StageContext, entry: string) {
  return {
    name: entry.slice(entry.lastIndexOf('/') + 1),
    upAxis: upAxisOf(context),
    metersPerUnit: context.unit,
    timeCodesPerSecond: context.codesPerSecond,
    hints: hintsOf(context.layer),
  };
}

/** As written, else what the samples span, and the times at which one piece follows another [s]. */
function timeRange(context: StageContext, { objects, cameras }: StageContents) {
  const start = stageTimeCode(context.layer.metadata, 'start');
  const end = stageTimeCode(context.layer.metadata, 'end');
  let [first, last] = [Infinity, -Infinity];
  const include = (time: number): void => {
    first = Math.min(first, time);
    last = Math.max(last, time);
  };
  const includeSamples = (motion: Motion, { birth, death }: Lifetime): void => {
    const times = sampleTimes(motion);
    if (!times) return;
    include(Math.max(birth, times[0]));
    include(Math.min(death, times[times.length - 1]));
  };
  for (const { motion } of cameras) includeSamples(motion, FOREVER);
  for (const { motion, pieceOf, lifetime } of objects) {
    includeSamples(motion, pieceOf === undefined ? FOREVER : lifetime);
    if (pieceOf !== undefined) [lifetime.birth, lifetime.death].filter(Number.isFinite).forEach(include);
  }
  const startTime = start !== undefined ? start / context.codesPerSecond : Number.isFinite(first) ? first : 0;
  const endTime = end !== undefined ? end / context.codesPerSecond : Math.max(startTime, last);
  return { startTime, endTime: Math.max(startTime, endTime) };
}

function reportSubdivision(context: StageContext): void {
  const tell = (message: Message): void => report(context, 'info', 'usd.subdivision', '', message);
  const [first, ...rest] = context.subdivided;
  if (rest.length > 0)
    tell(
      msg`${rest.length + 1} meshes (the first is ${first}) are meant as subdivision surface; it is drawn as its polygons`,
    );
  else if (first !== undefined) tell(msg`${first} is meant as subdivision surface; it is drawn as its polygons`);
  const [smooth] = context.smooth.keys();
  if (smooth === undefined) return;
  const most = Math.max(...context.smooth.values());
  tell(
    context.smooth.size > 1
      ? msg`${context.smooth.size} subdivision surfaces (the first is ${smooth}) are subdivided at most ${most} times: more would change about a pixel or less where one fills a picture of ${SMOOTH_ROWS} rows`
      : msg`${smooth} is subdivided ${most} times: more would change about a pixel or less where it fills a picture of ${SMOOTH_ROWS} rows`,
  );
}
