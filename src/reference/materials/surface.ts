import { addScaled, cross, dot, negate, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { boost, properVelocity } from '../../physics/lorentz/boost.ts';
import { fourVector, spatial } from '../../physics/lorentz/fourVector.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { type Rgba, sampleTexture } from '../../scene/materials/sampleTexture.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { quadricOf } from '../../scene/mesh/quadric.ts';
import type {
  Anisotropy,
  Iridescence,
  Material,
  NormalTexture,
  SceneObject,
  Texture,
  TextureChannel,
} from '../../scene/types.ts';
import { filterOfReflectance } from '../../spectrum/color/filterOfReflectance.ts';
import { filterFromRgb, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import type { Hit } from '../acceleration/ray.ts';
import { motionTracer } from '../intersection/motionTracers.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import { materialOf } from './material.ts';

/** The material and shading normal at a hit. Colours are linear sRGB. */
export interface SurfacePoint {
  readonly albedo: Vec3;
  /** The same with the reflectance of invisible light. */
  readonly filter: SpectralFilter;
  readonly opacity: number;
  /** Radiance. */
  readonly emissive: Vec3;
  /** [K], if it emits as a blackbody; then `emissive` gives the luminance. */
  readonly temperature?: number;
  readonly roughness: number;
  readonly metallic: number;
  /** Fraction of the light of the sky and of other surfaces that reaches it. */
  readonly occlusion: number;
  /** Refractive index; default 1.5. */
  readonly ior: number;
  /** Strength of its reflection, and the linear sRGB factor of F₀; absent: 1. */
  readonly specular?: { readonly factor: number; readonly color: Vec3 };
  /** Its grooves: the direction in which they widen its reflection, of unit length in the rest frame, and how much, 0 … 1. */
  readonly grooves?: { readonly along: Vec3; readonly strength: number };
  /** The varnish over it, with a normal of its own. */
  readonly clearcoat?: { readonly factor: number; readonly roughness: number; readonly normal: Vec3 };
  /** Fuzz over it, under the varnish; linear sRGB. */
  readonly sheen?: { readonly color: Vec3; readonly roughness: number };
  /** A thin film over it; thickness in metres. */
  readonly film?: { readonly factor: number; readonly ior: number; readonly thickness: number };
  /** How much of what it does not reflect passes it, 0 … 1; absent: 0. */
  readonly transmission?: number;
  /** Unit normal in the rest frame, on the world axes carried there by the pure boost; on the side of the ray. */
  readonly normal: Vec3;
  readonly uv: readonly [u: number, v: number];
}

export function surfaceAt(scene: TracedScene, hit: Hit): SurfacePoint {
  const { mesh } = scene.objects[hit.object];
  const material = materialOf(scene, hit);
  const corners = verticesOf(scene, hit);
  const uv = uvAt(mesh.uvs, corners);
  const base = baseColor(material, uv);
  const vertexColor = mesh.colors ? interpolate(corners, (i) => pointAt(mesh.colors!, i)) : undefined;
  const [r, g, b, opacity] = base;
  const albedo = vertexColor ? tinted([r, g, b], vertexColor) : ([r, g, b] as const);
  const emissive = colorAt(material.emissive, material.emissiveTexture, uv);
  const {
    ior = 1.5,
    emissionTemperature: temperature,
    specular,
    anisotropy,
    clearcoat,
    sheen,
    iridescence,
    transmission,
  } = material;
  const normal = normalAt(scene, hit, corners, material.normalTexture, uv);
  const grooves = anisotropy && groovesAt(anisotropy, normal, tangentFrame(scene, hit, corners), uv);
  return {
    albedo,
    filter: filterAt(material, albedo, vertexColor !== undefined, uv),
    opacity,
    emissive: material.unlit && vertexColor ? tinted(emissive, vertexColor) : emissive,
    ...(temperature !== undefined && { temperature }),
    roughness: numberAt(material.roughness, material.roughnessTexture, uv),
    metallic: numberAt(material.metallic, material.metallicTexture, uv),
    occlusion: numberAt(1, material.occlusionTexture, uv),
    ior,
    ...(specular && {
      specular: {
        factor: numberAt(specular.factor, specular.factorTexture, uv),
        color: colorAt(specular.color, specular.colorTexture, uv),
      },
    }),
    ...(grooves && { grooves }),
    ...(clearcoat && {
      clearcoat: {
        factor: numberAt(clearcoat.factor, clearcoat.factorTexture, uv),
        roughness: numberAt(clearcoat.roughness, clearcoat.roughnessTexture, uv),
        normal: normalAt(scene, hit, corners, clearcoat.normalTexture, uv),
      },
    }),
    ...(sheen && {
      sheen: {
        color: colorAt(sheen.color, sheen.colorTexture, uv),
        roughness: numberAt(sheen.roughness, sheen.roughnessTexture, uv),
      },
    }),
    ...(iridescence && { film: filmAt(iridescence, uv) }),
    ...(transmission && { transmission: numberAt(transmission.factor, transmission.factorTexture, uv) }),
    normal,
    uv,
  };
}

const tinted = (a: Vec3, b: Vec3): Vec3 => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

/** The measured reflectance, unless textures or vertex colours override it. */
function filterAt(material: Material, albedo: Vec3, hasVertexColor: boolean, uv: Uv): SpectralFilter {
  const { reflectance, baseColorTexture, uvTexture, irTexture } = material;
  const bare = !hasVertexColor && !baseColorTexture && !uvTexture && !irTexture;
  if (reflectance && bare) return filterOfReflectance(reflectance);
  return filterFromRgb(
    albedo,
    invisibleReflectance(material.uv, uvTexture, uv),
    invisibleReflectance(material.ir, irTexture, uv),
  );
}

/** Undefined where uvs give no direction. */
function groovesAt(
  { strength, rotation, directionTexture: texture }: Anisotropy,
  N: Vec3,
  [alongU, alongV]: TangentFrame,
  uv: Uv,
): SurfacePoint['grooves'] {
  const T = normalize(addScaled(alongU, N, -dot(N, alongU)), ZERO);
  if (dot(T, T) === 0) return undefined;
  const across = cross(N, T);
  const B = scale(across, dot(across, alongV) < 0 ? -1 : 1);
  const [r, g, b] = texture ? sampleTexture(texture, ...uv) : [1, 0.5, 1];
  const [x, y] = [2 * r - 1, 2 * g - 1];
  const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
  const along = normalize(addScaled(scale(T, c * x - s * y), B, s * x + c * y), T);
  return { along, strength: strength * b };
}

function filmAt({ factor, factorTexture, ior, thickness, thicknessTexture }: Iridescence, uv: Uv) {
  const [thinnest, thickest] = thickness;
  const share = numberAt(1, thicknessTexture, uv);
  return { factor: numberAt(factor, factorTexture, uv), ior, thickness: thinnest + share * (thickest - thinnest) };
}

type Uv = readonly [u: number, v: number];

function numberAt(value: number, from: TextureChannel | undefined, uv: Uv): number {
  if (!from) return value;
  return Math.min(1, Math.max(0, from.scale * sampleTexture(from.texture, ...uv)[from.channel] + from.bias));
}

/** Reflectance of invisible light; undefined if neither material nor texture gives it. */
const invisibleReflectance = (
  value: number | undefined,
  from: TextureChannel | undefined,
  uv: Uv,
): number | undefined => (from ? numberAt(0, from, uv) : value);

/** The opacity of `surfaceAt` alone, which is all that shadow rays need. */
export function opacityAt(scene: TracedScene, hit: Hit): number {
  const material = materialOf(scene, hit);
  if (!material.baseColorTexture) return material.opacity;
  return baseColor(material, uvAt(scene.objects[hit.object].mesh.uvs, verticesOf(scene, hit)))[3];
}

/** The corners of the hit triangle. */
export interface TriangleVertices {
  /** Vertex indices of the mesh. */
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

function colorAt(factor: Vec3, texture: Texture | undefined, uv: Uv): Vec3 {
  if (!texture) return factor;
  const [r, g, b] = sampleTexture(texture, ...uv);
  return [factor[0] * r, factor[1] * g, factor[2] * b];
}

/**
 * The rest-frame normal: that of a round solid itself, otherwise the interpolated one. A normal given on a slice of world time loses the factor γ along the motion (docs/physics.md §6.3). Where interpolated
 * normals cancel, the triangle's own is used. The triangle also determines the side, because some files have normals that point to the other
 * side, and rays that start on the wrong side of a wall would leak through it.
 */
function normalAt(
  scene: TracedScene,
  hit: Hit,
  corners: TriangleVertices,
  map: NormalTexture | undefined,
  uv: Uv,
): Vec3 {
  const object = scene.objects[hit.object];
  const smooth = quadricOf(object) ? hit.normal : interpolatedNormal(object, hit, corners);
  const side = facingNormal(hit);
  if (!map) return faceForward(side, smooth);
  const mapped = mappedNormal(map, uv, smooth, tangentFrame(scene, hit, corners));
  return dot(side, smooth) < 0 ? negate(mapped) : mapped;
}

function interpolatedNormal(object: SceneObject, hit: Hit, corners: TriangleVertices): Vec3 {
  const given = interpolate(corners, motionTracer(object.motion).vertexNormals(object, hit.time));
  const rest = motionTracer(object.motion).isAuthoredMoving(object)
    ? contraction(given, properVelocity(hit.velocity))
    : given;
  return normalize(rest, hit.normal);
}

/** Directions of increasing u and v in the rest frame, of any length; 0 if the uvs are degenerate. */
type TangentFrame = readonly [u: Vec3, v: Vec3];

/** The separation of two surface points at one world time is longer by γ along the motion in the rest frame. */
function tangentFrame({ objects, c }: TracedScene, hit: Hit, { indices }: TriangleVertices): TangentFrame {
  const object = objects[hit.object];
  const { uvs } = object.mesh;
  const place = motionTracer(object.motion).vertexPlaces(object, hit.time, c);
  const [a, b, d] = indices.map(place);
  const u = properVelocity(hit.velocity);
  const isAuthoredMoving = motionTracer(object.motion).isAuthoredMoving(object);
  const edge = (to: Vec3): Vec3 => (isAuthoredMoving ? spatial(boost(fourVector(0, sub(to, a)), u)) : sub(to, a));
  const [p, q] = [edge(b), edge(d)];
  const [pu, pv, qu, qv] = [1, 2].flatMap((k) => [0, 1].map((n) => uvs[2 * indices[k] + n] - uvs[2 * indices[0] + n]));
  const side = Math.sign(pu * qv - pv * qu);
  return [scale(addScaled(scale(p, qv), q, -pv), side), scale(addScaled(scale(q, pu), p, -qu), side)];
}

/** The unit normal N perturbed by a normal map (`NormalTexture` in scene/types.ts). */
function mappedNormal({ texture, strength }: NormalTexture, uv: Uv, N: Vec3, [alongU, alongV]: TangentFrame): Vec3 {
  const T = normalize(addScaled(alongU, N, -dot(N, alongU)), ZERO);
  const B = cross(N, T);
  const [r, g, b] = sampleTexture(texture, ...uv);
  const [x, y] = [strength[0] * (2 * r - 1), strength[1] * (2 * g - 1) * Math.sign(dot(B, alongV))];
  return dot(T, T) > 0 ? normalize(addScaled(addScaled(scale(N, 2 * b - 1), T, x), B, y), N) : N;
}

/** The triangle's normal on the side of the ray. */
export const facingNormal = ({ front, normal }: Hit): Vec3 => (front ? normal : negate(normal));

/** n or −n, whichever is on the side of the normal `side`. */
export const faceForward = (side: Vec3, n: Vec3): Vec3 => (dot(side, n) < 0 ? negate(n) : n);
