import type { Mat4 } from '../../math/mat4.ts';
import { MATRIX, type RestShape } from '../../scene/streaming/blendedPoints.ts';
import { blendMatrices, type SkinInfluences } from './skinning.ts';

/** A mesh that follows joints, as far as its path matters. */
export interface OutlinedMesh {
  /** At rest, 3 numbers per vertex. */
  readonly positions: ArrayLike<number>;
  /** Absent: all vertices follow the first joint. */
  readonly skin?: SkinInfluences;
  /** By joint, from the rest shape to the joint's axes. */
  readonly binds: readonly Mat4[];
  readonly shapes: readonly Pick<RestShape, 'positions'>[];
  /** A weight for each shape. */
  weightsAt(t: number): ArrayLike<number>;
}

/** By joint the 3 × 4 matrix to the world at a time, 12 numbers each. */
type FramesAt = (t: number) => Float64Array;

/** Number of vertices of meshes with blend shapes whose paths are followed too. */
const MAX_PROBED_POINTS = 256;

/**
 * The points by whose paths the nodes of a time grid are chosen: the corners of the box of what follows each joint, from whose chords no vertex is farther
 * than the farthest of them, since its place is a mean of places in these boxes; and some vertices if there are blend shapes. `meshes`: all that follow
 * the joints.
 */
export function jointOutline(meshes: readonly OutlinedMesh[], framesAt: FramesAt): (t: number) => Float64Array {
  const corners = jointCorners(meshes);
  const shaped = meshes.filter(({ shapes }) => shapes.length > 0);
  const probes = shaped.map((mesh) => probedVertices(mesh, Math.ceil(MAX_PROBED_POINTS / shaped.length)));
  const count = corners.reduce((sum, each) => sum + each.length, 0);
  const out = new Float64Array(count + probes.reduce((sum, each) => sum + 3 * each.length, 0));
  return (t) => {
    let at = 0;
    const frames = framesAt(t);
    for (const [j, own] of corners.entries()) {
      const m = MATRIX * j;
      for (let i = 0; i < own.length; i += 3)
        for (let row = m; row < m + MATRIX; row += 4)
          out[at++] =
            frames[row] * own[i] + frames[row + 1] * own[i + 1] + frames[row + 2] * own[i + 2] + frames[row + 3];
    }
    shaped.forEach((mesh, i) => {
      out.set(blendedPlaces(mesh, frames, t, probes[i]), at);
      at += 3 * probes[i].length;
    });
    return out;
  };
}

/** Places of all vertices, or of those given, 3 numbers each: Σ w M B (p + Σ b δ) without the part that is missing from the weights. */
export function blendedPlaces(
  { positions, skin, binds, shapes, weightsAt }: OutlinedMesh,
  frames: Float64Array,
  t: number,
  vertices?: ArrayLike<number>,
): Float64Array {
  const count = vertices?.length ?? positions.length / 3;
  const out = new Float64Array(3 * count);
  const matrices = boundFrames(frames, binds);
  const weights = shapes.length > 0 ? weightsAt(t) : [];
  const m = matrices.slice(0, MATRIX);
  const p = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    const v = vertices ? vertices[i] : i;
    if (skin) blendMatrices(m, matrices, MATRIX, skin, v);
    for (let axis = 0; axis < 3; axis++) {
      p[axis] = positions[3 * v + axis];
      for (let j = 0; j < shapes.length; j++) if (weights[j]) p[axis] += weights[j] * shapes[j].positions[3 * v + axis];
    }
    for (let row = 0; row < 3; row++)
      out[3 * i + row] = m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3];
  }
  return out;
}

/** By joint the matrix from the rest shape to the world. */
function boundFrames(frames: Float64Array, binds: readonly Mat4[]): Float64Array {
  const out = new Float64Array(MATRIX * binds.length);
  for (const [j, b] of binds.entries())
    for (let row = MATRIX * j; row < MATRIX * (j + 1); row += 4)
      for (let c = 0; c < 4; c++)
        out[row + c] =
          frames[row] * b[c] +
          frames[row + 1] * b[4 + c] +
          frames[row + 2] * b[8 + c] +
          (c === 3 ? frames[row + 3] : 0);
  return out;
}

/** The vertex that each blend shape moves most, and others at even distances in the order of the mesh. */
function probedVertices({ positions, shapes }: OutlinedMesh, most: number): number[] {
  const vertices = positions.length / 3;
  const chosen = new Set(shapes.slice(0, most).map((shape) => farthest(shape.positions)));
  const even = Math.min(vertices, Math.max(0, most - chosen.size));
  for (let i = 0; i < even; i++) chosen.add(Math.floor((i * vertices) / even));
  return [...chosen];
}

/** The index of the longest of vectors of three numbers. */
function farthest(offsets: ArrayLike<number>): number {
  let [vertex, most] = [0, -1];
  for (let i = 0; i + 2 < offsets.length; i += 3) {
    const square = offsets[i] ** 2 + offsets[i + 1] ** 2 + offsets[i + 2] ** 2;
    if (square > most) [vertex, most] = [i / 3, square];
  }
  return vertex;
}

/** By joint the corners of the box of the vertices that follow it, in its axes, 3 numbers each; none for joints without any. */
function jointCorners(meshes: readonly OutlinedMesh[]): number[][] {
  const boxes: number[][] = [];
  for (const { positions, skin, binds } of meshes)
    for (let v = 0; v < positions.length / 3; v++) {
      if (!skin) extendBox(boxes, 0, binds, positions, v);
      else
        for (let i = skin.perPoint * v; i < skin.perPoint * (v + 1); i++)
          if (skin.weights[i] !== 0) extendBox(boxes, skin.joints[i], binds, positions, v);
    }
  return Array.from(boxes, cornersOf);
}

/** Extends a joint's box by a vertex. */
function extendBox(
  boxes: number[][],
  joint: number,
  binds: readonly Mat4[],
  positions: ArrayLike<number>,
  v: number,
): void {
  boxes[joint] ??= [...EMPTY];
  const [box, m] = [boxes[joint], binds[joint]];
  for (let axis = 0; axis < 3; axis++) {
    const row = 4 * axis;
    const x =
      m[row] * positions[3 * v] + m[row + 1] * positions[3 * v + 1] + m[row + 2] * positions[3 * v + 2] + m[row + 3];
    if (x < box[axis]) box[axis] = x;
    if (x > box[3 + axis]) box[3 + axis] = x;
  }
}

const EMPTY = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];

function cornersOf(box: readonly number[] | undefined): number[] {
  if (!box || !(box[0] <= box[3])) return [];
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    box[3 * (i & 1)],
    box[3 * ((i >> 1) & 1) + 1],
    box[3 * (i >> 2) + 2],
  ]);
}
