import type { SamplingBudget } from '../../../scene/motion/adaptiveSampling.ts';
import type { Diagnostic } from '../../../scene/types.ts';
import type { DiagnosticCode } from '../../diagnostics/diagnosticCodes.ts';
import type { DiagnosticList } from '../../diagnostics/diagnosticLog.ts';
import type { AssetFiles } from '../assets/assetFiles.ts';
import { boolAt } from '../layer/attributes.ts';
import type { Layer, MetadataValue, PrimSpec } from '../layer/layer.ts';
import { splitProperty } from '../layer/paths.ts';
import type { SubdivisionLevels } from './geometry/subdivision.ts';
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

/** Says something about a prim; about the layer where `path` is empty. */
export function report(
  context: Pick<StageContext, 'layer' | 'diagnostics'>,
  severity: Diagnostic['severity'],
  code: DiagnosticCode,
  path: string,
  message: string,
  more: Partial<Omit<Diagnostic, 'code'>> = {},
): void {
  const { name } = context.layer;
  context.diagnostics.add({ severity, code, place: path === '' ? name : `${name}<${path}>`, message, ...more }, name);
}

/** The prim at an absolute path. */
export function primAt(layer: Layer, path: string): PrimSpec | undefined {
  const names = path.split('/').filter(Boolean);
  let prim = layer.rootPrims.get(names[0] ?? '');
  for (const name of names.slice(1)) prim = prim?.children.get(name);
  return prim;
}

/** The prims along a path, from the root down, as far as they are there. */
export function primsAlong(layer: Layer, path: string): PrimSpec[] {
  const found: PrimSpec[] = [];
  let { rootPrims: children } = layer;
  for (const name of path.split('/').filter(Boolean)) {
    const prim = children.get(name);
    if (!prim) break;
    found.push(prim);
    children = prim.children;
  }
  return found;
}

/** The prims above a path, from the root down. */
export const ancestorsOf = (layer: Layer, path: string): PrimSpec[] =>
  primsAlong(layer, path.slice(0, path.lastIndexOf('/')));

/** Targets of a relationship, or sources of a connection, once its list op is applied to nothing. */
export function targetsOf(prim: PrimSpec, name: string): readonly string[] {
  const property = prim.properties.get(name);
  const op = property?.kind === 'relationship' ? property.targets : property?.connections;
  if (!op) return [];
  return op.explicit ?? [...(op.prepended ?? []), ...(op.added ?? []), ...(op.appended ?? [])];
}

/** The prim and the property that a connection or a relationship to a property leads to. */
export function propertyAt(layer: Layer, path: string): readonly [PrimSpec, string] | undefined {
  const [primPath, property] = splitProperty(path);
  const prim = primAt(layer, primPath);
  return prim && property !== '' ? [prim, property] : undefined;
}

export function metadataNumber(metadata: ReadonlyMap<string, MetadataValue>, key: string): number | undefined {
  const value = metadata.get(key);
  return value && 'data' in value && typeof value.data === 'number' ? value.data : undefined;
}

export function metadataText(metadata: ReadonlyMap<string, MetadataValue>, key: string): string | undefined {
  const value = metadata.get(key);
  return value && 'data' in value && typeof value.data === 'string' ? value.data : undefined;
}

/** Whether an attribute says `true` at the stage's start. */
export const isTrue = (context: StageContext, prim: PrimSpec, name: string): boolean =>
  boolAt(prim, name, context.startCode) === true;

/** The layer's up axis; USD's own fallback is Y. */
export const upAxisOf = (context: Pick<StageContext, 'layer'>): 'Y' | 'Z' =>
  metadataText(context.layer.metadata, 'upAxis') === 'Z' ? 'Z' : 'Y';
