import {
  fromParts,
  IDENTITY,
  linearPart,
  type Mat4,
  multiply,
  transformPoint,
  transformVector,
} from '../../math/mat4.ts';
import { matrixOfParts, mixParts, type TransformParts } from '../../math/transformParts.ts';
import { length } from '../../math/vec3.ts';
import { boundingBox, boxRadius } from '../../scene/bounds/bounds.ts';
import { pointSamples } from '../../scene/motion/motion.ts';
import {
  type BlendedPoints,
  type JointTree,
  makeBlendedPoints,
  matrixAt,
  shapeWeightsAt,
} from '../../scene/streaming/blendedPoints.ts';
import { isBlended } from '../../scene/streaming/samplePoints.ts';
import type { SceneObject } from '../../scene/types.ts';
import { depthsOf, distanceOf, jointTracks, keptKeys, parentsFirst } from './jointTracks.ts';

/** Greatest distance between what is kept and what keys give, relative to half the diagonal of all that a skeleton moves: a tenth of what reading may be off. */
export const KEY_TOLERANCE = 1e-4;

/** A mesh that follows the joints of a skeleton. */
export interface WrittenSkin<T extends SceneObject = SceneObject> {
  readonly object: T;
  readonly points: BlendedPoints;
  /** By joint of the skeleton the matrix from the rest shape to the joint's axes; undefined for those that it does not follow. */
  readonly binds: readonly (Mat4 | undefined)[];
  /** Samples whose weights of blend shapes are kept. */
  readonly shapeKeys: readonly number[];
}

/** Joints with all meshes that follow them, as formats have them: translations, rotations and scales at keys. */
export interface WrittenSkeleton<T extends SceneObject = SceneObject> {
  readonly tree: JointTree;
  /** Of the samples [s]. */
  readonly times: Float64Array;
  /** By joint and sample, in the axes of its parent. */
  readonly tracks: readonly (readonly TransformParts[])[];
  /** The samples of a joint that are kept, in the order of time. */
  keysOf(joint: number): readonly number[];
  /** The samples to keep where all joints have the same. */
  commonKeys(): readonly number[];
  /** From the joints' axes to the world. */
  readonly placement: Mat4;
  /** By sample 3 numbers: translation after that [m]; absent if there is none. */
  readonly shifts?: Float64Array;
  readonly skins: readonly WrittenSkin<T>[];
}

/** Objects of which some follow joints. */
export interface SkeletonsAndOthers<T extends SceneObject> {
  readonly skeletons: readonly WrittenSkeleton<T>[];
  readonly others: readonly T[];
}

/**
 * Gathers the objects that follow joints by their skeletons. Those whose joints shear, which no format has, are among the others, as are all for which
 * `isWritable` is false.
 */
export function skeletonsOf<T extends SceneObject>(
  objects: readonly T[],
  isWritable: (skeleton: WrittenSkeleton<T>) => boolean = () => true,
): SkeletonsAndOthers<T> {
  const groups: SameJoints<T>[] = [];
  for (const object of objects) {
    const follower = followerOf(object);
    if (!follower) continue;
    const group = groups.find(([first]) => haveSameJoints(first, follower));
    if (group) group.push(follower);
    else groups.push([follower]);
  }
  const skeletons = groups.flatMap((group) => {
    const made = skeletonOf(group);
    return made && isWritable(made) ? [made] : [];
  });
  const placed = new Set(skeletons.flatMap(({ skins }) => skins.map(({ object }) => object)));
  return { skeletons, others: objects.filter((object) => !placed.has(object)) };
}

interface Follower<T extends SceneObject> {
  readonly object: T;
  readonly points: BlendedPoints;
  readonly times: Float64Array;
  readonly placement: Mat4;
}
type SameJoints<T extends SceneObject> = [Follower<T>, ...Follower<T>[]];

function followerOf<T extends SceneObject>(object: T): Follower<T> | undefined {
  const samples = pointSamples(object.motion);
  if (!samples || !isBlended(samples.points)) return undefined;
  const { points, times, origin } = samples;
  if (points.rest.positions.length !== object.mesh.positions.length) return undefined;
  return { object, points, times, placement: multiply(fromParts([1, 0, 0, 0, 1, 0, 0, 0, 1], origin), points.outer) };
}

function haveSameJoints<T extends SceneObject>(a: Follower<T>, b: Follower<T>): boolean {
  return (
    a.points.poses === b.points.poses &&
    areEqual(a.times, b.times) &&
    areEqual(a.points.nodes, b.points.nodes) &&
    areEqual(a.points.shifts ?? [], b.points.shifts ?? []) &&
    areClose(a.placement, b.placement)
  );
}

const areEqual = (a: ArrayLike<number>, b: ArrayLike<number>): boolean =>
  a === b || (a.length === b.length && Array.prototype.every.call(a, (x, i) => x === b[i]));

/** Relative to the largest number: equal matrices that were calculated along different ways. */
const ROUNDED = 1e-9;

export function areClose(a: Mat4, b: Mat4, tolerance = ROUNDED): boolean {
  const size = Math.max(...a.map(Math.abs), ...b.map(Math.abs));
  return a.every((x, i) => Math.abs(x - b[i]) <= tolerance * size);
}

function skeletonOf<T extends SceneObject>(group: SameJoints<T>): WrittenSkeleton<T> | undefined {
  const [{ points, times, placement }] = group;
  const { poses, nodes, shifts } = points;
  const last = poses.joints - 1;
  const isWhole = group.every((each) => !each.points.joints.includes(last));
  const tree = isWhole ? poses.tree : withOrigin(poses.tree);
  const { parents } = tree;
  const frameOf = (j: number, k: number): Mat4 => matrixAt(poses.matrices, poses.joints * nodes[k] + j);
  const tolerance = KEY_TOLERANCE * radiusOf(group);
  const binds = group.map((each) => bindsOf(each.points, parents.length));
  const reaches = Float64Array.from(parents, (_, j) => Math.max(...group.map(({ points: own }) => reachOf(own, j))));
  const tracks = jointTracks({ parents, samples: times.length, frameOf, reaches, tolerance });
  if (!tracks) return undefined;
  const isClose = closeness({ tracks, parents, times, reaches, tolerance });
  return {
    tree,
    times,
    tracks,
    keysOf: (joint) => keptKeys(times.length, (from, to) => isClose(joint, from, to)),
    commonKeys: () => keptKeys(times.length, (from, to) => tracks.every((_, j) => isClose(j, from, to))),
    placement,
    ...(shifts && { shifts }),
    skins: group.map(({ object, points: own }, i) => ({
      object,
      points: own,
      binds: binds[i],
      shapeKeys: shapeKeysOf(own, times),
    })),
  };
}

/** With the joint without extent at which the rest of incomplete weights is. */
const withOrigin = ({ names, parents }: JointTree): JointTree => ({
  names: [...names, 'Origin'],
  parents: [...Array.from(parents), -1],
});

function bindsOf({ joints, binds }: BlendedPoints, count: number): (Mat4 | undefined)[] {
  const out = new Array<Mat4 | undefined>(count).fill(undefined);
  joints.forEach((joint, i) => {
    out[joint] = matrixAt(binds, i);
  });
  return out;
}

/** A joint's frame at the first sample. */
export function frameAtStart(tracks: WrittenSkeleton['tracks'], parents: ArrayLike<number>, joint: number): Mat4 {
  let frame = IDENTITY;
  for (let j = joint; j >= 0; j = parents[j]) frame = multiply(matrixOfParts(tracks[j][0]), frame);
  return frame;
}

/** Half the diagonal of all that follows the joints, at the first sample and in their axes. */
function radiusOf<T extends SceneObject>(group: SameJoints<T>): number {
  const ends = group.flatMap(({ points: { shifts: _, ...points } }) => {
    const box = boundingBox(makeBlendedPoints({ ...points, outer: IDENTITY }, 0));
    return box ? [...box.min, ...box.max] : [];
  });
  return boxRadius(ends);
}

/** A bound of how far from a joint's origin is what follows it, in its axes: by the corners of the box of its vertices and of their displacements. */
function reachOf({ joints, binds, boxes, shapes, shapeWeights }: BlendedPoints, joint: number): number {
  const i = joints.indexOf(joint);
  if (i < 0) return 0;
  const m = matrixAt(binds, i);
  const box = (s: number): Float64Array =>
    boxes.subarray(6 * (i * (1 + shapes.length) + s), 6 * (i * (1 + shapes.length) + s + 1));
  const extent = (own: Float64Array): number => Math.hypot(...own.subarray(3)) * frobenius(m);
  const [x, y, z] = box(0);
  let reach = length(transformPoint(m, [x, y, z])) + extent(box(0));
  for (let s = 0; s < shapes.length; s++) {
    let weight = 0;
    for (let k = s; k < shapeWeights.length; k += shapes.length) weight = Math.max(weight, Math.abs(shapeWeights[k]));
    const [dx, dy, dz] = box(1 + s);
    reach += weight * (length(transformVector(m, [dx, dy, dz])) + extent(box(1 + s)));
  }
  return reach;
}

/** A bound of how much a matrix stretches. */
const frobenius = (m: Mat4): number => Math.hypot(...linearPart(m));

interface FollowedTracks {
  readonly tracks: WrittenSkeleton['tracks'];
  readonly parents: ArrayLike<number>;
  readonly times: Float64Array;
  /** By joint, of what follows it itself. */
  readonly reaches: Float64Array;
  readonly tolerance: number;
}

/**
 * Whether between two samples of a joint all others are close enough to what is interpolated. Every joint of a chain may be off by the same part of the
 * tolerance at the farthest place of all that is below it.
 */
function closeness({ tracks, parents, times, reaches, tolerance }: FollowedTracks) {
  const order = parentsFirst(parents);
  const most = (values: readonly number[]): number => values.reduce((a, b) => Math.max(a, b), 0);
  const stretches = tracks.map((track) => most(track.map(({ scale }) => Math.max(...scale.map(Math.abs)))));
  // From the root down, how much all above stretch; from the ends up, how far all below reaches.
  const above = new Float64Array(parents.length).fill(1);
  for (const j of order) if (parents[j] >= 0) above[j] = above[parents[j]] * stretches[parents[j]];
  const below = reaches.slice();
  for (const j of [...order].reverse()) {
    const parent = parents[j];
    if (parent < 0) continue;
    const offset = most(tracks[j].map(({ translation }) => length(translation)));
    below[parent] = Math.max(below[parent], offset + stretches[j] * below[j]);
  }
  const share = tolerance / (1 + most(depthsOf(parents)));
  return (joint: number, from: number, to: number): boolean => {
    const track = tracks[joint];
    for (let k = from + 1; k < to; k++) {
      const mixed = mixParts(track[from], track[to], (times[k] - times[from]) / (times[to] - times[from]));
      const off = distanceOf(matrixOfParts(mixed), matrixOfParts(track[k]), below[joint]);
      if (!(off * above[joint] <= share)) return false;
    }
    return true;
  };
}

/** The samples whose weights are kept: between them no vertex is off by more than the tolerance for shapes of this size. */
function shapeKeysOf(points: BlendedPoints, times: Float64Array): readonly number[] {
  const { rest, shapes } = points;
  if (shapes.length === 0) return [0];
  const tolerance = KEY_TOLERANCE * boxRadius(rest.positions);
  const sizes = shapes.map(({ positions }) => longest(positions));
  return keptKeys(times.length, (from, to) => {
    const [first, last] = [shapeWeightsAt(points, from), shapeWeightsAt(points, to)];
    for (let k = from + 1; k < to; k++) {
      const at = (times[k] - times[from]) / (times[to] - times[from]);
      const own = shapeWeightsAt(points, k);
      const off = sizes.reduce(
        (sum, size, s) => sum + size * Math.abs(first[s] + at * (last[s] - first[s]) - own[s]),
        0,
      );
      if (!(off <= tolerance)) return false;
    }
    return true;
  });
}

function longest(vectors: Float32Array): number {
  let most = 0;
  for (let i = 0; i < vectors.length; i += 3)
    most = Math.max(most, Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]));
  return most;
}

/** Joints and weights by vertex, equally many for each. */
export interface VertexInfluences {
  readonly perVertex: number;
  /** Of the skeleton; 0 where there is no weight. */
  readonly joints: Uint16Array<ArrayBuffer>;
  readonly weights: Float32Array<ArrayBuffer>;
}

/** The influences of all vertices, a multiple of `multiple` for each, those without weight at the end. `heaviestFirst`: else in their order. */
export function vertexInfluences(
  { joints, first, influences, weights }: BlendedPoints,
  multiple = 1,
  heaviestFirst = false,
): VertexInfluences {
  const vertices = first.length - 1;
  let most = 1;
  for (let v = 0; v < vertices; v++) most = Math.max(most, first[v + 1] - first[v]);
  const perVertex = multiple * Math.ceil(most / multiple);
  const size = perVertex * vertices;
  const out = { perVertex, joints: new Uint16Array(size), weights: new Float32Array(size) };
  for (let v = 0; v < vertices; v++) {
    const own = Array.from({ length: first[v + 1] - first[v] }, (_, i) => first[v] + i);
    if (heaviestFirst) own.sort((a, b) => weights[b] - weights[a]);
    own.forEach((i, n) => {
      if (weights[i] === 0) return;
      out.joints[perVertex * v + n] = joints[influences[i]];
      out.weights[perVertex * v + n] = weights[i];
    });
  }
  return out;
}
