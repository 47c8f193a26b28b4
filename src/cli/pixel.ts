import { rotate } from '../math/quat.ts';
import { cross, dot, normalize, scale, sub, type Vec3 } from '../math/vec3.ts';
import { probeVertex, probeVertices, type VertexProbe } from '../scene/probe.ts';
import { subdivideObject } from '../scene/subdivide.ts';
import type { SampledPointsMotion, Scene, SceneObject } from '../scene/types.ts';
import type { View, ViewPoint } from '../scene/view.ts';
import type { Size } from './parse.ts';

/** What an observer sees at a pixel: a point of a surface, at the event where the light left it. */
export interface SeenPoint extends Omit<VertexProbe, 'vertex' | 'visible'> {
  readonly prim: string;
  /** Place in the scene plus one, as in the `object` channel. */
  readonly object: number;
}

/** Where a ray meets a triangle: distance along the ray [m] and weights of the second and third corner. */
interface Hit {
  readonly distance: number;
  readonly weights: readonly [number, number];
}

/**
 * The nearest surface on the ray through a pixel, by f64 arithmetic on the apparent triangles. Edges that are straight in
 * the world are seen curved, so the point is then moved within its triangle until its own apparent place lies on the ray.
 */
export function seenAtPixel(
  scene: Scene,
  view: ViewPoint,
  c: number,
  how: View,
  size: Size,
  pixel: readonly [number, number],
): SeenPoint | undefined {
  const ray = pixelRay(view, size, pixel);
  let nearest: SeenPoint | undefined;
  for (const [i, whole] of scene.objects.entries()) {
    const object = cutLongEdges(whole, TRIANGLES / scene.objects.length);
    const seen = seenOnObject(object, view, c, how, ray, nearest?.distance ?? Number.POSITIVE_INFINITY);
    if (seen) nearest = { prim: object.path, object: i + 1, ...seen };
  }
  return nearest;
}

/** A unit direction in the observer's frame, on the axes that `apparent` has. */
function pixelRay({ orientation, fovY }: ViewPoint, { width, height }: Size, [x, y]: readonly [number, number]): Vec3 {
  const tan = Math.tan(fovY / 2);
  const right = ((x + 0.5) / width) * 2 - 1;
  const up = 1 - ((y + 0.5) / height) * 2;
  return normalize(rotate(orientation, [(right * tan * width) / height, up * tan, -1]));
}

/** All objects together are cut into about so many. */
const TRIANGLES = 200_000;

/** Pieces of a hundredth of the object are straight enough to find the triangle; the point itself is found exactly. */
function cutLongEdges(object: SceneObject, budget: number): SceneObject {
  const { positions } = object.mesh;
  let reach = 0;
  for (const x of positions) reach = Math.max(reach, Math.abs(x));
  return subdivideObject(object, reach / 50, budget).result;
}

function seenOnObject(
  object: SceneObject,
  view: ViewPoint,
  c: number,
  how: View,
  ray: Vec3,
  nearer: number,
): Omit<SeenPoint, 'prim' | 'object'> | undefined {
  const corners = probeVertices(object, view, c, how);
  const { indices } = object.mesh;
  const { birth, death } = object.lifetime;
  let best = nearer;
  let found: VertexProbe | undefined;
  for (let k = 0; k < indices.length; k += 3) {
    const triangle = [corners[indices[k]], corners[indices[k + 1]], corners[indices[k + 2]]];
    const [p, q, r] = triangle;
    if (!p || !q || !r) continue;
    const hit = intersect(ray, p.apparent, q.apparent, r.apparent);
    if (!hit || hit.distance >= best) continue;
    const seen = refine(object, k, hit, view, c, how, ray, [p.apparent, q.apparent, r.apparent]);
    if (!seen || seen.time < birth || seen.time > death) continue;
    best = hit.distance;
    found = seen;
  }
  if (!found) return undefined;
  const { vertex: _, visible: __, ...rest } = found;
  return rest;
}

/** Möller & Trumbore, Fast, minimum storage ray/triangle intersection (1997); both sides count. */
function intersect(ray: Vec3, a: Vec3, b: Vec3, d: Vec3): Hit | undefined {
  const [e1, e2] = [sub(b, a), sub(d, a)];
  const p = cross(ray, e2);
  const det = dot(e1, p);
  if (det === 0) return undefined;
  const v = dot(scale(a, -1), p) / det;
  const q = cross(scale(a, -1), e1);
  const w = dot(ray, q) / det;
  const distance = dot(e2, q) / det;
  return v >= 0 && w >= 0 && v + w <= 1 && distance > 0 ? { distance, weights: [v, w] } : undefined;
}

const REFINEMENTS = 30;
/** A mesh's positions are f32: no weight is known better. */
const F32_STEP = 2 ** -23;

/** Simplified Newton iteration on the weights, with the flat triangle's derivative; it starts at the flat hit. */
function refine(
  object: SceneObject,
  corner: number,
  hit: Hit,
  view: ViewPoint,
  c: number,
  how: View,
  ray: Vec3,
  [a, b, d]: readonly [Vec3, Vec3, Vec3],
): VertexProbe | undefined {
  const [e1, e2] = [sub(b, a), sub(d, a)];
  const normal = cross(e1, e2);
  const wanted = scale(ray, hit.distance);
  let [v, w] = hit.weights;
  let seen = probeVertex(materialPoint(object, corner, v, w), 0, view, c, how);
  for (let i = 0; i < REFINEMENTS && seen; i++) {
    // Where the point is seen, projected from the observer into the plane of the flat triangle.
    const at = scale(seen.apparent, dot(normal, a) / dot(normal, seen.apparent));
    const miss = sub(wanted, at);
    const dv = dot(cross(miss, e2), normal) / dot(normal, normal);
    const dw = dot(cross(e1, miss), normal) / dot(normal, normal);
    [v, w] = [v + dv, w + dw];
    seen = probeVertex(materialPoint(object, corner, v, w), 0, view, c, how);
    if (Math.abs(dv) + Math.abs(dw) < F32_STEP) break;
  }
  return seen;
}

/** The point of triangle `corner` with the given weights, as an object of one vertex. */
function materialPoint(object: SceneObject, corner: number, v: number, w: number): SceneObject {
  const { mesh, motion } = object;
  const [i, j, k] = [mesh.indices[corner], mesh.indices[corner + 1], mesh.indices[corner + 2]];
  const blend = (p: Float32Array): Float32Array =>
    Float32Array.from([0, 1, 2], (n) => (1 - v - w) * p[3 * i + n] + v * p[3 * j + n] + w * p[3 * k + n]);
  const point = { ...mesh, positions: blend(mesh.positions) };
  if (motion.kind !== 'sampled-points') return { ...object, mesh: point };
  const moving: SampledPointsMotion = { ...motion, points: motion.points.map(blend) };
  return { ...object, mesh: point, motion: moving };
}
