import { add, distance, lerp, scale, type Vec3 } from '../../math/vec3.ts';
import { emissionTime, type ObserverEvent } from '../../physics/worldLines/lightCone.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { pointAt } from '../mesh/polygons.ts';
import { pieceAt, vertexPositions } from '../motion/motion.ts';
import { isStreamed } from '../streaming/samplePoints.ts';
import type { Mesh, SampledPointsMotion, Scene, SceneObject } from '../types.ts';
import { SupportMap } from './supportMap.ts';

export interface BoundingBox {
  readonly min: Vec3;
  readonly max: Vec3;
}
export interface BoundingSphere {
  readonly center: Vec3;
  readonly radius: number;
}

/** The axis-parallel box of points, 3 numbers each [m]; undefined of none. Numbers that are not finite are left out. */
export const boundingBox = (points: ArrayLike<number>): BoundingBox | undefined =>
  finiteBox(points) ?? boxOfFinite(points);

/** The same of points that are all finite; undefined where one is not. One pass, which long caches take thousands of times. */
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
    // 0 times what is not finite is no number.
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

/** A sphere round the middle of the bounding box that holds all points [m]; at most √3 times the smallest one. */
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

/** By their positions: objects that share a mesh, or wear it in other materials, share these. */
const MESH_SPHERES = new WeakMap<Float32Array, BoundingSphere>();
const SUPPORT_MAPS = new WeakMap<Float32Array, SupportMap>();

/** The origin, and the tips of the axes. */
const AXES = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);

/** `boundingSphere` of a mesh, found once. */
export function meshBoundingSphere({ positions }: Pick<Mesh, 'positions'>): BoundingSphere {
  const sphere = MESH_SPHERES.get(positions) ?? boundingSphere(positions);
  MESH_SPHERES.set(positions, sphere);
  return sphere;
}

/** The box of sample k, from the motion's origin [m]; undefined of no points. */
export function sampleBoundingBox({ points }: SampledPointsMotion, k: number): BoundingBox | undefined {
  if (!isStreamed(points)) return boundingBox(points[k]);
  const [x, y, z, X, Y, Z] = points.statistics.boxes.subarray(6 * k, 6 * k + 6);
  return x <= X ? { min: [x, y, z], max: [X, Y, Z] } : undefined;
}

/** The sphere round sample k, from the motion's origin [m]. */
export function sampleBoundingSphere(motion: SampledPointsMotion, k: number): BoundingSphere {
  const { points } = motion;
  if (!isStreamed(points)) return boundingSphere(points[k]);
  const box = sampleBoundingBox(motion, k);
  if (!box) return { center: [0, 0, 0], radius: 0 };
  const [x, y, z] = box.min.map((low, i) => (low + box.max[i]) * 0.5);
  return { center: [x, y, z], radius: points.statistics.radii[k] };
}

/** Half the diagonal of the box of spheres [m]; 1 m of none. */
export function halfDiagonal(spheres: readonly BoundingSphere[]): number {
  const box = boundingBox(
    spheres.flatMap(({ center, radius }) => [-radius, radius].flatMap((side) => center.map((x) => x + side))),
  );
  return box ? distance(box.min, box.max) / 2 : 1;
}

/** The box of all that exists at world time t [s]; undefined where nothing does. c [m/s]. */
export function sceneBounds(scene: Scene, t: number, c: number): BoundingBox | undefined {
  const corners: number[] = [];
  for (const object of scene.objects) {
    if (t < object.lifetime.birth || t > object.lifetime.death) continue;
    const box = objectBounds(object, t, c);
    if (box) corners.push(...box.min, ...box.max);
  }
  return boundingBox(corners);
}

/** The box of an object at world time t [s]; of one whose samples are left in a file between the boxes of its samples. */
export function objectBounds(object: SceneObject, t: number, c: number): BoundingBox | undefined {
  const { motion } = object;
  if (motion.kind === 'sampled-points' && isStreamed(motion.points)) return interpolatedBox(motion, t);
  const { positions } = object.mesh;
  const { kind } = motion;
  const isAffine = kind === 'static' || kind === 'uniform' || kind === 'sampled';
  if (!isAffine || positions.length === 0 || !Number.isFinite(meshBoundingSphere(object.mesh).radius))
    return boundingBox(vertexPositions(object, t, c));
  // The object's axes are taken to the world as its points are.
  const placed = vertexPositions({ ...object, mesh: { ...object.mesh, positions: AXES } }, t, c);
  const [o, x, y, z] = [0, 1, 2, 3].map((i) => pointAt(placed, i));
  const extremes = SUPPORT_MAPS.get(positions) ?? new SupportMap(positions);
  SUPPORT_MAPS.set(positions, extremes);
  const reach = (k: number, sign: number): number =>
    o[k] + sign * extremes.support([sign * (x[k] - o[k]), sign * (y[k] - o[k]), sign * (z[k] - o[k])]);
  return { min: [reach(0, -1), reach(1, -1), reach(2, -1)], max: [reach(0, 1), reach(1, 1), reach(2, 1)] };
}

function interpolatedBox(motion: SampledPointsMotion, t: number): BoundingBox | undefined {
  const { before, after, s } = pieceAt(motion.times, t);
  const [a, b] = [sampleBoundingBox(motion, before), sampleBoundingBox(motion, after)];
  const between = (p: Vec3, q: Vec3): Vec3 => add(motion.origin, lerp(p, q, s));
  return a && b && { min: between(a.min, b.min), max: between(a.max, b.max) };
}

/**
 * World times [s] between which lies the emission of every point that stays within `radius` [m] of `center`, in the world
 * frame: those of the centre for observers who look radius/c earlier and later at the same place. undefined where the
 * centre's horizon hides it from one of them.
 */
export function emissionWindow(
  center: WorldLine,
  radius: number,
  observer: ObserverEvent,
  c: number,
): readonly [from: number, to: number] | undefined {
  const at = (dt: number) => emissionTime(center, { ...observer, t: observer.t + dt }, c);
  const from = at(-radius / c);
  const to = at(radius / c);
  return from === undefined || to === undefined ? undefined : [from, to];
}
