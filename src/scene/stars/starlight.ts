import type { Vec3 } from '../../math/vec3.ts';
import { blackbodyColor } from '../../spectrum/planckian.ts';
import type { RenderSettings } from '../view.ts';

export function starlight(T: number, D: number, { beaming }: Pick<RenderSettings, 'dopplerMix' | 'beaming'>): Vec3 {
  const [r, g, b] = blackbodyColor(T * D);
  const k = D ** (4 * beaming);
  return [r * k, g * k, b * k];
}
