import type { Vec3 } from '../../../math/vec3.ts';
import type { PictureSize } from '../pictureSize.ts';
import { type CubeLens, cubeModel } from './cubeLens.ts';
import { type EquirectangularLens, equirectangularModel } from './equirectangularLens.ts';
import { type FisheyeLens, fisheyeModel } from './fisheyeLens.ts';
import type { LensModel, PicturePlace } from './lensModel.ts';
import type { PerspectiveLens } from './perspectiveLens.ts';
import { perspectiveModel } from './perspectiveModel.ts';

/** Lenses whose pictures a rasterizer cannot draw in one go, because straight lines are curved in them: it draws the faces of a cube instead. */
export type PanoramicLens = EquirectangularLens | FisheyeLens | CubeLens;

/** How the directions seen by a camera map to its picture, as plain data. */
export type Lens = PerspectiveLens | PanoramicLens;

/** By kind. */
const LENSES: { readonly [Kind in Lens['kind']]: LensModel<Extract<Lens, { readonly kind: Kind }>> } = {
  perspective: perspectiveModel,
  equirectangular: equirectangularModel,
  fisheye: fisheyeModel,
  cube: cubeModel,
};

/** The lens of a picture that is known to have a perspective one. Throws a RangeError if it has not. */
export function perspectiveOf(lens: Lens): PerspectiveLens {
  if (isPanoramic(lens)) throw new RangeError(`a perspective lens expected, not ${lens.kind}`);
  return lens;
}

export const isPanoramic = (lens: Lens): lens is PanoramicLens => lens.kind !== 'perspective';

const modelOf = (lens: Lens): LensModel<Lens> => LENSES[lens.kind] as LensModel<Lens>;

const placeAt = (x: number, y: number, { width, height }: PictureSize): PicturePlace => [
  (2 * x) / width - 1,
  1 - (2 * y) / height,
];

/**
 * The direction that is seen at a point of a picture [px from its top left corner; the first pixel's centre is at (½, ½)]: unit, camera axes; undefined
 * where the picture shows nothing.
 */
export const lensDirection = (lens: Lens, x: number, y: number, size: PictureSize): Vec3 | undefined =>
  modelOf(lens).directionAt(lens, placeAt(x, y, size), size);

/** Where a direction (unit, camera axes) is in a picture [px from its top left corner], possibly outside it; undefined if it has no place in its plane. */
export function lensPixel(lens: Lens, direction: Vec3, size: PictureSize): readonly [number, number] | undefined {
  const place = modelOf(lens).placeOf(lens, direction, size);
  return place && [((place[0] + 1) / 2) * size.width, ((1 - place[1]) / 2) * size.height];
}

/** Solid angle of a pixel at a point of a picture [sr]; 0 where it shows nothing. */
export const pixelSolidAngle = (lens: Lens, x: number, y: number, size: PictureSize): number =>
  modelOf(lens).pixelSolidAngle(lens, placeAt(x, y, size), size);

/** How well a picture resolves (`LensModel`) [px/rad]. */
export const pixelsPerRadian = (lens: Lens, size: PictureSize): number => modelOf(lens).pixelsPerRadian(lens, size);
