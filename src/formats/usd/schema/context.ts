import type { SamplingBudget } from '../../../scene/motion/adaptiveSampling.ts';
import type { DiagnosticList } from '../../diagnostics/diagnosticLog.ts';
import type { AssetFiles } from '../assets/assetFiles.ts';
import { boolAt } from '../layer/attributes.ts';
import type { Layer, PrimSpec } from '../layer/layer.ts';
import { metadataText } from '../layer/query.ts';
import type { SampleBudget } from './sampleBudget.ts';

/** One stage while it is read: what its parts need to know, and what they have to say about the file. */
export interface StageContext {
  /** The composed stage. */
  readonly layer: Layer;
  /** Where textures come from. */
  readonly files: AssetFiles;
  /** Metres in one unit of the file. */
  readonly unit: number;
  readonly codesPerSecond: number;
  /** The time code at which what cannot change with time is read. */
  readonly startCode: number;
  /** Greatest distance between a resampled path and the true one, as a fraction of the object's greatest size. */
  readonly chordTolerance: number;
  /** Along cubics between samples. */
  readonly cubic: boolean;
  /** The same of what bends, which has every vertex at every sample. */
  readonly bendTolerance: number;
  readonly diagnostics: DiagnosticList;
  /** Memory that is left for the points of deforming meshes. */
  readonly pointBudget: { bytes: number };
  /** Times that are left at which things can be placed. */
  readonly sampleBudget: SampleBudget;
  /** How much of it is taken before meshes whose samples can stay in their file are left there. */
  readonly sampleMemory: { bytes: number };
  /** Told the part of a mesh's samples that is read. */
  readonly progress: (part: number) => void;
  /** Work that is left for the paths between samples. */
  readonly motionBudget: SamplingBudget;
  /** Levels that are wanted, and of each mesh those that there are faces for, once they are known. */
  readonly subdivision: { readonly wanted?: number; levels?: SubdivisionLevels };
  /** Paths of the subdivision surfaces that are drawn as their polygons because no levels are wanted. */
  readonly subdivided: string[];
}

/** Whether an attribute says `true` at the stage's start. */
export const isTrue = (context: StageContext, prim: PrimSpec, name: string): boolean =>
  boolAt(prim, name, context.startCode) === true;

/** The layer's up axis; USD's own fallback is Y. */
export const upAxisOf = (context: Pick<StageContext, 'layer'>): 'Y' | 'Z' =>
  metadataText(context.layer.metadata, 'upAxis') === 'Z' ? 'Z' : 'Y';

/** How often each mesh of a stage is subdivided, and would be alone. */
export type SubdivisionLevels = ReadonlyMap<string, { readonly levels: number; readonly wanted: number }>;
