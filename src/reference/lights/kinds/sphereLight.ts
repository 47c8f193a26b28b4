import type { Random } from '../../../math/random.ts';
import { dot, length, normalize, scale, type Vec3 } from '../../../math/vec3.ts';
import type { SphereLight } from '../../../scene/types.ts';
import { coneDirection } from '../../sampling/directions.ts';
import { type LightSample, localLightTracer } from './localLight.ts';

export const SPHERE_LIGHT = localLightTracer<SphereLight>((light, center, _, random) =>
  light.radius === 0 ? pointSample(center) : sphereSample(center, light, random),
);

const pointSample = (center: Vec3): LightSample => ({
  toward: center,
  weight: 1 / Math.max(dot(center, center), 1e-12),
});

/** A uniform direction within the cone of the sphere; from inside, of all directions. */
function sphereSample(center: Vec3, { radius }: SphereLight, random: Random): LightSample {
  const d = length(center);
  const sin2 = Math.min((radius / d) ** 2, 1);
  const open = d > radius ? sin2 / (1 + Math.sqrt(1 - sin2)) : 2;
  const direction = coneDirection(normalize(center, [0, 0, 1]), open, random);
  const along = dot(direction, center);
  const chord = Math.sqrt(Math.max(0, radius * radius - (d * d - along * along)));
  const reach = d > radius ? along - chord : along + chord;
  return { toward: scale(direction, reach), weight: 2 * Math.PI * open };
}
