import { addScaled, cross, dot, negate, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { boost, properVelocity } from '../../physics/lorentz/boost.ts';
import { fourVector, spatial } from '../../physics/lorentz/fourVector.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { type Rgba, sampleTexture } from '../../scene/materials/sampleTexture.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import type { Material, NormalTexture, TextureChannel } from '../../scene/types.ts';
import { filterOfReflectance } from '../../spectrum/color/filterOfReflectance.ts';
import { filterFromRgb, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import type { Hit } from '../acceleration/ray.ts';
import { motionTracer } from '../intersection/motionTracers.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import { materialOf } from './material.ts';

/** What a surface is where a ray meets it. Colours are linear sRGB. */
export interface SurfacePoint {
  readonly albedo: Vec3;
  /** The same, with what it reflects of invisible light. */
  readonly filter: SpectralFilter;
  readonly opacity: number;
  /** Radiance. */
  readonly emissive: Vec3;
  /** [K], where it shines as a blackbody; `emissive` tells its luminance then. */
  readonly temperature?: number;
  readonly roughness: number;
  readonly metallic: number;
  /** Share of the light of the sky and of other surfaces that gets to it. */
  readonly occlusion: number;
  /** Refractive index; 1.5 where the scene does not tell. */
  readonly ior: number;
  /** Interpolated unit normal in the rest frame, on the world axes that the pure boost carries there; towards the side that is looked at. */
  readonly normal: Vec3;
  readonly uv: readonly [u: number, v: number];
}

export function surfaceAt(scene: TracedScene, hit: Hit): SurfacePoint {
  const { mesh } = scene.objects[hit.object];
  const material = materialOf(scene, hit);
  const corners = verticesOf(scene, hit);
  const uv = uvAt(mesh.uvs, corners);
  const base = baseColor(material, uv);
  const painted = mesh.colors ? interpolate(corners, (i) => pointAt(mesh.colors!, i)) : undefined;
  const [r, g, b, opacity] = base;
  const albedo: Vec3 = painted ? [r * painted[0], g * painted[1], b * painted[2]] : [r, g, b];
  const { ior = 1.5, emissionTemperature: temperature } = material;
  return {
    albedo,
    filter: filterAt(material, albedo, painted !== undefined, uv),
    opacity,
    emissive: emission(material, uv),
    ...(temperature !== undefined && { temperature }),
    roughness: numberAt(material.roughness, material.roughnessTexture, uv),
    metallic: numberAt(material.metallic, material.metallicTexture, uv),
    occlusion: numberAt(1, material.occlusionTexture, uv),
    ior,
    normal: normalAt(scene, hit, corners, material.normalTexture, uv),
    uv,
  };
}

/** A measured reflectance, where nothing is painted over it. */
function filterAt(material: Material, albedo: Vec3, painted: boolean, uv: Uv): SpectralFilter {
  const { reflectance, baseColorTexture, uvTexture, irTexture } = material;
  const bare = !painted && !baseColorTexture && !uvTexture && !irTexture;
  if (reflectance && bare) return filterOfReflectance(reflectance);
  return filterFromRgb(
    albedo,
    invisibleReflectance(material.uv, uvTexture, uv),
    invisibleReflectance(material.ir, irTexture, uv),
  );
}

type Uv = readonly [u: number, v: number];

function numberAt(value: number, from: TextureChannel | undefined, uv: Uv): number {
  if (!from) return value;
  return Math.min(1, Math.max(0, from.scale * sampleTexture(from.texture, ...uv)[from.channel] + from.bias));
}

/** Reflectance of invisible light, where the material or a picture tells. */
const invisibleReflectance = (
  value: number | undefined,
  from: TextureChannel | undefined,
  uv: Uv,
): number | undefined => (from ? numberAt(0, from, uv) : value);

/** Opacity alone: all that a ray which only passes by needs to know. */
export function opacityAt(scene: TracedScene, hit: Hit): number {
  const material = materialOf(scene, hit);
  if (!material.baseColorTexture) return material.opacity;
  return baseColor(material, uvAt(scene.objects[hit.object].mesh.uvs, verticesOf(scene, hit)))[3];
}

/** The corners of a triangle that is hit. */
export interface TriangleVertices {
  /** Vertices of the mesh. */
  readonly indices: readonly [number, number, number];
  readonly weights: Vec3;
}

export function verticesOf({ objects }: TracedScene, { object, corner, v, w }: Hit): TriangleVertices {
  const { indices } = objects[object].mesh;
  return { indices: [indices[corner], indices[corner + 1], indices[corner + 2]], weights: [1 - v - w, v, w] };
}

function interpolate({ indices, weights }: TriangleVertices, of: (vertex: number) => Vec3): Vec3 {
  const [a, b, c] = [of(indices[0]), of(indices[1]), of(indices[2])];
  const [p, q, r] = weights;
  return [a[0] * p + b[0] * q + c[0] * r, a[1] * p + b[1] * q + c[1] * r, a[2] * p + b[2] * q + c[2] * r];
}

function uvAt(
  uvs: Float32Array,
  { indices: [i, j, k], weights: [p, q, r] }: TriangleVertices,
): readonly [number, number] {
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
function normalAt(
  scene: TracedScene,
  hit: Hit,
  corners: TriangleVertices,
  map: NormalTexture | undefined,
  uv: Uv,
): Vec3 {
  const object = scene.objects[hit.object];
  const given = interpolate(corners, motionTracer(object.motion).vertexNormals(object, hit.time));
  const rest = motionTracer(object.motion).isAuthoredMoving(object)
    ? contraction(given, properVelocity(hit.velocity))
    : given;
  const smooth = normalize(rest, hit.normal);
  const side = facingNormal(hit);
  if (!map) return faceForward(side, smooth);
  const bent = mappedNormal(map, uv, smooth, tangentFrame(scene, hit, corners));
  return dot(side, smooth) < 0 ? negate(bent) : bent;
}

/** Along rising u and v, in the rest frame; of any length, 0 where the uvs tell no direction. */
type TangentFrame = readonly [u: Vec3, v: Vec3];

/** What is between two points of a surface at one world time is longer in its rest frame, by γ along the motion. */
function tangentFrame({ objects, c }: TracedScene, hit: Hit, { indices }: TriangleVertices): TangentFrame {
  const object = objects[hit.object];
  const { uvs } = object.mesh;
  const place = motionTracer(object.motion).vertexPlaces(object, hit.time, c);
  const [a, b, d] = indices.map(place);
  const u = properVelocity(hit.velocity);
  const written = motionTracer(object.motion).isAuthoredMoving(object);
  const edge = (to: Vec3): Vec3 => (written ? spatial(boost(fourVector(0, sub(to, a)), u)) : sub(to, a));
  const [p, q] = [edge(b), edge(d)];
  const [pu, pv, qu, qv] = [1, 2].flatMap((k) => [0, 1].map((n) => uvs[2 * indices[k] + n] - uvs[2 * indices[0] + n]));
  const side = Math.sign(pu * qv - pv * qu);
  return [scale(addScaled(scale(p, qv), q, -pv), side), scale(addScaled(scale(q, pu), p, -qu), side)];
}

/** The unit normal that a picture makes of N (scene/types.ts, NormalTexture). */
function mappedNormal({ texture, strength }: NormalTexture, uv: Uv, N: Vec3, [alongU, alongV]: TangentFrame): Vec3 {
  const T = normalize(addScaled(alongU, N, -dot(N, alongU)), ZERO);
  const B = cross(N, T);
  const [r, g, b] = sampleTexture(texture, ...uv);
  const [x, y] = [strength[0] * (2 * r - 1), strength[1] * (2 * g - 1) * Math.sign(dot(B, alongV))];
  return dot(T, T) > 0 ? normalize(addScaled(addScaled(scale(N, 2 * b - 1), T, x), B, y), N) : N;
}

/** The triangle's own normal on the side that is looked at. */
export const facingNormal = ({ front, normal }: Hit): Vec3 => (front ? normal : negate(normal));

/** n or −n, whichever is on the side. */
export const faceForward = (side: Vec3, n: Vec3): Vec3 => (dot(side, n) < 0 ? negate(n) : n);
