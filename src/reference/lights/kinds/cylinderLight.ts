import { dot, length, sub, type Vec3 } from '../../../math/vec3.ts';
import type { CylinderLight } from '../../../scene/types.ts';
import { inOwnFrame, localLightTracer } from './localLight.ts';

/** Samples the visible part of the lateral surface uniformly; for radius 0, ∫ r cos dφ is replaced by 1. docs/physics.md §6.9. */
export const CYLINDER_LIGHT = localLightTracer<CylinderLight>(
  inOwnFrame((at, light, random) => {
    const away = Math.hypot(at[1], at[2]);
    if (away <= light.radius) return undefined;
    const x = (random() - 0.5) * light.length;
    const open = Math.acos(light.radius / away);
    const phi = Math.atan2(at[2], at[1]) + open * (2 * random() - 1);
    const out: Vec3 = [0, Math.cos(phi), Math.sin(phi)];
    const toward = sub([x, light.radius * out[1], light.radius * out[2]], at);
    const d = length(toward);
    const width = light.radius === 0 ? away / d : (2 * open * light.radius * -dot(out, toward)) / d;
    return { toward, weight: (light.length * width) / d ** 2 };
  }),
);
