import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';

/** How the views of two eyes share a picture: none, or the left eye's in the top or left half. */
export type StereoLayout = 'none' | 'top-bottom' | 'left-right';

/**
 * What a picture that covers less than the sphere leaves out at each edge, as parts of the full width or height, 0 … 1.
 * Of one eye's view.
 */
export interface SphericalCrop {
  /** Part of 2π of longitude. */
  readonly left: number;
  /** Part of 2π of longitude. */
  readonly right: number;
  /** Part of π of latitude. */
  readonly top: number;
  /** Part of π of latitude. */
  readonly bottom: number;
}

/** Longitude along the width, to the right, and latitude along the height; forward is in the middle of the full sphere, up at its top. */
export interface EquirectangularPicture {
  /** Which of the two it is. */
  readonly projection: 'equirectangular';
  /** The views of the eyes. */
  readonly stereo: StereoLayout;
  /** Absent: the full sphere. */
  readonly crop?: SphericalCrop;
  /** Compass heading of the middle, clockwise from north [rad]; absent: not stated. Only PNG, JPEG and EXR have it. */
  readonly heading?: number;
}

/**
 * Six square faces, seen from inside, in a grid of 3 × 2: right, left, up; down, front, back (layout 0 of Spherical Video
 * V2). What is ahead is at the bottom of the up face and at the top of the down face, as VLC and ffmpeg's v360 have it.
 */
export interface CubemapPicture {
  /** Which of the two it is. */
  readonly projection: 'cubemap';
  /** The views of the eyes. */
  readonly stereo: StereoLayout;
}

/** How a picture, or each frame of a film, covers the directions around the camera. */
export type SphericalPicture = EquirectangularPicture | CubemapPicture;

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
