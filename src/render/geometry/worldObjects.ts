import { type Vec3, ZERO } from '../../math/vec3.ts';
import { asPolyline, samplePosition } from '../../physics/worldLines/worldLine.ts';
import { halfDiagonal } from '../../scene/bounds/bounds.ts';
import { restToWorld, sampleTimes } from '../../scene/motion/motion.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';
import type { Body } from './bodies.ts';

/** The scene's objects as they are drawn, in its order: objects sampled in their rest frame are converted to the world. c [m/s]. */
export const worldObjects = (scene: Scene, c: number): readonly SceneObject[] =>
  scene.objects.map((object) => (isSampledAtRest(object) ? restToWorld(object, c) : object));

/** Whether the object's samples in the world depend on the speed of light. */
export const isSampledAtRest = ({ motion, authoredIn }: SceneObject): boolean =>
  authoredIn === 'rest' && sampleTimes(motion) !== undefined;

/** Half the diagonal of the bounding box of all objects at time 0, or at their first sample [m]. */
export const sceneRadius = (bodies: readonly Body[]): number =>
  halfDiagonal(bodies.map(({ line, radius }) => ({ center: startOf(line), radius })));

function startOf(line: Body['line']): Vec3 {
  const samples = asPolyline(line);
  if (samples) return samplePosition(samples, 0);
  return 'position' in line ? line.position : ZERO;
}
