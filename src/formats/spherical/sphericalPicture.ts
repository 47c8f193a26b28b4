import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SphericalCrop, StereoLayout } from '../../scene/view/sphericalPicture.ts';

/** Size of one eye's view [px]. Throws where a stereo picture has no two halves. */
export function eyeSize({ width, height }: PictureSize, stereo: StereoLayout): PictureSize {
  const [across, down] = [stereo === 'left-right' ? 2 : 1, stereo === 'top-bottom' ? 2 : 1];
  if (width % across || height % down)
    throw new MessageError(msg`a ${stereo} picture of ${width} × ${height} pixels has no two equal halves`);
  return { width: width / across, height: height / down };
}

/** A crop in pixels: size of the full sphere, and of the part of it that is there, with its place. */
export interface CroppedArea {
  /** The full sphere [px]. */
  readonly full: PictureSize;
  /** What is there of it [px]. */
  readonly area: PictureSize;
  /** From the left of the full sphere [px]. */
  readonly left: number;
  /** From the top of the full sphere [px]. */
  readonly top: number;
}

/** The crop, if something of the sphere is left. Throws where not, or where a part is no number. */
export function checkedCrop(crop: SphericalCrop): SphericalCrop {
  const { left, right, top, bottom } = crop;
  if ([left, right, top, bottom].every((part) => part >= 0) && left + right < 1 && top + bottom < 1) return crop;
  throw new MessageError(msg`a crop of ${left} left, ${right} right, ${top} top and ${bottom} bottom leaves nothing`);
}

/** The crop of one eye's view of the given size, to the next pixel. Throws where it leaves nothing. */
export function croppedArea(crop: SphericalCrop | undefined, area: PictureSize): CroppedArea {
  const { left, right, top, bottom } = checkedCrop(crop ?? UNCROPPED);
  const full = {
    width: Math.round(area.width / (1 - left - right)),
    height: Math.round(area.height / (1 - top - bottom)),
  };
  return {
    full,
    area,
    left: Math.min(Math.round(left * full.width), full.width - area.width),
    top: Math.min(Math.round(top * full.height), full.height - area.height),
  };
}

/** The inverse of `croppedArea`; undefined for the full sphere. Throws where the area leaves the sphere. */
export function cropOfArea({ full, area, left, top }: CroppedArea): SphericalCrop | undefined {
  const right = full.width - left - area.width;
  const bottom = full.height - top - area.height;
  const isValid = [left, right, top, bottom].every((length) => length >= 0) && area.width > 0 && area.height > 0;
  if (!isValid)
    throw new MessageError(
      msg`an area of ${area.width} × ${area.height} pixels at (${left}, ${top}) is not in a sphere of ${full.width} × ${full.height}`,
    );
  const parts = {
    left: left / full.width,
    right: right / full.width,
    top: top / full.height,
    bottom: bottom / full.height,
  };
  return unlessWhole(parts);
}

/** Undefined for the full sphere. */
export const unlessWhole = (crop: SphericalCrop): SphericalCrop | undefined =>
  Object.values(crop).every((part) => part === 0) ? undefined : crop;

/** Of the full sphere. */
export const UNCROPPED: SphericalCrop = { left: 0, right: 0, top: 0, bottom: 0 };
