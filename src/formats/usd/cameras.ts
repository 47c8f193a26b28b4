import * as mat4 from '../../math/mat4.ts';
import type { SceneCamera } from '../../scene/types.ts';
import { attributeOf, numberAt, sampleTimes, textAt } from './attributes.ts';
import { report, type StageContext } from './context.ts';
import { type Frame, scaledFrame } from './frame.ts';
import type { PrimSpec } from './layer.ts';
import { sampledPoses } from './placement.ts';
import { refineTimes } from './sampling.ts';

/** Fallbacks of UsdGeomCamera, in tenths of a stage unit. */
const FALLBACK = { focalLength: 50, verticalAperture: 15.2908 };
/** Turns between samples are followed to this angle [rad]. */
const ANGLE_TOLERANCE = 1e-4;

/** fov = 2 atan(verticalAperture / 2 focalLength); a camera's scale does not matter. */
export function cameraOf(context: StageContext, prim: PrimSpec, frame: Frame): SceneCamera {
  const lens = (name: keyof typeof FALLBACK): number => {
    if (sampleTimes(attributeOf(prim, name)).length > 0)
      report(context, 'warning', 'usd.animated-lens', prim.path, `${name} changes with time; it is held at the start`);
    return numberAt(prim, name, context.startCode) ?? FALLBACK[name];
  };
  if (textAt(prim, 'projection', undefined) === 'orthographic')
    report(context, 'warning', 'usd.projection', prim.path, 'an orthographic camera is read as a perspective one');
  const fovY = 2 * Math.atan(lens('verticalAperture') / (2 * lens('focalLength')));
  return { path: prim.path, motion: cameraMotion(context, frame), fovY };
}

function cameraMotion(context: StageContext, frame: Frame): SceneCamera['motion'] {
  const world = scaledFrame(frame, context.unit);
  const poseAt = (time: number): mat4.RigidPose => mat4.decomposeRigid(world.matrixAt(time)).pose;
  if (world.times.length === 0) return { kind: 'static', pose: poseAt(context.startCode) };
  const rigidAt = (time: number): mat4.Mat4 => mat4.fromPose(poseAt(time));
  // Tips of the axes: they turn by at most the tolerance against the chord.
  const { times } = refineTimes(
    world.times,
    rigidAt,
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    ANGLE_TOLERANCE,
  );
  return sampledPoses(context, times, Array.from(times, poseAt));
}
