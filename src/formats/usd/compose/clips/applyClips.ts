import type { AttributeSpec, PrimSpec, TimeSamples, Value } from '../../layer/layer.ts';
import { withEntry } from '../../layer/layer.ts';
import { hasPrefix, stripVariants } from '../../layer/primPaths.ts';
import { type PrimIndexNode, strongestFirst } from '../primIndex/primIndexNode.ts';
import { type ClipSet, clipValue, primIn, sampledIn, timesOf } from './clipSet.ts';

/** Schema attributes, which clips can set without a declaration. */
const BUILT_IN = new Set(
  'points normals velocities accelerations extent visibility faceVertexCounts faceVertexIndices widths radius height size'.split(
    ' ',
  ),
);

/** A clip set and its strength: the number of stronger opinions. */
interface AppliedClipSet {
  readonly set: ClipSet;
  /** The prim in the clips. */
  readonly path: string;
  readonly after: number;
}

/** Remaining samples: a few entries of `times` can request any number. */
export interface ClipBudget {
  samples: number;
}

/**
 * Applies the clip sets of a prim and its ancestors: weaker than the anchoring layer's own values, stronger than
 * weaker layers. False when the budget is exhausted.
 */
export function applyClips(
  prim: PrimSpec,
  index: PrimIndexNode,
  sets: readonly ClipSet[],
  budget: ClipBudget,
): boolean {
  const animated = placesOfAnimation(index);
  const decided = new Set<string>();
  for (const { set, path, after } of appliedTo(index, sets)) {
    for (const [name, declared] of attributesIn(set, path)) {
      if (decided.has(name) || (animated.get(name) ?? Infinity) < after) continue;
      const property = prim.properties.get(name);
      if (property ? property.kind !== 'attribute' : !BUILT_IN.has(name)) continue;
      decided.add(name);
      const timeSamples = clipSamples(set, path, name, declared, budget);
      if (!timeSamples) return false;
      const { spline: _, ...base } = (property ?? declaration(declared)) as AttributeSpec;
      prim.properties = withEntry(prim.properties, name, { ...base, timeSamples });
      // With clips the content is not shared with prims of equal opinions.
      if (decided.size === 1) prim.content = `${prim.content ?? ''} clips of ${prim.path}`;
    }
  }
  return true;
}

const declaration = ({ kind, name, typeName, custom, uniform, metadata }: AttributeSpec): AttributeSpec => {
  return { kind, name, typeName, custom, uniform, metadata };
};

/** Per attribute: index of the strongest opinion with animation. */
function placesOfAnimation(index: PrimIndexNode): ReadonlyMap<string, number> {
  const places = new Map<string, number>();
  let place = 0;
  for (const node of strongestFirst(index)) {
    if (!node.contributes) continue;
    for (const { spec } of node.opinions) {
      for (const property of spec.properties.values()) {
        if (property.kind !== 'attribute' || places.has(property.name)) continue;
        const { value, timeSamples, spline } = property;
        if (value || (timeSamples && timeSamples.times.length > 0) || spline) places.set(property.name, place);
      }
      place++;
    }
  }
  return places;
}

function appliedTo(index: PrimIndexNode, sets: readonly ClipSet[]): AppliedClipSet[] {
  const out: AppliedClipSet[] = [];
  let place = 0;
  for (const node of strongestFirst(index)) {
    if (node.isInert) continue;
    const here = sets.filter(({ definition: d }) => d.stack === node.stack && hasPrefix(node.path, d.path));
    for (const layer of here.length > 0 ? node.stack.layers : []) {
      const spoken = node.opinions.filter(
        ({ from }) => node.stack.layers.indexOf(from) <= node.stack.layers.indexOf(layer),
      );
      for (const set of here)
        if (set.definition.from === layer)
          out.push({
            set,
            path: set.primPath + stripVariants(node.path.slice(set.definition.path.length)),
            after: place + spoken.length,
          });
    }
    place += node.opinions.length;
  }
  return out;
}

/** Attributes that the manifest declares as varying; without one, all with samples in any clip. */
function attributesIn({ manifest, clips }: ClipSet, path: string): Map<string, AttributeSpec> {
  const found = new Map<string, AttributeSpec>();
  for (const layer of manifest ? [manifest] : new Set(clips.map((clip) => clip.layer)))
    for (const property of primIn(layer, path)?.properties.values() ?? [])
      if (property.kind === 'attribute' && !property.uniform && (manifest || property.timeSamples))
        if (!found.has(property.name)) found.set(property.name, property);
  return found;
}

/** Samples of all clips in sequence; undefined above the limit. */
function clipSamples(
  set: ClipSet,
  path: string,
  name: string,
  declared: AttributeSpec,
  budget: ClipBudget,
): TimeSamples | undefined {
  const missing = (set.manifest && declared.value) ?? BLOCKED;
  const all = new Map<number, Value>();
  for (const clip of set.clips) {
    const sampled = sampledIn(primIn(clip.layer, path), name);
    if (!sampled && set.skipsMissing) continue;
    const times = timesOf(clip, sampled, set.times, budget.samples);
    budget.samples -= times.length;
    if (budget.samples < 0) return undefined;
    for (const time of times) {
      const value = sampled ? (clipValue(sampled, set.times, time) ?? BLOCKED) : missing;
      all.set(time, withAnchor(value, clip.layer?.id));
    }
  }
  if (all.size === 0) all.set(set.clips[0].start, missing);
  const times = Float64Array.from(all.keys()).sort();
  return { times, values: Array.from(times, (time) => all.get(time)!) };
}

const BLOCKED: Value = { type: 'blocked' };

/** Asset paths in clips are relative to the clip. */
const withAnchor = (value: Value, anchor: string | undefined): Value =>
  anchor !== undefined && (value.type === 'asset' || value.type === 'asset[]') ? { ...value, anchor } : value;
