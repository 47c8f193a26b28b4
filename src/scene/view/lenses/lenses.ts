import type { Vec3 } from '../../../math/vec3.ts';
import type { PictureSize } from '../pictureSize.ts';
import { CUBE_GRIDS, type CubeLens, cubeModel } from './cubeLens.ts';
import { type EquirectangularLens, equirectangularModel } from './equirectangularLens.ts';
import { type FisheyeLens, fisheyeModel } from './fisheyeLens.ts';
import type { LensModel, PicturePlace } from './lensModel.ts';
import type { PerspectiveLens } from './perspectiveLens.ts';
import { perspectiveModel } from './perspectiveModel.ts';
import { type StereoLens, stereoModel } from './stereoLens.ts';

/** Lenses whose pictures a rasterizer cannot draw in one go, because straight lines are curved in them: it draws faces instead. */
export type PanoramicLens = EquirectangularLens | FisheyeLens | CubeLens | StereoLens;

/** How the directions seen by a camera map to its picture, as plain data. */
export type Lens = PerspectiveLens | PanoramicLens;

/** By kind. */
const LENSES: { readonly [Kind in Lens['kind']]: LensModel<Extract<Lens, { readonly kind: Kind }>> } = {
  perspective: perspectiveModel,
  equirectangular: equirectangularModel,
  fisheye: fisheyeModel,
  cube: cubeModel,
  stereo: stereoModel,
};

/** The lens of a picture that is known to have a perspective one. Throws a RangeError if it has not. */
export function perspectiveOf(lens: Lens): PerspectiveLens {
  if (isPanoramic(lens)) throw new RangeError(`a perspective lens expected, not ${lens.kind}`);
  return lens;
}

export const isPanoramic = (lens: Lens): lens is PanoramicLens => lens.kind !== 'perspective';

const modelOf = (lens: Lens): LensModel<Lens> => LENSES[lens.kind] as LensModel<Lens>;

/** Width over height of a lens's pictures; undefined where any shape will do. */
export function pictureShape(lens: Lens): number | undefined {
  switch (lens.kind) {
    case 'perspective':
      return undefined;
    case 'equirectangular':
      return 2;
    case 'fisheye':
    case 'stereo':
      return 1;
    case 'cube': {
      const [columns, rows] = CUBE_GRIDS[lens.layout];
      return columns / rows;
    }
  }
}

/** The part of a picture that a lens fills, in its middle [px]; beside it, it shows nothing. */
export function filledSize(lens: Lens, { width, height }: PictureSize): PictureSize {
  const shape = pictureShape(lens) ?? width / height;
  return { width: Math.min(width, height * shape), height: Math.min(height, width / shape) };
}

/** A point of a picture, as a place in the part that the lens fills. */
function placeAt(lens: Lens, x: number, y: number, size: PictureSize): { place: PicturePlace; filled: PictureSize } {
  const filled = filledSize(lens, size);
  return { place: [(2 * x - size.width) / filled.width, (size.height - 2 * y) / filled.height], filled };
}

const isFilled = ([x, y]: PicturePlace): boolean => Math.abs(x) <= 1 && Math.abs(y) <= 1;

/**
 * The direction that is seen at a point of a picture [px from its top left corner; the first pixel's centre is at (½, ½)]: unit, camera axes; undefined
 * where the picture shows nothing.
 */
export function lensDirection(lens: Lens, x: number, y: number, size: PictureSize): Vec3 | undefined {
  const { place, filled } = placeAt(lens, x, y, size);
  return isPanoramic(lens) && !isFilled(place) ? undefined : modelOf(lens).directionAt(lens, place, filled);
}

/** Where the eye is that sees a point of a picture, from the camera on its axes [m]; undefined: there. */
export const lensEye = (lens: Lens, x: number, y: number, size: PictureSize): Vec3 | undefined =>
  modelOf(lens).eyeAt?.(lens, placeAt(lens, x, y, size).place);

/** Where a direction (unit, camera axes) is in a picture [px from its top left corner], possibly outside it; undefined if it has no place in its plane. */
export function lensPixel(lens: Lens, direction: Vec3, size: PictureSize): readonly [number, number] | undefined {
  const filled = filledSize(lens, size);
  const place = modelOf(lens).placeOf(lens, direction, filled);
  return place && [(size.width + place[0] * filled.width) / 2, (size.height - place[1] * filled.height) / 2];
}

/** Solid angle of a pixel at a point of a picture [sr]; 0 where it shows nothing. */
export function pixelSolidAngle(lens: Lens, x: number, y: number, size: PictureSize): number {
  const { place, filled } = placeAt(lens, x, y, size);
  return isPanoramic(lens) && !isFilled(place) ? 0 : modelOf(lens).pixelSolidAngle(lens, place, filled);
}

/** How well a picture resolves (`LensModel`) [px/rad]. */
export const pixelsPerRadian = (lens: Lens, size: PictureSize): number =>
  modelOf(lens).pixelsPerRadian(lens, filledSize(lens, size));
