import type { DomeLight } from '../light.ts';
import type { LightKind } from './lightKind.ts';

export const DOME_LIGHT: LightKind<DomeLight> = {
  reach: 'sky',
  // A dome belongs to the world, and is not transformed with the scene.
  transform: (light) => light,
};
