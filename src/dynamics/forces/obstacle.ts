import { conjugate, IDENTITY, type Quat, rotate, shortestRotation, toMatrix } from '../../math/quat.ts';
import { dot, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';

/** A convex solid. */
export interface Obstacle {
  /** Signed distance (negative inside) [m], and the outward unit normal. */
  distanceAndNormal(place: Vec3): readonly [distance: number, out: Vec3];
  /** The distance alone. */
  distance(x: number, y: number, z: number): number;
  /** A point on a plane, or the center of a box [m]. */
  readonly center: Vec3;
  /** From its own frame to the world; a plane's normal is z. */
  readonly orientation: Quat;
  /** Half of a box's sizes [m]; absent for a plane. */
  readonly halfExtents?: Vec3;
}

/**
 * The half-space opposite to `normal`, through `point` [m].
 * @example
 * plane([0, 1, 0], [0, 1, 0]).distance(7, 3, 0); // 2 m
 */
export function plane(point: Vec3, normal: Vec3): Obstacle {
  const n = normalize(normal);
  const [nx, ny, nz] = n;
  const height = dot(point, n);
  return {
    ...{ center: point, orientation: shortestRotation([0, 0, 1], n) },
    distanceAndNormal: (place) => [dot(sub(place, point), n), n],
    distance: (x, y, z) => nx * x + ny * y + nz * z - height,
  };
}

/**
 * A box [m]; inside, the normal is that of the nearest side.
 * @example
 * box([0, 0, 0], [2, 2, 2]).distance(3, 0, 0); // 2 m
 * box([0, 0, 0], [2, 2, 2]).distance(0.5, 0, 0); // -0.5 m
 */
export function box(center: Vec3, size: Vec3, orientation = IDENTITY): Obstacle {
  const halfExtents = scale(size, 0.5);
  const back = conjugate(orientation);
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = toMatrix(back);
  const [mx, my, mz] = center;
  const [hx, hy, hz] = halfExtents;
  return {
    ...{ center, orientation, halfExtents },
    distance(x, y, z) {
      const dx = x - mx;
      const dy = y - my;
      const dz = z - mz;
      const ox = Math.abs(xx * dx + xy * dy + xz * dz) - hx;
      const oy = Math.abs(yx * dx + yy * dy + yz * dz) - hy;
      const oz = Math.abs(zx * dx + zy * dy + zz * dz) - hz;
      const bx = Math.max(0, ox);
      const by = Math.max(0, oy);
      const bz = Math.max(0, oz);
      return Math.sqrt(bx * bx + by * by + bz * bz) + Math.min(0, Math.max(ox, oy, oz));
    },
    distanceAndNormal(place) {
      const [distance, out] = boxDistanceAndNormal(rotate(back, sub(place, center)), halfExtents);
      return [distance, rotate(orientation, out)];
    },
  };
}

/** The same in the box's frame. */
function boxDistanceAndNormal(d: Vec3, halfExtents: Vec3): readonly [distance: number, out: Vec3] {
  const over = d.map((value, k) => Math.abs(value) - halfExtents[k]);
  const beyond: Vec3 = [0, 1, 2].map((k) => Math.max(0, over[k]) * Math.sign(d[k])) as unknown as Vec3;
  const far = Math.hypot(...beyond);
  if (far > 0) return [far, normalize(beyond)];
  const nearest = over.indexOf(Math.max(...over));
  const out = [0, 0, 0];
  out[nearest] = d[nearest] < 0 ? -1 : 1;
  return [over[nearest], out as unknown as Vec3];
}
