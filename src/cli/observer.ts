import { addScaled, length, type Vec3, ZERO } from '../math/vec3.ts';
import { properVelocity } from '../physics/boost.ts';
import { framingCamera, lookAtOrientation, observerFromCamera } from '../scene/camera.ts';
import type { Scene, SceneCamera } from '../scene/types.ts';
import type { ViewPoint } from '../scene/view.ts';
import { usageError } from './exit.ts';
import type { ObserverFlags } from './flags.ts';

/** The observer at world time t [s]. */
export type ObserverPath = (t: number) => ViewPoint;

/**
 * The observer that the flags ask for. The camera's path carries it where that moves; else it coasts from its place at
 * world time `start` [s] with its velocity, or stays there with `hold` (a velocity without moving, as the lock `look`).
 */
export function observerPath(scene: Scene, flags: ObserverFlags, c: number, start: number, hold = false): ObserverPath {
  const camera = chooseCamera(scene, flags.camera);
  const up: Vec3 = scene.upAxis === 'Z' ? [0, 0, 1] : [0, 1, 0];
  const orientation =
    flags.lookAt && lookOrientation(flags, flags.lookAt, observerFromCamera(camera, start, c).position, up);
  const given = flags.beta ?? scene.hints.beta;
  const moves = camera.motion.kind !== 'static' && flags.position === undefined;
  return (t) => {
    const carried = observerFromCamera(camera, t, c);
    const beta = flags.beta ?? (moves ? undefined : given);
    const u = beta ? properVelocity(beta) : moves ? carried.u : ZERO;
    const drift = moves || hold || !beta ? 0 : c * (t - start);
    return {
      t,
      position: addScaled(flags.position ?? carried.position, beta ?? ZERO, drift),
      u,
      orientation: orientation ?? carried.orientation,
      fovY: flags.fov === undefined ? carried.fovY : (flags.fov * Math.PI) / 180,
    };
  };
}

function chooseCamera(scene: Scene, path: string | undefined): SceneCamera {
  if (path === undefined) return scene.cameras[0] ?? framingCamera(scene);
  const camera = scene.cameras.find((candidate) => candidate.path === path);
  if (camera) return camera;
  const known = scene.cameras.map((candidate) => candidate.path).join(', ') || 'none';
  throw usageError(`--camera ${path}: the scene has no such camera; it has ${known}`);
}

/** The direction is the observer's own, as it stands: the camera's axes are the world's, carried by the pure boost. */
function lookOrientation(flags: ObserverFlags, target: Vec3, from: Vec3, up: Vec3): ViewPoint['orientation'] {
  const forward = addScaled(target, flags.position ?? from, -1);
  if (length(forward) === 0)
    throw usageError('--look-at names the place where the observer is: there is no direction to look in');
  return lookAtOrientation(forward, up);
}
