import type { Vec3 } from '../math/vec3.ts';
import { boundingBox } from '../scene/bounds.ts';
import { restToWorld } from '../scene/resample.ts';
import type { Scene, SceneObject } from '../scene/types.ts';
import type { Body } from './bodies.ts';

/** The scene's objects as they are drawn, in its order: what is sampled in its rest frame is brought into the world. c [m/s]. */
export const worldObjects = (scene: Scene, c: number): readonly SceneObject[] =>
  scene.objects.map((object) => (isSampledAtRest(object) ? restToWorld(object, c) : object));

/** Its samples in the world depend on the speed of light. */
export const isSampledAtRest = ({ motion, authoredIn }: SceneObject): boolean =>
  authoredIn === 'rest' && (motion.kind === 'sampled' || motion.kind === 'sampled-points');

/** Half the diagonal of the box of all objects where they are at time 0, or at their first sample [m]. */
export function radiusOf(bodies: readonly Body[]): number {
  const corners: number[] = [];
  for (const { line, radius } of bodies) {
    const at: Vec3 =
      line.kind === 'polyline' ? [line.positions[0], line.positions[1], line.positions[2]] : startOf(line);
    for (const side of [-radius, radius]) corners.push(at[0] + side, at[1] + side, at[2] + side);
  }
  const box = boundingBox(corners);
  return box ? Math.hypot(box.max[0] - box.min[0], box.max[1] - box.min[1], box.max[2] - box.min[2]) / 2 : 1;
}

const startOf = (line: Body['line']): Vec3 => ('position' in line ? line.position : [0, 0, 0]);
