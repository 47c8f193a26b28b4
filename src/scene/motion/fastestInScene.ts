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

/** Undefined if nothing moves. Results for deforming meshes, which have many samples, are cached by motion across scenes. */
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
      best = {
        path: object.path,
        time: Number.isFinite(from) ? Math.max(from, object.lifetime.birth) : scene.startTime,
        speed,
      };
    }
  }
  return best;
}

type CachedSpeed = Pick<ReturnType<typeof fastestVertex>, 'speed' | 'from'>;

const cache = new WeakMap<Motion, CachedSpeed>();

function cachedFastestVertex(
  object: SceneObject,
  c: number,
  range: readonly [number, number],
  atLeast: number,
): CachedSpeed {
  const { motion } = object;
  // The bend of cubics depends on c, which differs between scenes.
  if (!motionKind(motion).keepsFastest(motion)) return fastestVertex(object, c, range, atLeast);
  const found = cache.get(motion) ?? fastestVertex(object, c, range);
  cache.set(motion, found);
  return found;
}
