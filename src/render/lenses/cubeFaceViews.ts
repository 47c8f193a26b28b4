import { fromMatrix, multiply, type Quat } from '../../math/quat.ts';
import { coveredFaces } from '../../scene/view/lenses/coveredFaces.ts';
import type { CubeFace } from '../../scene/view/lenses/cubeFaces.ts';
import { isPanoramic, pixelsPerRadian } from '../../scene/view/lenses/lenses.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { ViewPoint } from '../../scene/view/view.ts';

/** A picture of a face, square. */
const FACE_LENS = perspective(Math.PI / 2);

/** The faces that a view point's picture needs, none for a perspective lens; they are drawn from the view points `faceViewPoint`. */
export const facesOf = ({ lens }: ViewPoint): readonly CubeFace[] => (isPanoramic(lens) ? coveredFaces(lens) : []);

export const faceViewPoint = (view: ViewPoint, face: CubeFace): ViewPoint => ({
  ...view,
  lens: FACE_LENS,
  orientation: multiply(view.orientation, faceOrientation(face)),
});

/** Side of the faces for a picture [px]: in their middles, where they resolve least, as many pixels per radian as the picture has. */
export const faceTexels = ({ lens }: ViewPoint, size: PictureSize): number =>
  Math.max(1, Math.ceil(2 * pixelsPerRadian(lens, size) - 1e-9));

/** Axes of the face → those of the camera. */
export const faceOrientation = ({ forward: f, up: u, right: r }: CubeFace): Quat =>
  fromMatrix([r[0], u[0], -f[0], r[1], u[1], -f[1], r[2], u[2], -f[2]]);
