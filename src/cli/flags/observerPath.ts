import { radians } from '../../math/angle.ts';
import { length, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { listed, msg } from '../../messages/message.ts';
import type { Scene, SceneCamera } from '../../scene/types.ts';
import { framingCamera, lookAtOrientation, observerFromCamera } from '../../scene/view/camera.ts';
import { withCourse } from '../../scene/view/cameraCourse.ts';
import { panoramicLens, USUAL_LENS } from '../../scene/view/lenses/lensChoice.ts';
import type { Lens } from '../../scene/view/lenses/lenses.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { type ObserverPath, type ObserverSetup, observerPathFrom, ridesCamera } from '../../scene/view/observerPath.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { usageError } from '../terminal/exitCodes.ts';
import type { ObserverFlags } from './viewFlags.ts';

/** The observer that the flags describe, from world time `start` [s]. A moving camera's own velocity takes precedence over the scene's hint. */
export function observerPath(scene: Scene, flags: ObserverFlags, c: number, start: number): ObserverPath {
  return observerPathFrom(observerSetup(scene, flags, c, start), c, start);
}

/** As `observerPath`, before a path is made of it. */
export function observerSetup(
  scene: Scene,
  flags: ObserverFlags & Pick<ObserverSetup, 'stayInPlace' | 'vantage'>,
  c: number,
  start: number,
): ObserverSetup {
  const chosen = chooseCamera(scene, flags.camera);
  const { position, lookAt, stayInPlace, vantage } = flags;
  const lens = lensOf(flags);
  const up: Vec3 = scene.upAxis === 'Z' ? [0, 0, 1] : [0, 1, 0];
  const rides = ridesCamera({ camera: chosen, ...(position && { position }) });
  const beta = flags.beta ?? (rides ? undefined : scene.hints.beta);
  // A course is for its velocity: with another one the camera is a place only.
  const camera = flags.cameraPath === 'smooth' && !beta ? withCourse(chosen, c) : chosen;
  return {
    camera,
    ...(stayInPlace && { stayInPlace }),
    ...(beta && { beta }),
    ...(position && { position }),
    ...(lookAt && {
      orientation: lookOrientation(lookAt, position ?? observerFromCamera(camera, start, c).position, vantage, up),
    }),
    ...(vantage && { vantage }),
    ...(lens && { lens }),
  };
}

/** The lens that flags replace the camera's by; undefined if they do not. */
function lensOf({ fov, lens, aperture, domeTilt, eyeSeparation }: ObserverFlags): Lens | undefined {
  const choice = lens ?? 'perspective';
  const isRound = choice === 'fisheye' || choice === 'dome';
  if (aperture !== undefined && !isRound)
    throw usageError(
      msg`--aperture is the angle across a fisheye's circle: add --lens fisheye or dome, or leave it out`,
    );
  if (domeTilt !== undefined && choice !== 'dome')
    throw usageError(msg`--dome-tilt is for domes: add --lens dome, or leave it out`);
  if (eyeSeparation !== undefined && choice !== 'stereo')
    throw usageError(msg`--eye-separation is for two eyes: add --lens stereo, or leave it out`);
  if (fov !== undefined && choice !== 'perspective')
    throw usageError(
      msg`--fov is of a perspective lens; --lens ${choice} sees ${isRound ? msg`its --aperture` : msg`all around`}: leave it out`,
    );
  const panoramic = panoramicLens({
    lens: choice,
    aperture: aperture ?? USUAL_LENS.aperture,
    domeTilt: domeTilt ?? USUAL_LENS.domeTilt,
    eyeSeparation: eyeSeparation ?? USUAL_LENS.eyeSeparation,
  });
  return panoramic ?? (fov === undefined ? undefined : perspective(radians(fov)));
}

function chooseCamera(scene: Scene, path: string | undefined): SceneCamera {
  if (path === undefined) return scene.cameras[0] ?? framingCamera(scene);
  const camera = scene.cameras.find((candidate) => candidate.path === path);
  if (camera) return camera;
  const known = listed(scene.cameras.map((candidate) => candidate.path)) || msg`none`;
  throw usageError(msg`--camera ${path}: the scene has no such camera; it has ${known}`);
}

/** target − position, and − vantage, used unchanged in the observer's frame, whose axes are the world's carried by the pure boost. */
function lookOrientation(target: Vec3, from: Vec3, vantage: Vec3 | undefined, up: Vec3): ViewPoint['orientation'] {
  const forward = sub(sub(target, from), vantage ?? ZERO);
  if (length(forward) === 0)
    throw usageError(msg`--look-at names the place where the camera is: there is no direction to look in`);
  return lookAtOrientation(forward, up);
}
