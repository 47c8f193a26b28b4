import { type Mat4, multiply } from '../../math/mat4.ts';

/** How joints hang together. */
export interface JointTree {
  readonly names: readonly string[];
  /** By joint the index of its parent, which need not come first; −1 for those without. */
  readonly parents: ArrayLike<number>;
}

/** Frames of joints at the nodes of a time grid; shared by all meshes that follow them. */
export interface JointPoses {
  /** Of all joints but the last, which is where the rest of incomplete weights is. */
  readonly tree: JointTree;
  /** Number of joints. */
  readonly joints: number;
  /** By node and joint 12 numbers: the rows of the 3 × 4 matrix from the joint's axes to the world [m]. */
  readonly matrices: Float64Array;
}

/** Places and normals of all vertices at rest, 3 numbers each [m]; of a blend shape, their displacements at weight 1. */
export interface RestShape {
  /** 3 per vertex [m]. */
  readonly positions: Float32Array;
  /** 3 per vertex. */
  readonly normals: Float32Array;
}

/**
 * The samples of a linear-blend skin, evaluated where they are needed: xₖ = Aₖ Σᵢ wᵢ Mᵢ(tₖ) Bᵢ (p + Σⱼ bⱼ(tₖ) δⱼ), with the joints' frames M and the weights b
 * of blend shapes at the nodes of a time grid. Between nodes every vertex moves straight, as for all sampled points, so that whatever holds for these
 * holds here exactly. Plain data, so that other threads can evaluate samples themselves. docs/physics.md §4.7.
 */
export interface BlendedPoints {
  readonly poses: JointPoses;
  /** By sample: its node among the poses. */
  readonly nodes: Uint32Array;
  /** By sample 3 numbers: translation after all else [m]; absent if there is none. */
  readonly shifts?: Float64Array;
  /** From the world of the poses to the motion's: world-oriented, relative to its origin. */
  readonly outer: Mat4;
  /** The joints that the mesh follows: their indices among those of the poses. */
  readonly joints: Uint16Array;
  /** For each of them 12 numbers: the 3 × 4 matrix from the rest shape to the joint's axes. */
  readonly binds: Float64Array;
  /** Vertex v has the influences from `first[v]` up to `first[v + 1]`. */
  readonly first: Uint32Array;
  /** By influence: index into `joints`. The weights of a vertex add up to 1. */
  readonly influences: Uint16Array;
  /** By influence: its weight. */
  readonly weights: Float32Array;
  /** Vertices at rest. */
  readonly rest: RestShape;
  /** Blend shapes. */
  readonly shapes: readonly RestShape[];
  /** By node: a weight for each shape. */
  readonly shapeWeights: Float64Array;
  /** By joint the box of the rest positions that follow it, then by shape those of their displacements: centre and half extents, 6 numbers each [m]. */
  readonly boxes: Float64Array;
  /** The largest sum of a vertex's absolute weights: 1 unless some are negative. */
  readonly spread: number;
  /** 1 for each vertex that is not finite at some sample, and is therefore kept at the world's origin. Absent if there are none. */
  readonly nonFiniteVertices?: Uint8Array;
}

/** Numbers in a 3 × 4 matrix. */
export const MATRIX = 12;

/** One of 3 × 4 matrices, by its index. */
export const matrixAt = (matrices: Float64Array, index: number): Mat4 => [
  ...matrices.subarray(MATRIX * index, MATRIX * (index + 1)),
  ...[0, 0, 0, 1],
];

/** Matrices from the rest shape to the motion's axes and origin at sample k, of the joints that the mesh follows: 12 numbers each. */
export function jointMatrices(
  { poses, nodes, shifts, outer, joints, binds }: BlendedPoints,
  k: number,
  out: Float64Array = new Float64Array(MATRIX * joints.length),
): Float64Array {
  const { matrices } = poses;
  const node = MATRIX * poses.joints * nodes[k];
  for (let j = 0; j < joints.length; j++) {
    const from = node + MATRIX * joints[j];
    const to = MATRIX * j;
    for (let row = 0; row < 3; row++) {
      const [a, o] = [to + 4 * row, 4 * row];
      // The row of outer · frame, then of its product with the bind matrix.
      let [x, y, z, w] = [0, 0, 0, 0];
      for (let i = 0; i < 3; i++) {
        const f = outer[o + i];
        const at = from + 4 * i;
        x += f * matrices[at];
        y += f * matrices[at + 1];
        z += f * matrices[at + 2];
        w += f * matrices[at + 3];
      }
      for (let i = 0; i < 4; i++) out[a + i] = x * binds[to + i] + y * binds[to + 4 + i] + z * binds[to + 8 + i];
      out[a + 3] += w + outer[o + 3] + (shifts ? shifts[3 * k + row] : 0);
    }
  }
  return out;
}

/** The weights of the blend shapes at sample k. */
export const shapeWeightsAt = ({ nodes, shapes, shapeWeights }: BlendedPoints, k: number): Float64Array =>
  shapeWeights.subarray(shapes.length * nodes[k], shapes.length * (nodes[k] + 1));

/** Points of sample k: 3 numbers per vertex, world-oriented, relative to the motion's origin [m]. */
export function makeBlendedPoints(points: BlendedPoints, k: number): Float32Array {
  const { first, influences, weights } = points;
  const matrices = jointMatrices(points, k);
  const rest = shaped(points, 'positions', k);
  const out = new Float32Array(rest.length);
  const m = new Float64Array(MATRIX);
  for (let v = 0; v + 1 < first.length; v++) {
    const at = 3 * v;
    const x = rest[at];
    const y = rest[at + 1];
    const z = rest[at + 2];
    blend(m, matrices, influences, weights, first[v], first[v + 1]);
    out[at] = m[0] * x + m[1] * y + m[2] * z + m[3];
    out[at + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
    out[at + 2] = m[8] * x + m[9] * y + m[10] * z + m[11];
  }
  return out;
}

/** Unit normals of sample k, as `makeBlendedPoints`: transformed by the cofactors of the blended matrix, reversed like the faces by a reflection. */
export function makeBlendedNormals(points: BlendedPoints, k: number): Float32Array {
  const { first, influences, weights } = points;
  const matrices = jointMatrices(points, k);
  const rest = shaped(points, 'normals', k);
  const out = new Float32Array(rest.length);
  const m = new Float64Array(MATRIX);
  for (let v = 0; v + 1 < first.length; v++) {
    const at = 3 * v;
    blend(m, matrices, influences, weights, first[v], first[v + 1]);
    const x = rest[at];
    const y = rest[at + 1];
    const z = rest[at + 2];
    const ax = m[5] * m[10] - m[6] * m[9];
    const ay = m[6] * m[8] - m[4] * m[10];
    const az = m[4] * m[9] - m[5] * m[8];
    const sign = m[0] * ax + m[1] * ay + m[2] * az < 0 ? -1 : 1;
    const nx = sign * (ax * x + ay * y + az * z);
    const ny =
      sign * ((m[9] * m[2] - m[10] * m[1]) * x + (m[10] * m[0] - m[8] * m[2]) * y + (m[8] * m[1] - m[9] * m[0]) * z);
    const nz =
      sign * ((m[1] * m[6] - m[2] * m[5]) * x + (m[2] * m[4] - m[0] * m[6]) * y + (m[0] * m[5] - m[1] * m[4]) * z);
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    const known = length > 0 && length < Number.POSITIVE_INFINITY;
    out[at] = known ? nx / length : 0;
    out[at + 1] = known ? ny / length : 0;
    out[at + 2] = known ? nz / length : 1;
  }
  return out;
}

/** One vertex at each sample [m], rounded as `makeBlendedPoints` does. */
export function blendedVertex(points: BlendedPoints, vertex: number): (k: number) => Float32Array {
  const { first, influences, weights, rest, shapes, joints, binds } = points;
  const [begin, end] = [first[vertex], first[vertex + 1]];
  const own = influences.subarray(begin, end);
  const few = {
    ...points,
    joints: Uint16Array.from(own, (j) => joints[j]),
    binds: Float64Array.from(
      { length: MATRIX * own.length },
      (_, i) => binds[MATRIX * own[Math.floor(i / MATRIX)] + (i % MATRIX)],
    ),
  };
  const order = Uint16Array.from(own.keys());
  const w = weights.subarray(begin, end);
  const matrices = new Float64Array(MATRIX * own.length);
  const m = new Float64Array(MATRIX);
  const p = new Float64Array(3);
  return (k) => {
    const at = shapeWeightsAt(points, k);
    for (let i = 0; i < 3; i++) {
      p[i] = rest.positions[3 * vertex + i];
      for (let j = 0; j < shapes.length; j++) p[i] += at[j] * shapes[j].positions[3 * vertex + i];
    }
    blend(m, jointMatrices(few, k, matrices), order, w, 0, own.length);
    const out = new Float32Array(3);
    for (let i = 0; i < 3; i++) out[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
    return out;
  };
}

/** out = Σ w M over the influences from `begin` up to `end`. */
function blend(
  out: Float64Array,
  matrices: Float64Array,
  influences: Uint16Array,
  weights: Float32Array,
  begin: number,
  end: number,
): void {
  out.fill(0);
  for (let i = begin; i < end; i++) {
    const w = weights[i];
    const from = MATRIX * influences[i];
    for (let n = 0; n < MATRIX; n++) out[n] += w * matrices[from + n];
  }
}

/** The rest shape with the blend shapes at sample k. */
function shaped(points: BlendedPoints, of: keyof RestShape, k: number): Float32Array | Float64Array {
  const { rest, shapes } = points;
  const weights = shapeWeightsAt(points, k);
  if (!weights.some((w) => w !== 0)) return rest[of];
  const out = Float64Array.from(rest[of]);
  shapes.forEach((shape, j) => {
    const w = weights[j];
    if (w === 0) return;
    const by = shape[of];
    for (let i = 0; i < out.length; i++) out[i] += w * by[i];
  });
  return out;
}

/** Applies a matrix without shear to all samples. */
export const transformBlendedPoints = (points: BlendedPoints, linear: Mat4): BlendedPoints => ({
  ...points,
  outer: multiply(linear, points.outer),
  ...(points.shifts && { shifts: turnedShifts(points.shifts, linear) }),
});

function turnedShifts(shifts: Float64Array, m: Mat4): Float64Array {
  const out = new Float64Array(shifts.length);
  for (let i = 0; i < out.length; i += 3)
    for (let row = 0; row < 3; row++)
      out[i + row] = m[4 * row] * shifts[i] + m[4 * row + 1] * shifts[i + 1] + m[4 * row + 2] * shifts[i + 2];
  return out;
}

/** The samples with the indices `order`, each translated by its own shift [m], three numbers each. */
export function translateBlendedPoints(
  points: BlendedPoints,
  order: readonly number[],
  shifts: Float64Array,
): BlendedPoints {
  const own = points.shifts;
  return {
    ...points,
    nodes: Uint32Array.from(order, (k) => points.nodes[k]),
    shifts: own ? shifts.map((x, i) => x + own[3 * order[Math.floor(i / 3)] + (i % 3)]) : shifts,
  };
}
