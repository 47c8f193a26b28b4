import { type Vec3, ZERO } from '../../math/vec3.ts';
import { pictureCamera } from '../../nodes/pictures/renderSettings.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import type { ObserverState } from '../../physics/lorentz/observer.ts';
import type { Scene, SceneCamera } from '../../scene/types.ts';
import { observerFromCamera } from '../../scene/view/camera.ts';

export const sceneUpVector = (scene: Scene): Vec3 => (scene.upAxis === 'Y' ? [0, 1, 0] : [0, 0, 1]);

/** Initial observer: at the camera, at rest unless the scene specifies a velocity. */
export function initialObserver(picture: PictureSpec): ObserverState {
  const { hints, startTime } = picture.scene;
  const t = hints.openAt ?? startTime;
  const { position, orientation } = observerFromCamera(pictureCamera(picture), t, picture.speedOfLight);
  return { t, position, orientation, u: hints.beta ? properVelocity(hints.beta) : ZERO, properTime: 0 };
}

/** Observer on the scene's camera at world time t [s], with the camera's velocity. */
export function observerOnCamera(camera: SceneCamera, state: ObserverState, c: number): ObserverState {
  const { position, orientation, u } = observerFromCamera(camera, state.t, c);
  return { ...state, position, orientation, u };
}
