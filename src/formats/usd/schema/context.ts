import type { SamplingBudget } from '../../../scene/motion/adaptiveSampling.ts';
import type { DiagnosticList } from '../../diagnostics/diagnosticLog.ts';
import type { AssetFiles } from '../assets/assetFiles.ts';
import { boolAt } from '../layer/attributes.ts';
import type { Layer, PrimSpec } from '../layer/layer.ts';
import { metadataText } from '../layer/query.ts';
import type { SampleBudget } from './sampleBudget.ts';

/** Context of reading one stage: inputs, budgets, diagnostics. */
export interface StageContext {
  /** The composed stage. */
  readonly layer: Layer;
  /** Source of textures. */
  readonly files: AssetFiles;
  /** Path of the only prim that is read, with everything below it. */
  readonly prim?: string;
  /** Metres per stage unit. */
  readonly unit: number;
  readonly codesPerSecond: number;
  /** Time code at which static values are read. */
  readonly startCode: number;
  /** Maximum error of resampled paths, relative to the object's largest extent. */
  readonly chordTolerance: number;
  /** Cubic interpolation between samples. */
  readonly cubic: boolean;
  /** The same for deforming meshes, which store every vertex per sample. */
  readonly bendTolerance: number;
  readonly diagnostics: DiagnosticList;
  /** Remaining memory for the points of deforming meshes. */
  readonly pointBudget: { bytes: number };
  /** Remaining transform samples. */
  readonly sampleBudget: SampleBudget;
  /** Memory used before meshes are streamed from disk. */
  readonly sampleMemory: { bytes: number };
  /** Called with the fraction of a mesh's samples read. */
  readonly progress: (part: number) => void;
  /** Remaining work for adaptive sampling. */
  readonly motionBudget: SamplingBudget;
  /** Requested subdivision levels, and per mesh those within the face budget, once known. */
  readonly subdivision: { readonly wanted?: number; levels?: Promise<SubdivisionLevels> };
  /** Paths of subdivision surfaces loaded as polygons because no levels are requested. */
  readonly subdivided: string[];
  /** By path of subdivision surfaces that look smooth with fewer levels than others get: these levels. */
  readonly smooth: Map<string, number>;
}

/** Whether an attribute is `true` at the stage's start. */
export const isTrue = (context: StageContext, prim: PrimSpec, name: string): boolean =>
  boolAt(prim, name, context.startCode) === true;

/** The layer's up axis; USD's fallback is Y. */
export const upAxisOf = (context: Pick<StageContext, 'layer'>): 'Y' | 'Z' =>
  metadataText(context.layer.metadata, 'upAxis') === 'Z' ? 'Z' : 'Y';

/** How a mesh is subdivided. */
export interface MeshLevels {
  readonly levels: number;
  /** Without the budget. */
  readonly wanted: number;
  /** Set if more levels would be seen, but hardly. */
  readonly fewer?: true;
}

/** By path of the mesh. */
export type SubdivisionLevels = ReadonlyMap<string, MeshLevels>;
