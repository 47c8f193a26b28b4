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
