import {
  clamp,
  Discard,
  dot,
  Fn,
  faceDirection,
  int,
  length,
  mix,
  mrt,
  normalize,
  property,
  round,
  select,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { DataTexture, MRTNode } from 'three/webgpu';
import type { Material, TextureChannel } from '../../scene/types.ts';
import { ontoLightCone } from '../../shaders/emission/ontoLightCone.ts';
import { dopplerFactor } from '../../shaders/kinematics/dopplerFactor.ts';
import type { Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import { BASIS_ENDS } from '../../spectrum/reflectance/spectralFilter.ts';
import { vColor, vEvent, vLife, vMotion, vNormal, vObserverPosition, vUv } from '../geometry/vertexStage.ts';
import type { Texels } from '../gpu/floatTable.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { sampled } from '../gpu/textures.ts';
import { mappedNormal } from './normalMap.ts';
import {
  type Emission,
  emissionOf,
  packEmission,
  packNormals,
  packRoughnessAndOcclusion,
  packSpecular,
  type SpecularParameters,
} from './surfacePacking.ts';

/**
 * Texels per material in the material table: (base colour, opacity), (emission, opacity threshold), (scale and bias of roughness, of metallic),
 * (F₀, reflectance below 360 nm and beyond 830 nm, temperature of its emission [K]), (strength of its normals along u and v, scale and bias of its occlusion), (scale and bias of both reflectances of invisible light).
 */
export const MATERIAL_TEXELS = 6;
/** Where the reflectance of invisible light is that of the visible colour's ends. */
const UNSPECIFIED = -1;

export function materialTexels(m: Material): readonly number[] {
  const { uv = UNSPECIFIED, ir = UNSPECIFIED, ior = DEFAULT_IOR, emissionTemperature = 0, normalTexture } = m;
  return [
    ...[...m.baseColor, m.opacity],
    ...[...m.emissive, m.opacityThreshold],
    ...[...linear(m.roughness, m.roughnessTexture), ...linear(m.metallic, m.metallicTexture)],
    ...[((ior - 1) / (ior + 1)) ** 2, uv, ir, emissionTemperature],
    ...[...(normalTexture?.strength ?? [0, 0]), ...linear(1, m.occlusionTexture)],
    ...[...linear(0, m.uvTexture), ...linear(0, m.irTexture)],
  ].map((x) => Math.max(-MAX_TEXEL, Math.min(MAX_TEXEL, x)));
}

/** Scale and bias of a texel; of a number, what makes it of any texel. */
const linear = (value: number, from: TextureChannel | undefined): readonly number[] =>
  from ? [from.scale, from.bias] : [0, value];

/** Refractive index where none is told. */
const DEFAULT_IOR = 1.5;
/** f32 holds it, and its products. */
const MAX_TEXEL = 1e18;

export interface SurfaceSources {
  readonly materials: Texels;
  readonly uniforms: FrameUniforms;
  readonly textures: SurfaceTextures;
  readonly colored: boolean;
}

/** Pictures of a material on the GPU. */
export interface SurfaceTextures {
  readonly baseColor?: DataTexture;
  readonly emissive?: DataTexture;
  readonly normal?: DataTexture;
  readonly roughness?: ChannelTexture;
  readonly metallic?: ChannelTexture;
  readonly occlusion?: ChannelTexture;
  readonly uv?: ChannelTexture;
  readonly ir?: ChannelTexture;
}
export interface ChannelTexture {
  readonly texture: DataTexture;
  readonly channel: TextureChannel['channel'];
}

/** (v, 1 − v²) */
const ZERO_VELOCITY = vec4(0, 0, 0, 1);

/** What is known of the surface at a fragment. */
export interface Surface extends SpecularParameters {
  /** Linear sRGB and opacity. */
  readonly color: Vec4;
  /** Reflectance below 360 nm and beyond 830 nm. */
  readonly invisible: Vec2;
  readonly emission: Emission;
  readonly roughness: Float;
  /** Share of the sky's light that gets to it, 0 … 1. */
  readonly occlusion: Float;
  /** Unit, rest frame, towards the observer's side. */
  readonly normal: Vec3;
  readonly dx: Vec3;
  /** c(t − t_o) [m of light] */
  readonly time: Float;
  readonly velocity: Vec4;
  readonly D: Float;
  readonly object: Float;
  /** Apparent distance |Δx′| [m]. */
  readonly distance: Float;
}
/** Reads the surface inside a fragment's Fn, after discarding what is not there: outside the lifetime, cut out, or never seen. */
export function readSurface(sources: SurfaceSources): Surface {
  const { textures } = sources;
  const material = int(round(vLife.w)).mul(int(MATERIAL_TEXELS)).toVar();
  const [base, glow, numbers, more, relief, unseen] = [0, 1, 2, 3, 4, 5].map((k) =>
    sources.materials.texel(material.add(int(k))),
  );
  const color = base.toVar();
  if (textures.baseColor) color.mulAssign(sampled(textures.baseColor, vUv));
  if (sources.colored) color.mulAssign(vec4(vColor, 1));
  const emissive = glow.xyz.toVar();
  if (textures.emissive) emissive.mulAssign(sampled(textures.emissive, vUv).rgb);
  const finish = numbers.toVar();
  const mirror = more.toVar();

  const { u, gamma, boostLight, onLightCone } = sources.uniforms;
  const velocity = vMotion.toVar();
  // Between the vertices the events are interpolated, and beside the light cone: each is that of the point which is painted here.
  const event = select(onLightCone.greaterThan(0.5), ontoLightCone(vEvent, velocity), vEvent).toVar();
  const smooth = normalize(vNormal.xyz).toVar();
  const ground = { normal: smooth, event, velocity, uv: vUv };
  // Before anything is discarded: it compares this fragment with its neighbours.
  const normal = textures.normal ? mappedNormal(textures.normal, relief.xy, ground).toVar() : smooth;
  const later = event.w.sub(vEvent.w).toVar();
  const alive = vLife.x.add(later).greaterThanEqual(0).and(vLife.y.sub(later).greaterThanEqual(0));
  Discard(alive.not().or(vNormal.w.lessThan(0.9999)).or(color.w.lessThan(glow.w)));
  const dx = event.xyz.toVar();
  const D = mix(1, dopplerFactor(dx, u, gamma, velocity), boostLight);
  return {
    color,
    invisible: vec2(
      textures.uv ? channel(textures.uv, unseen.xy) : reflectanceOrEnds(mirror.y, BASIS_ENDS.uv, color.rgb),
      textures.ir ? channel(textures.ir, unseen.zw) : reflectanceOrEnds(mirror.z, BASIS_ENDS.ir, color.rgb),
    ),
    emission: emissionOf(emissive, mirror.w),
    roughness: channel(textures.roughness, finish.xy),
    occlusion: channel(textures.occlusion, relief.zw),
    metallic: channel(textures.metallic, finish.zw),
    F0: mirror.x,
    normal: normal.mul(faceDirection),
    dx,
    time: event.w,
    velocity,
    D,
    object: round(vLife.z),
    distance: distanceOf(dx, sources.uniforms),
  };
}

/** A reflectance as it is told, or what the colour ends at. */
const reflectanceOrEnds = (share: Float, ends: readonly [number, number, number], rgb: Vec3): Float =>
  select(share.lessThan(0), dot(rgb, vec3(...ends)), share);

function channel(from: ChannelTexture | undefined, linear: Vec2): Float {
  if (!from) return linear.y;
  const texel = sampled(from.texture, vUv);
  const value = [texel.x, texel.y, texel.z, texel.w][from.channel];
  return clamp(value.mul(linear.x).add(linear.y), 0, 1);
}

/** |Δx′| = (γ + u·n)|Δx| of the event itself; where directions are not boosted, places between the vertices are those of the events, or linear. */
function distanceOf(dx: Vec3, { u, gamma, boosted, onLightCone }: SurfaceSources['uniforms']): Float {
  const r = length(dx).toVar();
  const still = select(onLightCone.greaterThan(0.5), r, length(vObserverPosition));
  return select(boosted.greaterThan(0.5), r.mul(dopplerFactor(dx, u, gamma, ZERO_VELOCITY)), still);
}

/** The G-buffer's targets, in the order of their attachments; bytes per sample as WebGPU counts them. */
export const GBUFFER_TARGETS = {
  base: 8,
  emissive: 8,
  normal: 8,
  object: 8,
  event: 16,
  motion: 16,
} as const;
export type TargetName = keyof typeof GBUFFER_TARGETS;

/** Writes the named targets of a fragment. The first output reads the surface and leaves the others in properties. */
export function surfaceOutputs(sources: SurfaceSources, names: readonly TargetName[]): MRTNode {
  const kept = names.map((name) => property('vec4', `g_${name}`));
  const first = Fn(() => {
    const values = targetValues(readSurface(sources));
    for (const [i, name] of names.entries()) kept[i].assign(values[name]);
    return kept[0];
  })();
  return mrt(Object.fromEntries(names.map((name, i) => [name, i === 0 ? first : kept[i]])));
}

const targetValues = (surface: Surface): Record<TargetName, Vec4> => ({
  base: vec4(surface.color.rgb, packRoughnessAndOcclusion(surface.roughness, surface.occlusion)),
  emissive: vec4(packEmission(surface.emission), packSpecular(surface)),
  normal: packNormals(surface.normal, surface.invisible),
  object: vec4(surface.object, surface.distance, 0, 1),
  event: vec4(surface.dx, surface.time),
  motion: vec4(surface.velocity.xyz, surface.D),
});
