import { fastestIn } from '../../scene/fastestIn.ts';
import type { Scene } from '../../scene/types.ts';
import type { LoadedScene } from '../services.ts';

/** A scene that was read, made or changed, with its fastest point. */
export function surveyed(scene: Scene): LoadedScene {
  const fastest = fastestIn(scene);
  return fastest ? { scene, fastest } : { scene };
}
