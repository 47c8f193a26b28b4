import { dot, type Vec3 } from '../../math/vec3.ts';
import type { LightShaping, LocalLight } from '../types.ts';

/** What of a lamp's light goes out in the unit direction `out`; `front`: the unit −Z of its frame. */
export function shapingFactor({ inner, outer, focus }: LightShaping, front: Vec3, out: Vec3): number {
  const cosine = Math.min(Math.max(dot(front, out), -1), 1);
  const angle = Math.acos(cosine);
  const share = focus === 0 ? 1 : Math.max(cosine, 0) ** focus;
  if (angle <= inner) return share;
  if (angle >= outer) return 0;
  const s = (angle - inner) / (outer - inner);
  return share * (1 - s * s * (3 - 2 * s));
}

/** The intensity of a lamp that is far away, over its `color`, where most of it is seen: the area of its image [m²]; of a line its length [m], of a point 1. */
export function projectedArea(lamp: LocalLight): number {
  switch (lamp.kind) {
    case 'rect':
      return lamp.width * lamp.height;
    case 'cylinder':
      return lamp.radius === 0 ? lamp.length : 2 * lamp.radius * lamp.length;
    default:
      return lamp.radius === 0 && lamp.kind === 'sphere' ? 1 : Math.PI * lamp.radius ** 2;
  }
}
