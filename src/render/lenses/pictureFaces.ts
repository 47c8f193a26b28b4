import { fromMatrix, multiply, type Quat, rotate } from '../../math/quat.ts';
import { add, type Vec3, ZERO } from '../../math/vec3.ts';
import { coveredFaces } from '../../scene/view/lenses/coveredFaces.ts';
import { type CubeFace, faceTowards } from '../../scene/view/lenses/cubeFaces.ts';
import { towards } from '../../scene/view/lenses/equirectangularLens.ts';
import { filledSize, isPanoramic, pixelsPerRadian } from '../../scene/view/lenses/lenses.ts';
import { type PerspectiveLens, perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { eyeAt, type StereoLens } from '../../scene/view/lenses/stereoLens.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PixelRect } from '../../scene/view/pictureViews.ts';
import type { ViewPoint } from '../../scene/view/view.ts';

/** What is drawn in one go for a panoramic picture: a face of the cube around the camera, or a part of the strip that an eye sees in a direction. */
export interface PictureFace {
  /** Seen from inside, on the camera's axes. */
  readonly axes: CubeFace;
  readonly lens: PerspectiveLens;
  /** Of its own picture [px]. */
  readonly size: PictureSize;
  /** From the camera to the eye, on the camera's axes, in the observer's frame [m]; absent: there. */
  readonly eye?: Vec3;
  /** The pixels of the picture that may show it; absent: all. */
  readonly rect?: PixelRect;
}

/** Columns of a stereo picture that are drawn from one place of the eye. That turns with the gaze, so at 45° up or down the edges of a strip are half a pixel off at 34 times the distance of an eye from the head’s middle. */
const STRIP_COLUMNS = 48;
/** Most of half the width of a strip [rad]. */
const MAX_HALF_WIDTH = 1.4;

/** The faces that a picture of this size needs, none for a perspective lens. */
export function facesOf({ lens }: ViewPoint, size: PictureSize): readonly PictureFace[] {
  if (!isPanoramic(lens)) return [];
  if (lens.kind === 'stereo') return stripsOf(lens, size);
  const side = faceTexels(pixelsPerRadian(lens, size));
  const shared = { lens: perspective(Math.PI / 2), size: { width: side, height: side } };
  return coveredFaces(lens).map((axes) => ({ axes, ...shared }));
}

/** Side of faces of 90° [px]: in their middles, where they resolve least, as many pixels per radian as the picture has. */
const faceTexels = (perRadian: number): number => Math.max(1, Math.ceil(2 * perRadian - 1e-9));

/** Strips of both eyes, each in two faces, from the horizon to the zenith and to the nadir. */
function stripsOf(lens: StereoLens, size: PictureSize): readonly PictureFace[] {
  const filled = filledSize(lens, size);
  const [left, top] = [(size.width - filled.width) / 2, (size.height - filled.height) / 2];
  const [first, end] = [Math.floor(left), Math.ceil(left + filled.width)];
  const columns = Math.max(1, Math.min(STRIP_COLUMNS, Math.floor(filled.width / 8)));
  const perRadian = pixelsPerRadian(lens, size);
  const height = faceTexels(perRadian);
  // At the edges a sample may be half a pixel outside; in the tiniest pictures a column is wider than what can be drawn.
  const half = Math.min(MAX_HALF_WIDTH, (columns / 2 + 1) / perRadian);
  // A face's axis is 45° up: at the horizon, directions are √2 further apart on it.
  const tanX = Math.SQRT2 * Math.tan(half);
  // And at 45°, where it resolves least, pixels are √2 closer together than at the horizon.
  const width = Math.ceil(Math.SQRT2 * tanX * height);
  const shared = { lens: { ...perspective(Math.PI / 2), aspect: tanX }, size: { width, height } };
  const faces: PictureFace[] = [];
  for (const [eye, side] of [-1, 1].entries())
    for (let x = first; x < end; x += columns) {
      const longitude = Math.PI * ((2 * (x + columns / 2 - left)) / filled.width - 1);
      for (const up of [1, -1]) {
        const latitude = (up * Math.PI) / 4;
        const quarter = filled.height / 4;
        const from = top + quarter * (2 * eye + (up > 0 ? 0 : 1));
        // One row more for samples beside their pixels' centres.
        const [y0, y1] = [Math.max(0, Math.floor(from) - 1), Math.min(size.height, Math.ceil(from + quarter) + 1)];
        faces.push({
          ...shared,
          axes: faceTowards(towards(longitude, latitude), towards(longitude, latitude + Math.PI / 2)),
          eye: eyeAt(longitude, (side * lens.separation) / 2),
          rect: { x, y: y0, width: Math.min(x + columns, end) - x, height: y1 - y0 },
        });
      }
    }
  return faces;
}

export function faceViewPoint(view: ViewPoint, { axes, lens, eye }: PictureFace): ViewPoint {
  const drawn = { ...view, lens, orientation: multiply(view.orientation, faceOrientation(axes)) };
  return eye ? { ...drawn, vantage: add(view.vantage ?? ZERO, rotate(view.orientation, eye)) } : drawn;
}

/** Axes of the face → those of the camera. */
export const faceOrientation = ({ forward: f, up: u, right: r }: CubeFace): Quat =>
  fromMatrix([r[0], u[0], -f[0], r[1], u[1], -f[1], r[2], u[2], -f[2]]);
