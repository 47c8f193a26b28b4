import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import type { Motion, Scene, SceneObject } from '../types.ts';
import { fastestVertex } from './motion.ts';
import { motionKind } from './motions.ts';

/** The fastest point of a scene. */
export interface FastestInScene {
  /** Prim path. */
  readonly path: string;
  /** World time [s]. */
  readonly time: number;
  /** [m/s] */
  readonly speed: number;
}

/** Undefined where nothing moves. Samples of deforming meshes, which are many, are gone through once, whatever scenes they come to be in. */
export function fastestInScene(scene: Scene): FastestInScene | undefined {
  const range = [scene.startTime, scene.endTime] as const;
  let best: FastestInScene | undefined;
  for (const object of scene.objects) {
    const { speed, from } = cachedFastestVertex(
      object,
      scene.hints.speedOfLight ?? SPEED_OF_LIGHT,
      range,
      best?.speed ?? 0,
    );
    if (speed > (best?.speed ?? 0)) {
      best = { path: object.path, time: Number.isFinite(from) ? from : scene.startTime, speed };
    }
  }
  return best;
}

type Found = Pick<ReturnType<typeof fastestVertex>, 'speed' | 'from'>;

const known = new WeakMap<Motion, Found>();

function cachedFastestVertex(object: SceneObject, c: number, range: readonly [number, number], atLeast: number): Found {
  const { motion } = object;
  // The bend of cubics depends on c, which is another in another scene.
  if (!motionKind(motion).keepsFastest(motion)) return fastestVertex(object, c, range, atLeast);
  const found = known.get(motion) ?? fastestVertex(object, c, range);
  known.set(motion, found);
  return found;
}
