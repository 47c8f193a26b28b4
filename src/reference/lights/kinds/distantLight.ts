import { dot, negate, normalize, type Vec3 } from '../../../math/vec3.ts';
import { distantLightRadius, SUN_DISC } from '../../../scene/lights/sceneLights.ts';
import { smoothstep } from '../../../scene/lights/skyGradient.ts';
import type { DistantLight } from '../../../scene/types.ts';
import { coneDirection } from '../../sampling/directions.ts';
import { WORLD_FRAME } from '../../spectral/restFrame.ts';
import { sourceSpectrumOf } from '../../spectral/sourceSpectrum.ts';
import type { LightTracer } from './lightTracer.ts';

/** Infinitely far away, always on: E′ = D² E. Its light comes from the centre of its disc; shadow rays go to random points of the disc. */
export const DISTANT_LIGHT: LightTracer<DistantLight> = {
  trace(light) {
    const { direction } = light;
    const radius = distantLightRadius(light);
    const sourceSpectrum = sourceSpectrumOf(light.color, light.spectrum);
    return {
      sample({ random }) {
        const dx = normalize(negate(direction));
        const rayDirection = radius > 0 ? coneDirection(dx, 1 - Math.cos(radius), random) : dx;
        return { dx, rayDirection, end: Number.POSITIVE_INFINITY, sourceSpectrum, sourceFrame: WORLD_FRAME, weight: 1 };
      },
      disc: { sourceSpectrum, factor: (n) => discAndGlow(n, direction) },
    };
  },
};

function discAndGlow(n: Vec3, direction: Vec3): number {
  const away = 1 + dot(n, direction);
  const disc = SUN_DISC.radiance * (1 - smoothstep(...SUN_DISC.rim, away));
  return SUN_DISC.glows.reduce((sum, [strength, rate]) => sum + strength * Math.exp(-rate * away), disc);
}
