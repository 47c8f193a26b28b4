import { rotate } from '../math/quat.ts';
import { dot, lerp, negate, normalize, type Vec3 } from '../math/vec3.ts';
import { properVelocity } from '../physics/boost.ts';
import { contraction } from '../physics/simultaneity.ts';
import { pieceAt, samplePose } from '../scene/motion.ts';
import { normalsAt as normalsAtSample } from '../scene/points.ts';
import { pointAt } from '../scene/polygons.ts';
import type { Material, SceneObject } from '../scene/types.ts';
import { materialOf } from './material.ts';
import { type Rgba, sampleTexture } from './texture.ts';
import type { TracedScene } from './trace.ts';
import type { Hit } from './types.ts';

/** What a surface is where a ray meets it. Colours are linear sRGB. */
export interface SurfacePoint {
  readonly albedo: Vec3;
  readonly opacity: number;
  /** Radiance. */
  readonly emissive: Vec3;
  readonly roughness: number;
  readonly metallic: number;
  /** Refractive index; 1.5 where the scene does not tell. */
  readonly ior: number;
  /** Interpolated unit normal in the rest frame, on the world axes that the pure boost carries there; towards the side that is looked at. */
  readonly normal: Vec3;
  readonly uv: readonly [u: number, v: number];
}

export function surfaceAt(scene: TracedScene, hit: Hit): SurfacePoint {
  const { mesh } = scene.objects[hit.object];
  const material = materialOf(scene, hit);
  const corners = cornersOf(scene, hit);
  const uv = uvAt(mesh.uvs, corners);
  const base = baseColor(material, uv);
  const painted = mesh.colors ? blended(corners, (i) => pointAt(mesh.colors!, i)) : undefined;
  const [r, g, b, opacity] = base;
  const { roughness, metallic, ior = 1.5 } = material;
  return {
    albedo: painted ? [r * painted[0], g * painted[1], b * painted[2]] : [r, g, b],
    opacity,
    emissive: emission(material, uv),
    roughness,
    metallic,
    ior,
    normal: normalAt(scene, hit, corners),
    uv,
  };
}

/** Opacity alone: all that a ray which only passes by needs to know. */
export function opacityAt(scene: TracedScene, hit: Hit): number {
  const material = materialOf(scene, hit);
  if (!material.baseColorTexture) return material.opacity;
  return baseColor(material, uvAt(scene.objects[hit.object].mesh.uvs, cornersOf(scene, hit)))[3];
}

/** The corners of a triangle that is hit. */
export interface Corners {
  /** Vertices of the mesh. */
  readonly indices: readonly [number, number, number];
  readonly weights: Vec3;
}

export function cornersOf({ objects }: TracedScene, { object, corner, v, w }: Hit): Corners {
  const { indices } = objects[object].mesh;
  return { indices: [indices[corner], indices[corner + 1], indices[corner + 2]], weights: [1 - v - w, v, w] };
}

function blended({ indices, weights }: Corners, of: (vertex: number) => Vec3): Vec3 {
  const [a, b, c] = [of(indices[0]), of(indices[1]), of(indices[2])];
  const [p, q, r] = weights;
  return [a[0] * p + b[0] * q + c[0] * r, a[1] * p + b[1] * q + c[1] * r, a[2] * p + b[2] * q + c[2] * r];
}

function uvAt(uvs: Float32Array, { indices: [i, j, k], weights: [p, q, r] }: Corners): readonly [number, number] {
  const part = (n: number) => uvs[2 * i + n] * p + uvs[2 * j + n] * q + uvs[2 * k + n] * r;
  return [part(0), part(1)];
}

function baseColor({ baseColor: [r, g, b], opacity, baseColorTexture }: Material, uv: readonly [number, number]): Rgba {
  if (!baseColorTexture) return [r, g, b, opacity];
  const [tr, tg, tb, ta] = sampleTexture(baseColorTexture, ...uv);
  return [r * tr, g * tg, b * tb, opacity * ta];
}

function emission({ emissive, emissiveTexture }: Material, uv: readonly [number, number]): Vec3 {
  if (!emissiveTexture) return emissive;
  const [r, g, b] = sampleTexture(emissiveTexture, ...uv);
  return [emissive[0] * r, emissive[1] * g, emissive[2] * b];
}

/**
 * The surface is a plane of events, whose normal has no time part in the rest frame: one of the world's slice loses the factor γ
 * along the motion. Where interpolated normals cancel, the triangle's own. Which side is which the triangle tells, for there are
 * files whose normals point to the other one, and light that starts on the wrong side of a wall comes through it.
 */
function normalAt({ objects }: TracedScene, hit: Hit, corners: Corners): Vec3 {
  const object = objects[hit.object];
  const given = blended(corners, normalsAt(object, hit.time));
  const ofWorld = 'times' in object.motion || (object.authoredIn === 'world' && object.motion.kind !== 'static');
  const rest = ofWorld ? contraction(given, properVelocity(hit.velocity)) : given;
  return towards(sideOf(hit), normalize(rest, hit.normal));
}

/** The triangle's own normal on the side that is looked at. */
export const sideOf = ({ front, normal }: Hit): Vec3 => (front ? normal : negate(normal));

/** n or −n, whichever is on the side. */
export const towards = (side: Vec3, n: Vec3): Vec3 => (dot(side, n) < 0 ? negate(n) : n);

/** Vertex → normal as the object has it at world time t, on the world's axes, not unit. */
export function normalsAt({ mesh, motion }: SceneObject, t: number): (vertex: number) => Vec3 {
  const own = (i: number): Vec3 => pointAt(mesh.normals, i);
  switch (motion.kind) {
    case 'sampled': {
      const { before, after, s } = pieceAt(motion.times, t);
      const [a, b] = [samplePose(motion.poses, before).orientation, samplePose(motion.poses, after).orientation];
      return (i) => lerp(rotate(a, own(i)), rotate(b, own(i)), s);
    }
    case 'sampled-points': {
      const { before, after, s } = pieceAt(motion.times, t);
      const [a, b] = [normalsAtSample(motion, before), normalsAtSample(motion, after)];
      if (!a || !b) return own;
      return (i) => lerp(pointAt(a, i), pointAt(b, i), s);
    }
    default:
      return (i) => rotate(motion.pose.orientation, own(i));
  }
}
