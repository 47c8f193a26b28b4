/** A perspective lens: straight lines of the observer's apparent space stay straight. */
export interface PerspectiveLens {
  readonly kind: 'perspective';
  /** Vertical field of view in the observer's frame: 2 atan of half the picture's height at distance 1 [rad]. */
  readonly fovY: number;
  /** Width over height at distance 1; absent: that of the picture, so pixels are square. */
  readonly aspect?: number;
  /**
   * The picture's centre: tangents of its angles from the forward axis, to the right and up. Absent: on the axis.
   * A frustum with another centre is off-axis, as for headsets, projection walls and shifted lenses.
   */
  readonly center?: readonly [number, number];
}

/**
 * A lens without shift, with a vertical field of view in the observer's frame [rad].
 * @example
 * perspective(Math.PI / 3); // { kind: 'perspective', fovY: 1.0472 }
 */
export const perspective = (fovY: number): PerspectiveLens => ({ kind: 'perspective', fovY });

/** The sides of a picture as tangents of their angles from the forward axis; left and bottom are negative if the axis is inside. */
export interface FrustumSides {
  /** Negative if left of the axis. */
  readonly left: number;
  /** Positive if right of the axis. */
  readonly right: number;
  /** Negative if below the axis. */
  readonly bottom: number;
  /** Positive if above the axis. */
  readonly top: number;
}

/**
 * The lens whose picture has these sides. Throws a RangeError unless left < right and bottom < top.
 * @example
 * offAxisLens({ left: -1, right: 3, bottom: -1, top: 1 }); // { fovY: 1.5708, aspect: 2, center: [1, 0] }
 */
export function offAxisLens({ left, right, bottom, top }: FrustumSides): PerspectiveLens {
  const [width, height] = [right - left, top - bottom];
  if (!(width > 0 && height > 0 && Number.isFinite(width) && Number.isFinite(height)))
    throw new RangeError(
      `sides of a frustum: left ${left} < right ${right} and bottom ${bottom} < top ${top} expected`,
    );
  return {
    kind: 'perspective',
    fovY: 2 * Math.atan(height / 2),
    aspect: width / height,
    center: [(left + right) / 2, (bottom + top) / 2],
  };
}

/** The rectangle of a picture at distance 1 from the camera, with axes right and up. */
export interface Frustum {
  /** Half the rectangle's width and height. */
  readonly tanX: number;
  readonly tanY: number;
  /** tanX / tanY. */
  readonly aspect: number;
  readonly center: readonly [number, number];
}

/** The frustum of a picture of `width` × `height` pixels. */
export function frustumOf({ fovY, aspect, center = [0, 0] }: PerspectiveLens, width: number, height: number): Frustum {
  const tanY = Math.tan(fovY / 2);
  const ratio = aspect ?? width / height;
  return { tanX: tanY * ratio, tanY, aspect: ratio, center };
}

/** Tangents, across and up, of the corner farthest from the forward axis; ≥ 0. */
export const farthestCorner = ({ tanX, tanY, center: [x, y] }: Frustum): readonly [number, number] => [
  tanX + Math.abs(x),
  tanY + Math.abs(y),
];

/** Pixels per unit tangent; the larger of the two if pixels are not square. */
export const pixelsPerTangent = ({ tanY, aspect }: Frustum, width: number, height: number): number =>
  (height / (2 * tanY)) * Math.max(1, width / height / aspect);
