import type { DomeLight } from '../light.ts';
import type { LightKind } from './lightKind.ts';

export const DOME_LIGHT: LightKind<DomeLight> = {
  reach: 'sky',
  // A dome is the world's, not the scene's that is carried.
  transform: (light) => light,
};
