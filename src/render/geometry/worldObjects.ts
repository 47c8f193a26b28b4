import { referencePosition } from '../../physics/worldLines/worldLine.ts';
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

/** Half the diagonal of the bounding box of all objects at their reference times (`referencePosition`) [m]. */
export const sceneRadius = (bodies: readonly Body[]): number =>
  halfDiagonal(bodies.map(({ line, radius }) => ({ center: referencePosition(line), radius })));
