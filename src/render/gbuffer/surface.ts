import {
  clamp,
  Discard,
  dot,
  Fn,
  faceDirection,
  If,
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
import { apparentPosition } from '../../shaders/kinematics/apparentPosition.ts';
import { dopplerFactor } from '../../shaders/kinematics/dopplerFactor.ts';
import { ontoShallowCone } from '../../shaders/shallowCone/ontoShallowCone.ts';
import { shallowPosition } from '../../shaders/shallowCone/shallowPosition.ts';
import type { Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import { BASIS_ENDS } from '../../spectrum/reflectance/spectralFilter.ts';
import {
  triangleExists,
  vCameraPosition,
  vColor,
  vEvent,
  vLife,
  vMotion,
  vNormal,
  vUv,
} from '../geometry/vertexStage.ts';
import type { Texels } from '../gpu/floatTable.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { sampled } from '../gpu/textures.ts';
import { mappedNormal, type UvDirections, uvDirections } from './normalMap.ts';
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
 * Texels per material in the material table: (base colour, opacity), (emission, opacity threshold), (scale and bias of roughness, of metallic), (F₀,
 * reflectance below 360 nm and beyond 830 nm, temperature of its emission [K] or UNLIT), (strength of its normal map along u and v, scale and bias of its occlusion),
 * (scale and bias of both invisible reflectances).
 */
export const MATERIAL_TEXELS = 6;
/** In place of a temperature: vertex colours tint the emission. */
const UNLIT = -1;
/** Marks an invisible reflectance that is extrapolated from the visible colour. */
const UNSPECIFIED = -1;

export function materialTexels(m: Material): readonly number[] {
  const { uv = UNSPECIFIED, ir = UNSPECIFIED, ior = DEFAULT_IOR, emissionTemperature = 0, normalTexture } = m;
  return [
    ...[...m.baseColor, m.opacity],
    ...[...m.emissive, m.opacityThreshold],
    ...[...linear(m.roughness, m.roughnessTexture), ...linear(m.metallic, m.metallicTexture)],
    ...[((ior - 1) / (ior + 1)) ** 2, uv, ir, m.unlit ? UNLIT : emissionTemperature],
    ...[...(normalTexture?.strength ?? [0, 0]), ...linear(1, m.occlusionTexture)],
    ...[...linear(0, m.uvTexture), ...linear(0, m.irTexture)],
  ].map((x) => Math.max(-MAX_TEXEL, Math.min(MAX_TEXEL, x)));
}

/** Scale and bias for a texel of the texture; without a texture, those that give `value`. */
const linear = (value: number, from: TextureChannel | undefined): readonly number[] =>
  from ? [from.scale, from.bias] : [0, value];

/** Refractive index by default. */
const DEFAULT_IOR = 1.5;
/** f32 can hold it and its products. */
const MAX_TEXEL = 1e18;

export interface SurfaceSources {
  readonly materials: Texels;
  readonly uniforms: FrameUniforms;
  readonly textures: SurfaceTextures;
  readonly colored: boolean;
}

/** Textures of a material on the GPU. */
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

/** The shaded surface at a fragment. */
export interface Surface extends SpecularParameters {
  /** Linear sRGB and opacity. */
  readonly color: Vec4;
  /** Reflectance below 360 nm and beyond 830 nm. */
  readonly invisible: Vec2;
  readonly emission: Emission;
  readonly roughness: Float;
  /** Fraction of the sky's light that reaches it, 0 … 1. */
  readonly occlusion: Float;
  /** Unit normal in the rest frame, on the observer's side. */
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
/** Reads the surface inside a fragment's Fn, after discarding fragments that do not exist: outside the lifetime, cut out, or never seen. */
export function readSurface(sources: SurfaceSources): Surface {
  const { textures } = sources;
  const material = int(round(vLife.w)).mul(int(MATERIAL_TEXELS)).toVar();
  const [base, glow, roughnessMetallicTexel, reflectancesTexel, normalOcclusion, invisibleChannels] = [
    0, 1, 2, 3, 4, 5,
  ].map((k) => sources.materials.texel(material.add(int(k))));
  const color = base.toVar();
  if (textures.baseColor) color.mulAssign(sampled(textures.baseColor, vUv));
  if (sources.colored) color.mulAssign(vec4(vColor, 1));
  const emissive = glow.xyz.toVar();
  if (textures.emissive) emissive.mulAssign(sampled(textures.emissive, vUv).rgb);
  const roughnessMetallic = roughnessMetallicTexel.toVar();
  const reflectances = reflectancesTexel.toVar();
  if (sources.colored) emissive.mulAssign(select(reflectances.w.lessThan(0), vColor, vec3(1)));

  const { u, gamma, boostLight } = sources.uniforms;
  const velocity = vMotion.toVar();
  const event = seenEvent(velocity, sources.uniforms);
  const smooth = normalize(vNormal.xyz).toVar();
  const mapSurface = { normal: smooth, event, velocity, uv: vUv };
  // Before any discard, because it needs derivatives between neighbouring fragments.
  const normal = textures.normal ? mappedNormal(textures.normal, normalOcclusion.xy, mapSurface).toVar() : smooth;
  const delay = event.w.sub(vEvent.w).toVar();
  const alive = vLife.x.add(delay).greaterThanEqual(0).and(vLife.y.sub(delay).greaterThan(0));
  Discard(alive.not().or(triangleExists().not()).or(color.w.lessThan(glow.w)));
  const dx = event.xyz.toVar();
  const D = mix(1, dopplerFactor(dx, u, gamma, velocity), boostLight);
  return {
    color,
    invisible: vec2(
      textures.uv
        ? channelValue(textures.uv, invisibleChannels.xy)
        : reflectanceOrEnds(reflectances.y, BASIS_ENDS.uv, color.rgb),
      textures.ir
        ? channelValue(textures.ir, invisibleChannels.zw)
        : reflectanceOrEnds(reflectances.z, BASIS_ENDS.ir, color.rgb),
    ),
    emission: emissionOf(emissive, reflectances.w),
    roughness: channelValue(textures.roughness, roughnessMetallic.xy),
    occlusion: channelValue(textures.occlusion, normalOcclusion.zw),
    metallic: channelValue(textures.metallic, roughnessMetallic.zw),
    F0: reflectances.x,
    normal: normal.mul(faceDirection),
    dx,
    time: event.w,
    velocity,
    D,
    object: round(vLife.z),
    distance: distanceOf(dx, sources.uniforms),
  };
}

/** Interpolated events lie beside the cone; this is the event of the point that the pixel shows (docs/physics.md §4.10). */
function seenEvent(velocity: Vec4, uniforms: SurfaceSources['uniforms']): Vec4 {
  const event = select(uniforms.onLightCone.greaterThan(0.5), ontoLightCone(vEvent, velocity), vEvent).toVar();
  If(uniforms.onShallowCone.greaterThan(0.5), () => {
    event.assign(ontoShallowCone(vEvent, velocity, uniforms));
  });
  return event;
}

/** The unit normal in the rest frame on the observer's side, bent by a map of its own. */
export function frontNormal(
  { uniforms }: SurfaceSources,
  map?: { readonly texture: DataTexture; readonly strength: Vec2 },
): Vec3 {
  const smooth = normalize(vNormal.xyz).toVar();
  if (!map) return smooth.mul(faceDirection).toVar();
  const velocity = vMotion.toVar();
  const place = { normal: smooth, event: seenEvent(velocity, uniforms), velocity, uv: vUv };
  return mappedNormal(map.texture, map.strength, place).mul(faceDirection).toVar();
}

/** Directions of the texture coordinates at the fragment; call it before any discard. */
export function uvDirectionsHere({ uniforms }: SurfaceSources): UvDirections {
  const velocity = vMotion.toVar();
  return uvDirections({ event: seenEvent(velocity, uniforms), velocity, uv: vUv });
}

/** A specified reflectance, or the extrapolation of the visible colour. */
const reflectanceOrEnds = (reflectance: Float, ends: readonly [number, number, number], rgb: Vec3): Float =>
  select(reflectance.lessThan(0), dot(rgb, vec3(...ends)), reflectance);

export function channelValue(from: ChannelTexture | undefined, linear: Vec2): Float {
  if (!from) return linear.y;
  const texel = sampled(from.texture, vUv);
  const value = [texel.x, texel.y, texel.z, texel.w][from.channel];
  return clamp(value.mul(linear.x).add(linear.y), 0, 1);
}

/**
 * From the camera. At the observer's eye: |Δx′| = (γ + u·n)|Δx| of the event itself; where directions are not boosted, its own distance, or that of the
 * interpolated position.
 */
function distanceOf(dx: Vec3, uniforms: SurfaceSources['uniforms']): Float {
  const { u, gamma, boosted, onLightCone, onShallowCone, vantage } = uniforms;
  const r = length(dx).toVar();
  const unboosted = select(onLightCone.greaterThan(0.5), r, length(vCameraPosition));
  const distance = select(
    boosted.greaterThan(0.5),
    r.mul(dopplerFactor(dx, u, gamma, ZERO_VELOCITY)),
    unboosted,
  ).toVar();
  If(dot(vantage, vantage).greaterThan(0).and(onLightCone.greaterThan(0.5)), () => {
    const place = select(boosted.greaterThan(0.5), apparentPosition(dx, u, gamma), dx);
    distance.assign(length(place.sub(vantage)));
  });
  If(onShallowCone.greaterThan(0.5), () => {
    distance.assign(length(shallowPosition(dx, uniforms).sub(vantage)));
  });
  return distance;
}

/** The G-buffer's targets, in the order of their attachments, with bytes per sample as WebGPU counts them. */
export const GBUFFER_TARGETS = {
  base: 8,
  emissive: 8,
  normal: 8,
  object: 8,
  event: 16,
  motion: 16,
} as const;
export type TargetName = keyof typeof GBUFFER_TARGETS;

/** Writes the named targets of a fragment. The first output reads the surface and keeps the others' values in properties. */
export function surfaceOutputs(sources: SurfaceSources, names: readonly TargetName[]): MRTNode {
  const properties = names.map((name) => property('vec4', `g_${name}`));
  const first = Fn(() => {
    const values = targetValues(readSurface(sources));
    for (const [i, name] of names.entries()) properties[i].assign(values[name]);
    return properties[0];
  })();
  return mrt(Object.fromEntries(names.map((name, i) => [name, i === 0 ? first : properties[i]])));
}

const targetValues = (surface: Surface): Record<TargetName, Vec4> => ({
  base: vec4(surface.color.rgb, packRoughnessAndOcclusion(surface.roughness, surface.occlusion)),
  emissive: vec4(packEmission(surface.emission), packSpecular(surface)),
  normal: packNormals(surface.normal, surface.invisible),
  object: vec4(surface.object, surface.distance, 0, 1),
  event: vec4(surface.dx, surface.time),
  motion: vec4(surface.velocity.xyz, surface.D),
});
