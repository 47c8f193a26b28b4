import { type BlendedPoints, jointMatrices, MATRIX, shapeWeightsAt } from './blendedPoints.ts';

/*
 * Bounds of blended points by their joints, without a look at the vertices: with weights that add up to 1 a vertex is in the convex hull of the places where
 * its joints alone would put it, and each of these is in the transformed box of the vertices that follow the joint.
 */

/** By sample: the box, as min x y z and max x y z, and the radius of a sphere about its centre, relative to the motion's origin [m]. */
export interface BlendedBounds {
  readonly boxes: Float64Array;
  readonly radii: Float64Array;
}

const BOUNDS = new WeakMap<BlendedPoints, BlendedBounds>();

/** The bounds of all samples, kept as long as the points. */
export function blendedBounds(points: BlendedPoints): BlendedBounds {
  const known = BOUNDS.get(points) ?? makeBounds(points);
  BOUNDS.set(points, known);
  return known;
}

function makeBounds(points: BlendedPoints): BlendedBounds {
  const n = points.nodes.length;
  const bounds = { boxes: new Float64Array(6 * n), radii: new Float64Array(n) };
  const corners = new JointCorners(points);
  for (let k = 0; k < n; k++) {
    const box = bounds.boxes.subarray(6 * k, 6 * k + 6);
    box.set([1, 1, 1, -1, -1, -1]);
    if (corners.count === 0) continue;
    box.fill(Number.POSITIVE_INFINITY, 0, 3);
    box.fill(Number.NEGATIVE_INFINITY, 3);
    corners.set(k);
    const at = corners.places;
    for (let i = 0; i < at.length; i++) {
      const axis = i % 3;
      if (at[i] < box[axis]) box[axis] = at[i];
      if (at[i] > box[3 + axis]) box[3 + axis] = at[i];
    }
    const [x, y, z] = [0, 1, 2].map((axis) => (box[axis] + box[3 + axis]) / 2);
    let square = 0;
    for (let i = 0; i < at.length; i += 3)
      square = Math.max(square, (at[i] - x) ** 2 + (at[i + 1] - y) ** 2 + (at[i + 2] - z) ** 2);
    bounds.radii[k] = points.spread * Math.sqrt(square);
    [x, y, z].forEach((middle, axis) => {
      const half = points.spread * (box[3 + axis] - middle);
      box[axis] = middle - half;
      box[3 + axis] = middle + half;
    });
  }
  return bounds;
}

const DISPLACEMENTS = new WeakMap<BlendedPoints, Float64Array>();

/** Upper bounds on the displacement of a vertex in each piece between samples [m], kept as long as the points. */
export function displacementBounds(points: BlendedPoints): Float64Array {
  const known = DISPLACEMENTS.get(points) ?? makeDisplacementBounds(points);
  DISPLACEMENTS.set(points, known);
  return known;
}

function makeDisplacementBounds(points: BlendedPoints): Float64Array {
  const out = new Float64Array(Math.max(0, points.nodes.length - 1));
  let [before, after] = [new JointCorners(points), new JointCorners(points)];
  before.set(0);
  for (let k = 0; k < out.length; k++) {
    after.set(k + 1);
    out[k] = points.spread * (after.farthestFrom(before) + after.reshaping(before));
    [before, after] = [after, before];
  }
  return out;
}

/** The corners of the joints' boxes at one sample. A linear map moves no point of a box farther than one of its corners. */
class JointCorners {
  /** Joints that vertices follow. */
  readonly count: number;
  /** Of 8 corners per joint, 3 numbers each, relative to the motion's origin [m]. */
  readonly places: Float64Array;
  private readonly points: BlendedPoints;
  private readonly matrices: Float64Array<ArrayBuffer>;
  private weights: Float64Array = new Float64Array(0);

  constructor(points: BlendedPoints) {
    this.points = points;
    this.count = points.joints.length;
    this.places = new Float64Array(24 * this.count);
    this.matrices = new Float64Array(MATRIX * this.count);
  }

  set(k: number): void {
    const { points, matrices: m } = this;
    jointMatrices(points, k, m);
    this.weights = shapeWeightsAt(points, k);
    for (let j = 0; j < this.count; j++) this.setJoint(j, this.boxOf(j), m);
  }

  /** Centre and half extents of what follows a joint, with its blend shapes. */
  private boxOf(joint: number): Float64Array {
    const { boxes, shapes } = this.points;
    const from = 6 * joint * (1 + shapes.length);
    if (shapes.length === 0) return boxes.subarray(from, from + 6);
    const box = boxes.slice(from, from + 6);
    for (let j = 0; j < shapes.length; j++) {
      const w = this.weights[j];
      for (let i = 0; i < 6; i++) box[i] += (i < 3 ? w : Math.abs(w)) * boxes[from + 6 * (j + 1) + i];
    }
    return box;
  }

  private setJoint(joint: number, box: Float64Array, m: Float64Array): void {
    for (let row = 0; row < 3; row++) {
      const a = MATRIX * joint + 4 * row;
      const middle = m[a] * box[0] + m[a + 1] * box[1] + m[a + 2] * box[2] + m[a + 3];
      const hx = m[a] * box[3];
      const hy = m[a + 1] * box[4];
      const hz = m[a + 2] * box[5];
      for (let corner = 0; corner < 8; corner++)
        this.places[24 * joint + 3 * corner + row] =
          middle + (corner & 1 ? hx : -hx) + (corner & 2 ? hy : -hy) + (corner & 4 ? hz : -hz);
    }
  }

  /** The greatest distance of a corner from the same one at another sample [m]. */
  farthestFrom({ places }: JointCorners): number {
    let square = 0;
    for (let i = 0; i < places.length; i += 3)
      square = Math.max(
        square,
        (this.places[i] - places[i]) ** 2 +
          (this.places[i + 1] - places[i + 1]) ** 2 +
          (this.places[i + 2] - places[i + 2]) ** 2,
      );
    return Math.sqrt(square);
  }

  /** Bound on what a change of the blend shapes moves a vertex by, beyond the corners of its box [m]. */
  reshaping({ weights, matrices }: JointCorners): number {
    const { boxes, shapes } = this.points;
    let most = 0;
    for (let joint = 0; joint < this.count; joint++) {
      let reach = 0;
      for (let j = 0; j < shapes.length; j++) {
        const at = 6 * (joint * (1 + shapes.length) + j + 1);
        const far = Math.hypot(...[0, 1, 2].map((i) => Math.abs(boxes[at + i]) + boxes[at + 3 + i]));
        reach += Math.abs(this.weights[j] - weights[j]) * far;
      }
      if (reach > 0) most = Math.max(most, 2 * reach * Math.max(normOf(this.matrices, joint), normOf(matrices, joint)));
    }
    return most;
  }
}

/** Frobenius norm of a joint's linear part, which bounds how much it stretches. */
function normOf(m: Float64Array, joint: number): number {
  let square = 0;
  for (let i = 0; i < MATRIX; i++) if (i % 4 !== 3) square += m[MATRIX * joint + i] ** 2;
  return Math.sqrt(square);
}
