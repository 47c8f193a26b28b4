import type { DiskLight } from '../light.ts';
import type { LocalLightKind } from './lightKind.ts';

export const DISK_LIGHT: LocalLightKind<DiskLight> = {
  reach: 'local',
  sizes: ['radius'],
  isOneSided: true,
  isPoint: () => false,
  projectedArea: ({ radius }) => Math.PI * radius ** 2,
  transform: (light, by) => ({ ...light, radius: light.radius * by.scale }),
};
