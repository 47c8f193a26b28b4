import { addScaled, normalize } from '../../../math/vec3.ts';
import type { PictureSize } from '../pictureSize.ts';
import { CUBE_FACES, cubeFaceOf } from './cubeFaces.ts';
import type { LensModel } from './lensModel.ts';

/** The six faces of a cube around the camera side by side. */
export interface CubeLens {
  readonly kind: 'cube';
  /**
   * `3x2`: right, left, up above down, front, back, as films in Google's Spherical Video V2 format and `c3x2` of ffmpeg's v360; `6x1`: right, left, up, down, front, back
   * in a row.
   */
  readonly layout: CubeLayout;
}

/** Columns and rows of a cube's faces in a picture. */
export type CubeLayout = '3x2' | '6x1';

export const CUBE_GRIDS: Readonly<Record<CubeLayout, readonly [columns: number, rows: number]>> = {
  '3x2': [3, 2],
  '6x1': [6, 1],
};

/** Solid angle of a pixel of a face of side N: (2/N)²/(1 + x² + y²)^{3/2}. */
export const cubeModel: LensModel<CubeLens> = {
  directionAt(lens, place) {
    const { face, x, y } = facePlace(lens, place);
    const { forward, right, up } = CUBE_FACES[face]!;
    return normalize(addScaled(addScaled(forward, right, x), up, y));
  },
  placeOf({ layout }, direction) {
    const { face, x, y } = cubeFaceOf(direction);
    const [columns, rows] = CUBE_GRIDS[layout];
    const [column, row] = [face % columns, Math.floor(face / columns)];
    return [(2 * column + 1 + x) / columns - 1, 1 - (2 * row + 1 - y) / rows];
  },
  pixelSolidAngle(lens, place, size) {
    const { x, y } = facePlace(lens, place);
    const { width, height } = faceSize(lens, size);
    return 4 / (width * height) / (1 + x * x + y * y) ** 1.5;
  },
  pixelsPerRadian(lens, size) {
    const { width, height } = faceSize(lens, size);
    // tan θ changes fastest at a face's edge; its middle is what a picture's resolution is judged by.
    return Math.max(width, height) / 2;
  },
};

function faceSize({ layout }: CubeLens, { width, height }: PictureSize): PictureSize {
  const [columns, rows] = CUBE_GRIDS[layout];
  return { width: width / columns, height: height / rows };
}

/** The face at a place of the picture, and where on it, −1 … 1 to the right and up. */
function facePlace({ layout }: CubeLens, [x, y]: readonly [number, number]) {
  const [columns, rows] = CUBE_GRIDS[layout];
  const [across, down] = [((x + 1) / 2) * columns, ((1 - y) / 2) * rows];
  const column = Math.min(columns - 1, Math.max(0, Math.floor(across)));
  const row = Math.min(rows - 1, Math.max(0, Math.floor(down)));
  return { face: row * columns + column, x: 2 * (across - column) - 1, y: 1 - 2 * (down - row) };
}
