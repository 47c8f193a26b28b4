import { rotate } from '../../../math/quat.ts';
import type { DistantLight } from '../light.ts';
import type { LightKind } from './lightKind.ts';

export const DISTANT_LIGHT: LightKind<DistantLight> = {
  reach: 'distant',
  transform: (light, by) => ({ ...light, direction: rotate(by.orientation, light.direction) }),
};
