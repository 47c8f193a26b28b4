import type { Vec3 } from '../../../math/vec3.ts';
import type { DiskLight } from '../../../scene/types.ts';
import { areaSample, inOwnFrame, localLightTracer } from './localLight.ts';

export const DISK_LIGHT = localLightTracer<DiskLight>(
  inOwnFrame((at, { radius }, random) => {
    if (at[2] >= 0) return undefined;
    const [p, q] = [random(), random()];
    return areaSample(at, pointOnDisk(radius, p, q), Math.PI * radius ** 2);
  }),
);

function pointOnDisk(radius: number, p: number, q: number): Vec3 {
  const r = radius * Math.sqrt(p);
  return [r * Math.cos(2 * Math.PI * q), r * Math.sin(2 * Math.PI * q), 0];
}
