import { fastestInScene } from '../../scene/motion/fastestInScene.ts';
import type { Scene } from '../../scene/types.ts';
import type { LoadedScene } from '../services.ts';

/** A scene with its fastest point. */
export function toLoadedScene(scene: Scene): LoadedScene {
  const fastest = fastestInScene(scene);
  return fastest ? { scene, fastest } : { scene };
}
