import { scale } from '../../../math/vec3.ts';
import type { CylinderLight } from '../light.ts';
import type { LocalLightKind } from './lightKind.ts';

export const CYLINDER_LIGHT: LocalLightKind<CylinderLight> = {
  reach: 'local',
  sizes: ['radius', 'length'],
  isOneSided: false,
  isPoint: () => false,
  projectedArea: ({ radius, length }) => (radius === 0 ? length : 2 * radius * length),
  transform: (light, by) => ({
    ...light,
    // The colour of a line is its intensity per metre.
    color: light.radius === 0 ? scale(light.color, by.scale) : light.color,
    radius: light.radius * by.scale,
    length: light.length * by.scale,
  }),
};
