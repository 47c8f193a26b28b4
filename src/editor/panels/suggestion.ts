import type { ParamValue } from '../../graph/document/document.ts';
import type { ParamSpec } from '../../graph/nodeType.ts';
import { degrees } from '../../math/angle.ts';
import { pictureCamera } from '../../nodes/pictures/renderSettings.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';

const SUGGESTED: Readonly<Record<string, (picture: PictureSpec) => number>> = {
  speedOfLight: ({ speedOfLight }) => speedOfLight,
  fieldOfView: (picture) => Math.round(10 * degrees(pictureCamera(picture).fovY)) / 10,
  openAt: ({ scene }) => scene.hints.openAt ?? scene.startTime,
  startTime: ({ scene }) => scene.startTime,
  endTime: ({ scene }) => scene.endTime,
  timeCodesPerSecond: ({ scene }) => scene.timeCodesPerSecond,
};

/** The effective value while the user has set none, read from the picture. */
export function suggestion(spec: ParamSpec, picture: PictureSpec | undefined): ParamValue {
  const of = spec.kind === 'number' && spec.suggestion ? SUGGESTED[spec.suggestion] : undefined;
  return picture && of ? of(picture) : spec.default;
}
