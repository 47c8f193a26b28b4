import { conjugate, IDENTITY, type Quat, rotate, shortestRotation, toMatrix } from '../../math/quat.ts';
import { dot, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';

/** Something that stands fast, and is convex. */
export interface Obstacle {
  /** How far a place is outside of it (below 0: inside) [m], and the unit direction that leads out. */
  distanceAndNormal(place: Vec3): readonly [distance: number, out: Vec3];
  /** The same distance alone. */
  distance(x: number, y: number, z: number): number;
  /** A place on a plane, or the middle of a box [m]. */
  readonly middle: Vec3;
  /** From its own frame, in which a plane looks along z, to the world. */
  readonly orientation: Quat;
  /** Half of a box's sizes [m]; a plane has none. */
  readonly half?: Vec3;
}

/** All on the side that `normal` does not point to. */
export function plane(point: Vec3, normal: Vec3): Obstacle {
  const n = normalize(normal);
  const [nx, ny, nz] = n;
  const height = dot(point, n);
  return {
    ...{ middle: point, orientation: shortestRotation([0, 0, 1], n) },
    distanceAndNormal: (place) => [dot(sub(place, point), n), n],
    distance: (x, y, z) => nx * x + ny * y + nz * z - height,
  };
}

/** A box; from inside it leads out by the nearest side. */
export function box(middle: Vec3, size: Vec3, orientation = IDENTITY): Obstacle {
  const half = scale(size, 0.5);
  const back = conjugate(orientation);
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = toMatrix(back);
  const [mx, my, mz] = middle;
  const [hx, hy, hz] = half;
  return {
    ...{ middle, orientation, half },
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
      const [distance, out] = boxDistanceAndNormal(rotate(back, sub(place, middle)), half);
      return [distance, rotate(orientation, out)];
    },
  };
}

/** The same in the frame of a box. */
function boxDistanceAndNormal(d: Vec3, half: Vec3): readonly [distance: number, out: Vec3] {
  const over = d.map((value, k) => Math.abs(value) - half[k]);
  const beyond: Vec3 = [0, 1, 2].map((k) => Math.max(0, over[k]) * Math.sign(d[k])) as unknown as Vec3;
  const far = Math.hypot(...beyond);
  if (far > 0) return [far, normalize(beyond)];
  const nearest = over.indexOf(Math.max(...over));
  const out = [0, 0, 0];
  out[nearest] = d[nearest] < 0 ? -1 : 1;
  return [over[nearest], out as unknown as Vec3];
}
