import { Discard, Fn, faceDirection, int, length, mix, mrt, normalize, property, round, select, vec4 } from 'three/tsl';
import type { DataTexture, MRTNode } from 'three/webgpu';
import { dopplerFactor } from '../shaders/dopplerFactor.ts';
import { ontoLightCone } from '../shaders/ontoLightCone.ts';
import type { Float, Vec3, Vec4 } from '../shaders/types.ts';
import type { FloatTable } from './floatTable.ts';
import { sampled } from './textures.ts';
import type { Uniforms } from './uniforms.ts';
import { vColor, vEvent, vLife, vMotion, vNormal, vShown, vUv } from './vertexStage.ts';

/** Texels per material in the material table: (base colour, opacity), (emission, opacity threshold), (roughness, metallic, 0, 0). */
export const MATERIAL_TEXELS = 3;

export interface SurfaceSources {
  readonly materials: FloatTable;
  readonly uniforms: Uniforms;
  readonly baseColor?: DataTexture;
  readonly emissive?: DataTexture;
  readonly colored: boolean;
}

/** (v, 1 − v²) */
const AT_REST = vec4(0, 0, 0, 1);

/** What is known of the surface at a fragment. */
export interface Surface {
  /** Linear sRGB and opacity. */
  readonly color: Vec4;
  readonly emissive: Vec3;
  readonly roughness: Float;
  readonly metallic: Float;
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
  const material = int(round(vLife.w)).mul(int(MATERIAL_TEXELS)).toVar();
  const base = sources.materials.texel(material).toVar();
  const emission = sources.materials.texel(material.add(int(1))).toVar();
  const finish = sources.materials.texel(material.add(int(2))).toVar();
  const color = base.toVar();
  if (sources.baseColor) color.mulAssign(sampled(sources.baseColor, vUv));
  if (sources.colored) color.mulAssign(vec4(vColor, 1));
  const emissive = emission.xyz.toVar();
  if (sources.emissive) emissive.mulAssign(sampled(sources.emissive, vUv).rgb);

  const { u, gamma, boostLight, onLightCone } = sources.uniforms;
  const velocity = vMotion.toVar();
  // Between the vertices the events are interpolated, and beside the light cone: each is that of the point which is painted here.
  const event = select(onLightCone.greaterThan(0.5), ontoLightCone(vEvent, velocity), vEvent).toVar();
  const later = event.w.sub(vEvent.w).toVar();
  const alive = vLife.x.add(later).greaterThanEqual(0).and(vLife.y.sub(later).greaterThanEqual(0));
  Discard(alive.not().or(vNormal.w.lessThan(0.9999)).or(color.w.lessThan(emission.w)));
  const dx = event.xyz.toVar();
  const D = mix(1, dopplerFactor(dx, u, gamma, velocity), boostLight);
  return {
    color,
    emissive,
    roughness: finish.x,
    metallic: finish.y,
    normal: normalize(vNormal.xyz).mul(faceDirection),
    dx,
    time: event.w,
    velocity,
    D,
    object: round(vLife.z),
    distance: distanceOf(dx, sources.uniforms),
  };
}

/** |Δx′| = (γ + u·n)|Δx| of the event itself; where directions are not boosted, places between the vertices are those of the events, or linear. */
function distanceOf(dx: Vec3, { u, gamma, boosted, onLightCone }: SurfaceSources['uniforms']): Float {
  const r = length(dx).toVar();
  const still = select(onLightCone.greaterThan(0.5), r, length(vShown));
  return select(boosted.greaterThan(0.5), r.mul(dopplerFactor(dx, u, gamma, AT_REST)), still);
}

/** The G-buffer's targets, in the order of their attachments; bytes per sample as WebGPU counts them. */
export const TARGETS = {
  base: 8,
  emissive: 8,
  normal: 8,
  object: 8,
  event: 16,
  motion: 16,
} as const;
export type TargetName = keyof typeof TARGETS;

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
  base: vec4(surface.color.rgb, surface.roughness),
  emissive: vec4(surface.emissive, surface.metallic),
  normal: vec4(surface.normal, 1),
  object: vec4(surface.object, surface.distance, 0, 1),
  event: vec4(surface.dx, surface.time),
  motion: vec4(surface.velocity.xyz, surface.D),
});
