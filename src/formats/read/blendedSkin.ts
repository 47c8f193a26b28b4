import { fromParts, IDENTITY, type Mat4 } from '../../math/mat4.ts';
import type { Vec3 } from '../../math/vec3.ts';
import {
  type BlendedPoints,
  type JointPoses,
  type JointTree,
  MATRIX,
  type RestShape,
} from '../../scene/streaming/blendedPoints.ts';
import type { SkinInfluences } from './skinning.ts';

/** A mesh that follows joints, at the nodes of a time grid. */
export interface SkinnedShape {
  readonly rest: RestShape;
  readonly shapes: readonly RestShape[];
  /** By node: a weight for each shape. */
  readonly shapeWeights: Float64Array;
  /** Absent: all vertices follow the first joint. */
  readonly skin?: SkinInfluences;
  /** By joint, from the rest shape to the joint's axes; absent: these are the same. */
  readonly binds?: readonly Mat4[];
  /** Made by `jointPoses`. */
  readonly poses: JointPoses;
  /** What the points will be relative to, world frame [m]. */
  readonly origin: Vec3;
}

/** Weights that differ less from 1 in total are rounded, not incomplete. */
const ROUNDED_WEIGHT = 1e-5;
/** Coordinates beyond this are not numbers that f32 can go on with [m]. */
const MAX_COORDINATE = 1e30;

/**
 * Joint matrices for `nodes` times, written by `write` at one of them, 12 numbers each. A joint without extent is added at the end, for what is missing from the
 * weights of vertices: at the world's origin unless it is written too.
 */
export function jointPoses(
  nodes: number,
  tree: JointTree,
  write: (node: number, out: Float64Array) => void,
): JointPoses {
  const joints = tree.names.length;
  const matrices = new Float64Array(MATRIX * (joints + 1) * nodes);
  for (let k = 0; k < nodes; k++) {
    const at = MATRIX * (joints + 1) * k;
    write(k, matrices.subarray(at, at + MATRIX * (joints + 1)));
  }
  return { tree, joints: joints + 1, matrices };
}

/** Of a mesh that moves as a whole: one frame. */
export const ONE_JOINT: JointTree = { names: ['Joint'], parents: [-1] };

/** The points of a skin at all nodes. Weights that do not add up to 1 leave the rest of a vertex at the world's origin, as a plain sum does. */
export function blendedSkin(shape: SkinnedShape): BlendedPoints {
  const { poses, rest, shapes, shapeWeights, origin } = shape;
  const nodes = Uint32Array.from({ length: poses.matrices.length / MATRIX / poses.joints }, (_, k) => k);
  const influences = influencesOf(shape);
  const points = {
    poses,
    nodes,
    outer: fromParts([1, 0, 0, 0, 1, 0, 0, 0, 1], [-origin[0], -origin[1], -origin[2]]),
    ...influences,
    rest,
    shapes,
    shapeWeights,
    boxes: jointBoxes(shape, influences),
  };
  const lost = nonFiniteVertices(points);
  return lost ? withoutVertices(points, lost) : points;
}

type Influences = Pick<BlendedPoints, 'joints' | 'binds' | 'first' | 'influences' | 'weights' | 'spread'>;

function influencesOf({ rest, skin, poses, binds }: SkinnedShape): Influences {
  const vertices = rest.positions.length / 3;
  const perPoint = skin?.perPoint ?? 1;
  const first = new Uint32Array(vertices + 1);
  const list = new Uint16Array(vertices * (perPoint + 1));
  const weights = new Float32Array(list.length);
  const places = new Map<number, number>();
  let [n, spread] = [0, 1];
  const add = (joint: number, weight: number): void => {
    const place = places.get(joint) ?? places.size;
    places.set(joint, place);
    list[n] = place;
    weights[n++] = weight;
  };
  for (let v = 0; v < vertices; v++) {
    let [sum, size] = [0, 0];
    for (let i = v * perPoint; i < (v + 1) * perPoint; i++) {
      const weight = skin ? skin.weights[i] : 1;
      if (weight === 0) continue;
      add(skin ? skin.joints[i] : 0, weight);
      sum += weight;
      size += Math.abs(weight);
    }
    const left = 1 - sum;
    if (Math.abs(left) > ROUNDED_WEIGHT) {
      add(poses.joints - 1, left);
      size += Math.abs(left);
    }
    spread = Math.max(spread, size);
    first[v + 1] = n;
  }
  return {
    joints: Uint16Array.from(places.keys()),
    binds: Float64Array.from([...places.keys()].flatMap((joint) => (binds?.[joint] ?? IDENTITY).slice(0, MATRIX))),
    first,
    influences: list.slice(0, n),
    weights: weights.slice(0, n),
    // Weights are rounded to f32.
    spread: spread > 1 + ROUNDED_WEIGHT ? spread : 1,
  };
}

/** See `BlendedPoints.boxes`. */
function jointBoxes({ rest, shapes }: SkinnedShape, { joints, first, influences }: Influences): Float64Array {
  const all = [rest, ...shapes];
  const boxes = new Float64Array(6 * all.length * joints.length);
  const [low, high] = [new Float64Array(3 * joints.length), new Float64Array(3 * joints.length)];
  all.forEach(({ positions }, s) => {
    low.fill(Number.POSITIVE_INFINITY);
    high.fill(Number.NEGATIVE_INFINITY);
    for (let v = 0; v + 1 < first.length; v++)
      for (let i = first[v]; i < first[v + 1]; i++)
        for (let axis = 0; axis < 3; axis++) {
          const [at, x] = [3 * influences[i] + axis, positions[3 * v + axis]];
          if (x < low[at]) low[at] = x;
          if (x > high[at]) high[at] = x;
        }
    for (let at = 0; at < low.length; at++) {
      if (!(low[at] <= high[at])) continue;
      const to = 6 * (Math.floor(at / 3) * all.length + s) + (at % 3);
      boxes[to] = (low[at] + high[at]) / 2;
      boxes[to + 3] = (high[at] - low[at]) / 2;
    }
  });
  return boxes;
}

/** 1 for each vertex that is not finite at some node, or too far away for f32; undefined if there are none. */
function nonFiniteVertices(points: BlendedPoints): Uint8Array | undefined {
  const { joints, first, influences, weights, rest, shapes, shapeWeights } = points;
  const areBad = Uint8Array.from(joints, (_, j) => (isFollowable(points, j) ? 0 : 1));
  const badWeights = !shapeWeights.every((w) => Math.abs(w) < MAX_COORDINATE);
  const all = [rest, ...shapes];
  const isBad = (x: number): boolean => !(Math.abs(x) < MAX_COORDINATE);
  let lost: Uint8Array | undefined;
  for (let v = 0; v + 1 < first.length; v++) {
    let bad = badWeights && shapes.some(({ positions }) => positions.subarray(3 * v, 3 * v + 3).some((x) => x !== 0));
    for (let i = first[v]; i < first[v + 1]; i++) bad ||= areBad[influences[i]] === 1 || isBad(weights[i]);
    for (let axis = 0; axis < 3; axis++) for (const { positions } of all) bad ||= isBad(positions[3 * v + axis]);
    if (!bad) continue;
    lost ??= new Uint8Array(first.length - 1);
    lost[v] = 1;
  }
  return lost;
}

/** Whether what follows a joint is finite, and not too far away, at all nodes. */
function isFollowable({ poses, joints, binds, boxes, shapes, shapeWeights }: BlendedPoints, joint: number): boolean {
  let weight = 1;
  for (let i = 0; i < shapeWeights.length; i++) weight = Math.max(weight, Math.abs(shapeWeights[i]));
  const own = boxes.subarray(6 * joint * (1 + shapes.length), 6 * (joint + 1) * (1 + shapes.length));
  const reach = own.reduce((sum, x) => sum + Math.abs(x), 0);
  const bind = binds.subarray(MATRIX * joint, MATRIX * (joint + 1)).reduce((sum, x) => sum + Math.abs(x), 0);
  return largestNumbers(poses)[joints[joint]] * (1 + bind * (1 + weight * reach)) < MAX_COORDINATE;
}

const LARGEST = new WeakMap<JointPoses, Float64Array>();

/** By joint, the largest absolute number of its frames; NaN if one is not a number. */
function largestNumbers(poses: JointPoses): Float64Array {
  const known = LARGEST.get(poses);
  if (known) return known;
  const { matrices, joints } = poses;
  const largest = new Float64Array(joints);
  for (let i = 0, joint = 0; i < matrices.length; i += MATRIX, joint = (joint + 1) % joints)
    for (let k = i; k < i + MATRIX; k++) {
      const size = Math.abs(matrices[k]);
      if (size > largest[joint] || Number.isNaN(size)) largest[joint] = size;
    }
  LARGEST.set(poses, largest);
  return largest;
}

/** With these vertices at the world's origin, whatever their joints do. */
function withoutVertices(points: BlendedPoints, lost: Uint8Array): BlendedPoints {
  const clear = (values: Float32Array): Float32Array =>
    values.map((x, i) => (lost[Math.floor(i / 3)] === 1 || !Number.isFinite(x) ? 0 : x));
  const cleared = ({ positions, normals }: RestShape): RestShape => ({
    positions: clear(positions),
    normals: clear(normals),
  });
  const { first, influences, weights, joints } = points;
  const vertices = Uint32Array.from({ length: first.length - 1 }, (_, v) => v);
  const perPoint = vertices.reduce((most, v) => Math.max(most, first[v + 1] - first[v]), 1);
  const skin = {
    perPoint,
    joints: new Uint16Array(perPoint * vertices.length),
    weights: new Float32Array(perPoint * vertices.length),
  };
  for (const v of vertices)
    for (let i = first[v]; i < first[v + 1] && lost[v] === 0; i++) {
      skin.joints[perPoint * v + i - first[v]] = joints[influences[i]];
      skin.weights[perPoint * v + i - first[v]] = weights[i];
    }
  const shape = {
    rest: cleared(points.rest),
    shapes: points.shapes.map(cleared),
    shapeWeights: points.shapeWeights.map((w) => (Number.isFinite(w) ? w : 0)),
    skin,
    poses: points.poses,
    origin: [-points.outer[3], -points.outer[7], -points.outer[11]] as const,
  };
  // Those that no vertex follows any more are left out, whatever they are.
  const binds: Mat4[] = [];
  points.joints.forEach((joint, j) => {
    binds[joint] = [...points.binds.subarray(MATRIX * j, MATRIX * (j + 1))];
  });
  const own = influencesOf({ ...shape, binds });
  const { rest, shapes, shapeWeights } = shape;
  return { ...points, rest, shapes, shapeWeights, ...own, boxes: jointBoxes(shape, own), nonFiniteVertices: lost };
}
