import { dot, exp, float, max, smoothstep } from 'three/tsl';
import { SUN_DISC } from '../../../scene/lights/sceneLights.ts';
import type * as gpu from '../../../shaders/types.ts';
import { evaluateBrdf } from '../../brdf/brdf.ts';
import { IRRADIANCE_POWER, type RadianceAccumulator, type SpectralSource } from '../../color/radiance.ts';
import { incidentSpectrumBetween, WORLD_FRAME } from '../restFrame.ts';
import type { LitSurface } from './litSurface.ts';

/** A distant light on the GPU. */
export interface DistantLightTexels {
  /** Towards it, unit. */
  readonly direction: gpu.Vec3;
  /** The filter of its irradiance. */
  readonly color: gpu.Vec3;
  /** Absent for daylight. */
  readonly source?: SpectralSource;
  /** As of `IncidentSpectrum`. */
  readonly colored?: number;
}

/** Adds what a surface reflects of it: E′ = D² E. `index`: its place in the table, where that is known before the shader runs. */
export function addDistantLight(
  { brdf, rest, visibility }: LitSurface,
  { direction, color, source, colored }: DistantLightTexels,
  index: number | undefined,
  accumulator: RadianceAccumulator,
): void {
  const spectrum = {
    ...incidentSpectrumBetween(direction, rest, WORLD_FRAME),
    ...(source && { source }),
    ...(colored !== undefined && { colored }),
  };
  const visible = visibility?.ofDistantLight(index);
  accumulator.addReflected(
    visible ? color.mul(visible) : color,
    evaluateBrdf(brdf, rest.into(direction)),
    spectrum,
    IRRADIANCE_POWER,
  );
}

/** Adds its disc and its glow, as seen in the world direction `n`. */
export function addDisc(
  { direction, color, source }: DistantLightTexels,
  n: gpu.Vec3,
  accumulator: RadianceAccumulator,
): void {
  const away = max(float(1).sub(dot(n, direction)), 0).toVar();
  const disc = smoothstep(...SUN_DISC.rim, away)
    .oneMinus()
    .mul(SUN_DISC.radiance);
  const [near, far] = SUN_DISC.glows.map(([strength, rate]) => exp(away.mul(-rate)).mul(strength));
  accumulator.addEmitted(color.mul(disc.add(near).add(far)), source);
}
