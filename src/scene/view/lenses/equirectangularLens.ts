import type { Vec3 } from '../../../math/vec3.ts';
import type { LensModel } from './lensModel.ts';

/** The whole sphere of directions: longitude across, latitude up; forward is in the middle, backward at both sides. */
export interface EquirectangularLens {
  readonly kind: 'equirectangular';
}

/** The direction of a longitude to the right of what is ahead, and a latitude [rad]. */
export function towards(longitude: number, latitude: number): Vec3 {
  const level = Math.cos(latitude);
  return [level * Math.sin(longitude), Math.sin(latitude), -level * Math.cos(longitude)];
}

/**
 * n = (cos φ sin λ, sin φ, −cos φ cos λ) with the longitude λ = πx and the latitude φ = πy/2. A pixel of w × h has the solid angle (2π/w)(π/h) cos φ.
 * Source: Snyder, "Map Projections: A Working Manual" (1987), chapter 12, plate carrée.
 */
export const equirectangularModel: LensModel<EquirectangularLens> = {
  directionAt: (_, [x, y]) => towards(Math.PI * x, (Math.PI / 2) * y),
  placeOf: (_, [right, up, back]) => [
    Math.atan2(right, -back) / Math.PI,
    Math.atan2(up, Math.hypot(right, back)) / (Math.PI / 2),
  ],
  pixelSolidAngle: (_, [, y], { width, height }) =>
    ((2 * Math.PI) / width) * (Math.PI / height) * Math.max(0, Math.cos((Math.PI / 2) * y)),
  pixelsPerRadian: (_, { width, height }) => Math.max(width / (2 * Math.PI), height / Math.PI),
};
