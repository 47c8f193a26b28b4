import { dot, length, normalize } from '../../math/vec3.ts';
import type { Volume } from '../../scene/types.ts';
import { neutralFilter, scaleFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import { filterFromRgb, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { type Hit, lightOf } from '../acceleration/ray.ts';
import { nearestHit, type TracedScene } from '../intersection/tracedScene.ts';
import { materialOf } from '../materials/material.ts';
import { facingNormal, type SurfacePoint, surfaceAt } from '../materials/surface.ts';
import type { RestFrame } from '../spectral/restFrame.ts';
import type { SampledRadiance } from '../spectral/sampledRadiance.ts';
import type { SpectralContext } from '../spectral/spectralContext.ts';
import { dielectricFresnel } from './fresnel.ts';
import { isElsewhere, type RaySegment } from './transmittance.ts';

/** Whether the hit is on a transmissive material (`Material.transmission`). */
export const isTransmissive = (scene: TracedScene, hit: Hit): boolean =>
  materialOf(scene, hit).transmission !== undefined;

/** Whether light passes it without a change of direction: a sheet, or a body met from inside. */
export const isThin = (scene: TracedScene, hit: Hit): boolean => !isBody(scene, hit) || !hit.front;

const isBody = (scene: TracedScene, hit: Hit): boolean => (materialOf(scene, hit).volume?.thickness ?? 0) > 0;

/** The share of what it does not reflect that passes a surface. */
export const clearShare = ({ opacity, transmission, metallic }: SurfacePoint): number =>
  transmission === undefined ? 1 - opacity : transmission * (1 - metallic);

/** Light after a way inside a body [m, its rest frame]. */
export function absorbed(
  context: SpectralContext,
  light: SampledRadiance,
  volume: Volume | undefined,
  way: number,
): SampledRadiance {
  if (!volume || !Number.isFinite(volume.attenuationDistance)) return light;
  return context.absorbed(light, filterFromRgb(volume.attenuationColor), way / volume.attenuationDistance);
}

/** What a transmissive surface does to light that goes straight through it, in its rest frame. */
export interface StraightPass {
  readonly filter: SpectralFilter;
  readonly volume: Volume | undefined;
  /** Way inside it until the light leaves it [m]. */
  readonly way: number;
}

/**
 * Light that no camera sees directly passes glass straight, tinted once where it leaves it towards the ray's beginning, weakened by Fresnel's reflectance at each side and by what
 * its inside absorbs: no caustics, but shadows of the right colour.
 */
export function straightPass(scene: TracedScene, beam: RaySegment, hit: Hit, frame: RestFrame): StraightPass {
  const point = surfaceAt(scene, hit);
  const { dx } = lightOf(beam.ray, hit);
  const n = normalize(dx);
  const passed = 1 - dielectricFresnel(Math.abs(dot(frame.fromWorld(n), facingNormal(hit))), point.ior);
  const enters = hit.front || !isBody(scene, hit);
  const filter = scaleFilter(enters ? point.filter : neutralFilter(1), clearShare(point) * passed);
  const { volume } = materialOf(scene, hit);
  if (!volume || isThin(scene, hit)) return { filter, volume: undefined, way: 0 };
  const exit = nearestHit(scene, beam.ray, {
    begin: hit.s,
    accepts: (other) =>
      other.object === hit.object && isElsewhere(scene, { ray: beam.ray, begin: hit.s, from: hit }, other),
  });
  const way = exit ? (exit.s - hit.s) * length(dx) * frame.doppler(n) : 0;
  return { filter, volume, way };
}
