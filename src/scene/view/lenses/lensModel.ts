import type { Vec3 } from '../../../math/vec3.ts';
import type { PictureSize } from '../pictureSize.ts';

/** A place in the part of a picture that the lens fills: −1 … 1 to the right and up, (0, 0) in the middle. */
export type PicturePlace = readonly [x: number, y: number];

/**
 * What a lens of one kind does, with the size of the part of the picture that it fills. Directions are unit vectors on the camera's axes: +X right, +Y up, −Z forward, in the observer's frame. One definition for
 * both renderers, stars, metering and labels; src/shaders/lenses has the twins of `directionAt`.
 */
export interface LensModel<Lens> {
  /** The direction that is seen at a place of the picture; undefined where it shows nothing, outside the circle of a fisheye. */
  directionAt(lens: Lens, place: PicturePlace, size: PictureSize): Vec3 | undefined;
  /** Where a direction is in the picture, possibly outside −1 … 1; undefined if it has no place in its plane. */
  placeOf(lens: Lens, direction: Vec3, size: PictureSize): PicturePlace | undefined;
  /** Solid angle of a pixel at a place, its side times its height in the limit of small ones [sr]; 0 where the picture shows nothing. */
  pixelSolidAngle(lens: Lens, place: PicturePlace, size: PictureSize): number;
  /**
   * The root of the most pixels per steradian: how well a picture resolves. Not beyond a right angle from the axis of a fisheye, nor towards the poles of an
   * equirectangular picture, where ever fewer directions are stretched over as many pixels.
   */
  pixelsPerRadian(lens: Lens, size: PictureSize): number;
  /** Where the eye is that sees a place, from the camera on its axes, in the observer's frame [m]; absent: there. */
  eyeAt?(lens: Lens, place: PicturePlace): Vec3;
}
