import { type Message, msg } from '../../../../messages/message.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numberOf, numbersAt, sampleTimes, tokensAt } from '../../layer/attributes.ts';
import type { AttributeSpec, NumberArray, PrimSpec } from '../../layer/layer.ts';
import { primAt, targetsOf } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';

/** The blend shapes of a mesh with their animated weights. */
export interface BlendShapes {
  /** Time codes between which the points are linear in time: of the weights' samples, and where a weight passes an inbetween. */
  readonly times: Float64Array;
  readonly cost: number;
  /** Every shape has normal offsets. */
  readonly haveNormals: boolean;
  /** The offsets of which those at any time are a sum: of shapes that ever have a weight, and of their inbetweens. */
  readonly parts: readonly ShapeOffsets[];
  /** A weight for each of `parts`. */
  partWeightsAt(time: number): Float64Array;
  /** Adds the offsets of points or normals at a time to `values`, 3 numbers for each of `points`, or for all points. */
  addTo(values: Float64Array, of: 'points' | 'normals', time: number, points?: ArrayLike<number>): void;
}

/** Offsets of points, 3 numbers each. */
export interface ShapeOffsets {
  readonly points: NumberArray;
  readonly normals: NumberArray | undefined;
  /** Index of each point's offset, −1 if none. Absent: point i has offset i. */
  readonly rows: Int32Array | undefined;
}

/** Offsets at one weight: the shape itself at 1, or an inbetween. */
interface SubShape {
  readonly weight: number;
  readonly points: NumberArray;
  readonly normals: NumberArray | undefined;
}
interface BlendShape {
  /** Index of its weight in the animation. */
  readonly source: number;
  readonly rows: ShapeOffsets['rows'];
  /** By increasing weight; null at 0. */
  readonly subShapes: readonly (SubShape | null)[];
  readonly weights: readonly number[];
}

/** Undefined if no weights affect the mesh. */
export function blendShapesOf(
  context: StageContext,
  mesh: PrimSpec,
  points: number,
  animation: PrimSpec | undefined,
): BlendShapes | undefined {
  const names = tokensAt(mesh, 'skel:blendShapes', undefined) ?? [];
  if (names.length === 0 || !animation) return undefined;
  const animated = tokensAt(animation, 'blendShapes', undefined) ?? [];
  const places = new Map(animated.map((name, i) => [name, i]));
  const targets = targetsOf(mesh, 'skel:blendShapeTargets');
  if (targets.length !== names.length) {
    const message = msg`skel:blendShapes has ${names.length} names for ${targets.length} skel:blendShapeTargets; its blend shapes are left out`;
    report(context, 'warning', 'usd.blend-shape', mesh.path, message);
    return undefined;
  }
  const shapes = names.flatMap((name, i) => {
    const source = places.get(name);
    return source === undefined ? [] : (shapeOf(context, mesh, targets[i], source, points) ?? []);
  });
  const weightsAt = (time: number): NumberArray | undefined => numbersAt(animation, 'blendShapeWeights', time);
  const steady = allFinite(context, animation, animated.length);
  if (shapes.length === 0 || !steady) return undefined;
  const samples = sampleTimes(attributeOf(animation, 'blendShapeWeights'));
  const used = shapesWithWeight(samples.length > 0 ? samples : [context.startCode], weightsAt);
  const shown = shapes.filter(({ source }) => used.has(source));
  return {
    times: unionOfTimes([samples, inbetweenTimes(shown, samples, weightsAt)]),
    cost: 1 + shapes.length,
    haveNormals: shapes.every((shape) => shape.subShapes.every((sub) => !sub || sub.normals)),
    addTo: (values, of, time, which) => {
      const weights = weightsAt(time);
      for (const shape of shapes) addShape(values, of, shape, weights?.[shape.source] ?? 0, which);
    },
    parts: shown.flatMap(({ subShapes, rows }) => subShapes.flatMap((sub) => (sub ? { ...sub, rows } : []))),
    partWeightsAt: (time) => {
      const weights = weightsAt(time);
      return Float64Array.from(
        shown.flatMap((shape) => {
          const shares = sharesOf(shape, weights?.[shape.source] ?? 0);
          return shape.subShapes.flatMap((sub, i) => (sub ? shares(i) : []));
        }),
      );
    },
  };
}

/** Most times at which weights pass inbetweens; where they do so more often, paths are followed as any others. */
const MAX_PASSES = 4096;

/** Times between samples at which a weight passes that of an inbetween. */
function inbetweenTimes(
  shapes: readonly BlendShape[],
  samples: Float64Array,
  weightsAt: (time: number) => NumberArray | undefined,
): Float64Array {
  const found: number[] = [];
  for (let k = 0; k + 1 < samples.length && found.length < MAX_PASSES; k++) {
    const [before, after] = [weightsAt(samples[k]), weightsAt(samples[k + 1])];
    for (const { source, weights } of shapes) {
      const [a, b] = [before?.[source] ?? 0, after?.[source] ?? 0];
      for (const w of weights.slice(1, -1))
        if ((w - a) * (w - b) < 0) found.push(samples[k] + ((w - a) / (b - a)) * (samples[k + 1] - samples[k]));
    }
  }
  return Float64Array.from(found).sort();
}

/** Indices of the weights that are not always 0. */
function shapesWithWeight(
  times: ArrayLike<number>,
  weightsAt: (time: number) => NumberArray | undefined,
): ReadonlySet<number> {
  const used = new Set<number>();
  for (let k = 0; k < times.length; k++)
    weightsAt(times[k])?.forEach((w, i) => {
      if (w !== 0) used.add(i);
    });
  return used;
}

function allFinite(context: StageContext, animation: PrimSpec, count: number): boolean {
  const attribute = attributeOf(animation, 'blendShapeWeights');
  const times = attribute?.timeSamples?.times ?? [];
  for (const time of times.length > 0 ? times : [context.startCode]) {
    const weights = numbersAt(animation, 'blendShapeWeights', time);
    if (weights?.length === count && weights.every(Number.isFinite)) continue;
    const message = msg`blendShapeWeights needs ${count} finite numbers, one for each of blendShapes; the shapes are left out`;
    report(context, 'warning', 'usd.blend-shape', animation.path, message);
    return false;
  }
  return true;
}

function shapeOf(
  context: StageContext,
  mesh: PrimSpec,
  path: string,
  source: number,
  points: number,
): BlendShape | undefined {
  const prim = primAt(context.layer, path);
  const fail = (message: Message): undefined => {
    report(context, 'warning', 'usd.blend-shape', path, msg`${message}; it does not bend ${mesh.path}`);
    return undefined;
  };
  if (prim?.typeName !== 'BlendShape') return fail(msg`there is no BlendShape`);
  const indices = numbersAt(prim, 'pointIndices', undefined);
  const count = indices?.length ?? points;
  const bad = indices?.findIndex((i) => !(i >= 0 && i < points)) ?? -1;
  if (bad >= 0) return fail(msg`pointIndices[${bad}] is ${indices![bad]} of ${points} points`);
  const full = subShape(prim, 'offsets', 'normalOffsets', 1, count);
  if ('template' in full) return fail(full);
  const inner: SubShape[] = [];
  for (const attribute of inbetweens(prim)) {
    const weight = numberOf(attribute.metadata.get('weight') as never);
    if (weight === undefined || weight === 0 || weight === 1 || !Number.isFinite(weight))
      return fail(msg`${attribute.name} needs a weight other than 0 and 1`);
    const sub = subShape(prim, attribute.name, `${attribute.name}:normalOffsets`, weight, count);
    if ('template' in sub) return fail(sub);
    inner.push(sub);
  }
  // `null`: sort puts undefined last.
  const all = [null, full, ...inner].sort((a, b) => (a?.weight ?? 0) - (b?.weight ?? 0));
  const weights = all.map((sub) => sub?.weight ?? 0);
  if (new Set(weights).size < weights.length) return fail(msg`two inbetweens have the same weight`);
  return { source, subShapes: all, weights, rows: indices && rowsOf(indices, points) };
}

const inbetweens = (prim: PrimSpec): AttributeSpec[] =>
  [...prim.properties.values()].filter(
    (p): p is AttributeSpec => p.kind === 'attribute' && /^inbetweens:[^:]+$/.test(p.name),
  );

function subShape(
  prim: PrimSpec,
  name: string,
  normalsName: string,
  weight: number,
  count: number,
): SubShape | Message {
  const points = numbersAt(prim, name, undefined);
  if (points?.length !== 3 * count)
    return msg`${name} has ${(points?.length ?? 0) / 3} offsets where ${count} are needed`;
  if (!points.every(Number.isFinite)) return msg`${name} holds what is no finite number`;
  const normals = numbersAt(prim, normalsName, undefined);
  return {
    weight,
    points,
    normals: normals?.length === points.length && normals.every(Number.isFinite) ? normals : undefined,
  };
}

function rowsOf(indices: NumberArray, points: number): Int32Array {
  const rows = new Int32Array(points).fill(-1);
  for (let i = 0; i < indices.length; i++) rows[indices[i]] = i;
  return rows;
}

/** By sub-shape its share at a weight: linear between those around it, extrapolated from the outermost two. */
function sharesOf({ weights }: BlendShape, weight: number): (subShape: number) => number {
  if (weight === 0) return () => 0;
  let upper = weights.findIndex((w) => w > weight);
  if (upper < 0) upper = weights.length - 1;
  if (upper === 0) upper = 1;
  const part = (weight - weights[upper - 1]) / (weights[upper] - weights[upper - 1]);
  return (i) => (i === upper ? part : i === upper - 1 ? 1 - part : 0);
}

function addShape(
  values: Float64Array,
  of: 'points' | 'normals',
  shape: BlendShape,
  weight: number,
  which: ArrayLike<number> | undefined,
): void {
  const { subShapes, rows } = shape;
  const shares = sharesOf(shape, weight);
  for (const [index, sub] of subShapes.entries()) {
    const offsets = sub?.[of];
    const fraction = shares(index);
    if (!offsets || fraction === 0) continue;
    for (let i = 0; i < values.length / 3; i++) {
      const point = which ? which[i] : i;
      const row = rows ? rows[point] : point;
      if (row >= 0) for (let k = 0; k < 3; k++) values[3 * i + k] += fraction * offsets[3 * row + k];
    }
  }
}
