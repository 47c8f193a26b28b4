import { scale } from '../../../math/vec3.ts';
import type { SphereLight } from '../light.ts';
import type { LocalLightKind } from './lightKind.ts';

const isPoint = ({ radius }: SphereLight): boolean => radius === 0;

export const SPHERE_LIGHT: LocalLightKind<SphereLight> = {
  reach: 'local',
  sizes: ['radius'],
  isOneSided: false,
  isPoint,
  projectedArea: (light) => (isPoint(light) ? 1 : Math.PI * light.radius ** 2),
  transform: (light, by) => ({
    ...light,
    // The colour of a point is its intensity.
    color: isPoint(light) ? scale(light.color, by.scale ** 2) : light.color,
    radius: light.radius * by.scale,
  }),
};
