import { type Vec3, ZERO } from '../../math/vec3.ts';
import type { Picture } from '../../nodes/define.ts';
import { cameraOf } from '../../nodes/picture.ts';
import { properVelocity } from '../../physics/boost.ts';
import type { ObserverState } from '../../physics/observer.ts';
import { observerFromCamera } from '../../scene/camera.ts';
import type { Scene, SceneCamera } from '../../scene/types.ts';
import type { ViewPoint } from '../../scene/view.ts';
import type { Lock } from '../flight/flight.ts';

export const upOf = (scene: Scene): Vec3 => (scene.upAxis === 'Y' ? [0, 1, 0] : [0, 0, 1]);

/** Where the observer begins: in the camera, at rest unless the scene wants a velocity from the start. */
export function startingObserver(picture: Picture): ObserverState {
  const { hints, startTime } = picture.scene;
  const t = hints.openAt ?? startTime;
  const { position, orientation } = observerFromCamera(cameraOf(picture), t, picture.speedOfLight);
  return { t, position, orientation, u: hints.beta ? properVelocity(hints.beta) : ZERO, properTime: 0 };
}

/** On the scene's camera at world time t [s], with the camera's own velocity. */
export function ridingObserver(camera: SceneCamera, state: ObserverState, c: number): ObserverState {
  const { position, orientation, u } = observerFromCamera(camera, state.t, c);
  return { ...state, position, orientation, u };
}

/** What the renderer is asked to show. The `fly` lock hides the velocity from it. */
export function viewPointOf(state: ObserverState, picture: Picture, lock: Lock): ViewPoint {
  const fovY = picture.fovY ?? cameraOf(picture).fovY;
  const { t, position, orientation } = state;
  return { t, position, orientation, u: lock === 'fly' ? ZERO : state.u, fovY };
}
