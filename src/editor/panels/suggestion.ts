import type { ParamValue } from '../../graph/document.ts';
import type { ParamSpec } from '../../graph/nodeType.ts';
import type { Picture } from '../../nodes/define.ts';
import { cameraOf } from '../state/viewpoint.ts';

/** What holds while the person has set nothing: the picture tells what the scene suggested. */
export function suggestion(spec: ParamSpec, picture: Picture | undefined): ParamValue {
  if (picture && spec.kind === 'number') {
    if (spec.suggestion === 'speedOfLight') return picture.speedOfLight;
    const degrees = (cameraOf(picture).fovY * 180) / Math.PI;
    if (spec.suggestion === 'fieldOfView') return Math.round(degrees * 10) / 10;
  }
  return spec.default;
}
