import { dot, type Vec3 } from '../../math/vec3.ts';
import type { LightShaping } from './light.ts';

/** Factor 0 … 1 of a light's radiance emitted in the unit direction `out`; `front`: unit −Z of its frame. */
export function shapingFactor({ inner, outer, focus }: LightShaping, front: Vec3, out: Vec3): number {
  const cosine = Math.min(Math.max(dot(front, out), -1), 1);
  const angle = Math.acos(cosine);
  const share = focus === 0 ? 1 : Math.max(cosine, 0) ** focus;
  if (angle <= inner) return share;
  if (angle >= outer) return 0;
  const s = (angle - inner) / (outer - inner);
  return share * (1 - s * s * (3 - 2 * s));
}
