import { type Mat3, transform } from '../../math/mat3.ts';
import { add, distance, dot, scale, type Vec3 } from '../../math/vec3.ts';
import { pointAt } from '../mesh/polygons.ts';
import type { StretchedPoints } from '../mesh/stretch.ts';
import { blendedBounds } from '../streaming/blendedBounds.ts';
import { isListed, isStreamed } from '../streaming/samplePoints.ts';
import type { Mesh, SampledPointsMotion } from '../types.ts';
import type { Support } from './supportMap.ts';

/** An axis-aligned box [m]. */
export interface BoundingBox {
  /** Its least coordinates. */
  readonly min: Vec3;
  /** Its greatest coordinates. */
  readonly max: Vec3;
}
/** A sphere that contains something [m]. */
export interface BoundingSphere {
  /** Its centre [m]. */
  readonly center: Vec3;
  /** Its radius [m]. */
  readonly radius: number;
}

/**
 * The axis-aligned box of points, 3 numbers each [m]; undefined if there are none. Ignores values that are not finite.
 * @example
 * boundingBox([0, 0, 0, 1, 2, 3, -1, 5, 0]); // { min: [-1, 0, 0], max: [1, 5, 3] } m
 */
export const boundingBox = (points: ArrayLike<number>): BoundingBox | undefined =>
  finiteBox(points) ?? boxOfFinite(points);

/** How far a box reaches. */
export const boxSupport =
  (box: BoundingBox | undefined): Support =>
  (d) =>
    box
      ? dot(d, [0, 1, 2].map((k) => (d[k] < 0 ? box.min[k] : box.max[k])) as unknown as Vec3)
      : Number.NEGATIVE_INFINITY;

/** The same, but undefined if any value is not finite. A single pass, because long caches call it thousands of times. */
export function finiteBox(points: ArrayLike<number>): BoundingBox | undefined {
  let x0 = Number.POSITIVE_INFINITY;
  let y0 = x0;
  let z0 = x0;
  let x1 = -x0;
  let y1 = -x0;
  let z1 = -x0;
  let zero = 0;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const x = points[i];
    const y = points[i + 1];
    const z = points[i + 2];
    if (x < x0) x0 = x;
    if (x > x1) x1 = x;
    if (y < y0) y0 = y;
    if (y > y1) y1 = y;
    if (z < z0) z0 = z;
    if (z > z1) z1 = z;
    // NaN unless all are finite.
    zero += x * 0 + y * 0 + z * 0;
  }
  return zero === 0 && x0 <= x1 ? { min: [x0, y0, z0], max: [x1, y1, z1] } : undefined;
}

function boxOfFinite(points: ArrayLike<number>): BoundingBox | undefined {
  const min = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const max = min.map((x) => -x);
  for (let i = 0; i < points.length; i++) {
    const x = points[i];
    if (!Number.isFinite(x)) continue;
    if (x < min[i % 3]) min[i % 3] = x;
    if (x > max[i % 3]) max[i % 3] = x;
  }
  return min.every((x, k) => x <= max[k]) ? { min: pointAt(min, 0), max: pointAt(max, 0) } : undefined;
}

/**
 * A sphere around the centre of the bounding box that contains all points [m]; at most √3 times as large as the smallest.
 * @example
 * boundingSphere([-3, 0, 0, 3, 0, 0, 0, 1, 0]); // { center: [0, 0.5, 0], radius: 3.041 } m
 */
export function boundingSphere(points: ArrayLike<number>, box = boundingBox(points)): BoundingSphere {
  if (!box) return { center: [0, 0, 0], radius: 0 };
  const center = scale(add(box.min, box.max), 0.5);
  const [x, y, z] = center;
  let square = -1;
  let farthest = 0;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const dx = points[i] - x;
    const dy = points[i + 1] - y;
    const dz = points[i + 2] - z;
    const d = dx * dx + dy * dy + dz * dz;
    if (d > square) {
      square = d;
      farthest = i / 3;
    }
  }
  return { center, radius: distance(pointAt(points, farthest), center) || 0 };
}

/** By position array, which objects share even if their materials differ. */
const MESH_SPHERES = new WeakMap<Float32Array, BoundingSphere>();

/** `boundingSphere` of a mesh, cached. */
export function meshBoundingSphere({ positions }: Pick<Mesh, 'positions'>): BoundingSphere {
  const sphere = MESH_SPHERES.get(positions) ?? boundingSphere(positions);
  MESH_SPHERES.set(positions, sphere);
  return sphere;
}

/** Half the diagonal of the box of points, 3 numbers each; 0 without any. */
export function boxRadius(points: ArrayLike<number>): number {
  const box = boundingBox(points);
  return box ? Math.hypot(...box.max.map((x, k) => x - box.min[k])) / 2 : 0;
}

/** The bounding sphere of an object in its own frame [m]. */
export function objectBoundingSphere({ mesh, stretch }: StretchedPoints): BoundingSphere {
  const sphere = meshBoundingSphere(mesh);
  return stretch ? stretchedSphere(mesh.positions, stretch, transform(stretch, sphere.center)) : sphere;
}

/** The sphere around a centre that contains all points S x. */
function stretchedSphere(points: Float32Array, stretch: Mat3, center: Vec3): BoundingSphere {
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = stretch;
  const [cx, cy, cz] = center;
  let square = 0;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    const dx = xx * x + xy * y + xz * z - cx;
    const dy = yx * x + yy * y + yz * z - cy;
    const dz = zx * x + zy * y + zz * z - cz;
    square = Math.max(square, dx * dx + dy * dy + dz * dz);
  }
  return { center, radius: Math.sqrt(square) };
}

/** The box of sample k, relative to the motion's origin [m]; undefined without points. That of blended points is not tight. */
export function sampleBoundingBox({ points }: SampledPointsMotion, k: number): BoundingBox | undefined {
  if (isListed(points)) return boundingBox(points[k]);
  const { boxes } = isStreamed(points) ? points.statistics : blendedBounds(points);
  const [x, y, z, X, Y, Z] = boxes.subarray(6 * k, 6 * k + 6);
  return x <= X ? { min: [x, y, z], max: [X, Y, Z] } : undefined;
}

/** The bounding sphere of sample k, relative to the motion's origin [m]. */
export function sampleBoundingSphere(motion: SampledPointsMotion, k: number): BoundingSphere {
  const { points } = motion;
  if (isListed(points)) return boundingSphere(points[k]);
  const { radii } = isStreamed(points) ? points.statistics : blendedBounds(points);
  const box = sampleBoundingBox(motion, k);
  if (!box) return { center: [0, 0, 0], radius: 0 };
  const [x, y, z] = box.min.map((low, i) => (low + box.max[i]) * 0.5);
  return { center: [x, y, z], radius: radii[k] };
}

/** Half the diagonal of the box of spheres [m]; 1 m without spheres. */
export function halfDiagonal(spheres: readonly BoundingSphere[]): number {
  const box = boundingBox(
    spheres.flatMap(({ center, radius }) => [-radius, radius].flatMap((side) => center.map((x) => x + side))),
  );
  return box ? distance(box.min, box.max) / 2 : 1;
}
