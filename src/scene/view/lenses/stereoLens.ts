import { scale, type Vec3 } from '../../../math/vec3.ts';
import type { PictureSize } from '../pictureSize.ts';
import { type EquirectangularLens, equirectangularModel } from './equirectangularLens.ts';
import type { LensModel, PicturePlace } from './lensModel.ts';

/**
 * Two equirectangular pictures, of the left eye above that of the right one. Both eyes turn with the gaze about the head's vertical axis: each column of a picture is seen from
 * where its eye is when one looks that way, so that it is right in every direction at once.
 * Source: Peleg, Ben-Ezra and Pritch, "Omnistereo: panoramic stereo imaging", IEEE PAMI 23 (2001); Google, "Rendering omni-directional stereo content" (2016).
 */
export interface StereoLens {
  readonly kind: 'stereo';
  /** Distance of the eyes, in the observer's frame [m]. */
  readonly separation: number;
}

/** The half of the picture with a place: which eye's it is, −1 the left and 1 the right one, and where in that. */
const inHalf = ([x, y]: PicturePlace): { readonly side: -1 | 1; readonly place: PicturePlace } =>
  y >= 0 ? { side: -1, place: [x, 2 * y - 1] } : { side: 1, place: [x, 2 * y + 1] };

const EYE: EquirectangularLens = { kind: 'equirectangular' };
const halfOf = ({ width, height }: PictureSize): PictureSize => ({ width, height: height / 2 });

/** Each half is an equirectangular picture; `placeOf` is that of the left eye, of what is far away. */
export const stereoModel: LensModel<StereoLens> = {
  directionAt: (_, place, size) => equirectangularModel.directionAt(EYE, inHalf(place).place, halfOf(size)),
  placeOf(_, direction, size) {
    const place = equirectangularModel.placeOf(EYE, direction, halfOf(size));
    return place && [place[0], (place[1] + 1) / 2];
  },
  pixelSolidAngle: (_, place, size) => equirectangularModel.pixelSolidAngle(EYE, inHalf(place).place, halfOf(size)),
  pixelsPerRadian: (_, size) => equirectangularModel.pixelsPerRadian(EYE, halfOf(size)),
  eyeAt: ({ separation }, place) => eyeAt(Math.PI * place[0], (inHalf(place).side * separation) / 2),
};

/** Where an eye is when the gaze is turned to the right by `longitude` [rad], from the middle of the head on the camera's axes: to its right by `aside` [m], negative for the left eye. */
export const eyeAt = (longitude: number, aside: number): Vec3 =>
  scale([Math.cos(longitude), 0, Math.sin(longitude)], aside);
