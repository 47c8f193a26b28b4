import type { RectLight } from '../light.ts';
import type { LocalLightKind } from './lightKind.ts';

export const RECT_LIGHT: LocalLightKind<RectLight> = {
  reach: 'local',
  sizes: ['width', 'height'],
  isOneSided: true,
  isPoint: () => false,
  projectedArea: ({ width, height }) => width * height,
  transform: (light, by) => ({ ...light, width: light.width * by.scale, height: light.height * by.scale }),
};
