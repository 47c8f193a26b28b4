import { msg } from '../../../messages/message.ts';
import type { SceneCamera } from '../../../scene/types.ts';
import { report } from '../diagnostics.ts';
import { attributeOf, numberAt, sampleTimes, textAt } from '../layer/attributes.ts';
import type { PrimSpec } from '../layer/layer.ts';
import type { StageContext } from './context.ts';
import { rigidMotionOf } from './placement/resampling.ts';
import type { StageTransform } from './transforms/stageTransform.ts';

/** Fallback values of UsdGeomCamera, in tenths of a stage unit. */
const FALLBACK = { focalLength: 50, verticalAperture: 15.2908 };

/** fov = 2 atan(verticalAperture / 2 focalLength); a camera's scale is ignored. */
export function cameraOf(context: StageContext, prim: PrimSpec, frame: StageTransform): SceneCamera {
  const lens = (name: keyof typeof FALLBACK): number => {
    if (sampleTimes(attributeOf(prim, name)).length > 0)
      report(
        context,
        'warning',
        'usd.animated-lens',
        prim.path,
        msg`${name} changes with time; it is held at the start`,
      );
    return numberAt(prim, name, context.startCode) ?? FALLBACK[name];
  };
  if (textAt(prim, 'projection', undefined) === 'orthographic')
    report(context, 'warning', 'usd.projection', prim.path, msg`an orthographic camera is read as a perspective one`);
  const fovY = 2 * Math.atan(lens('verticalAperture') / (2 * lens('focalLength')));
  return { path: prim.path, motion: rigidMotionOf(context, prim.path, frame), fovY };
}
