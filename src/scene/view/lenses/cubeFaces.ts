import { cross, dot, type Vec3 } from '../../../math/vec3.ts';

/** A face of the cube around the camera, seen from inside, on the camera's axes. */
export interface CubeFace {
  readonly forward: Vec3;
  readonly up: Vec3;
  readonly right: Vec3;
}

/** The face in a direction, with `up` at its top; both unit, at right angles. */
export const faceTowards = (forward: Vec3, up: Vec3): CubeFace => ({ forward, up, right: cross(forward, up) });

/** Right, left, up, down, front, back; all but two have the camera's up at the top, and what is ahead is below the one above and above the one below. */
export const CUBE_FACES: readonly CubeFace[] = [
  faceTowards([1, 0, 0], [0, 1, 0]),
  faceTowards([-1, 0, 0], [0, 1, 0]),
  faceTowards([0, 1, 0], [0, 0, 1]),
  faceTowards([0, -1, 0], [0, 0, -1]),
  faceTowards([0, 0, -1], [0, 1, 0]),
  faceTowards([0, 0, 1], [0, 1, 0]),
];

/** The face that shows a direction, and where on it: tangents to the right and up, −1 … 1. */
export function cubeFaceOf([right, up, back]: Vec3): {
  readonly face: number;
  readonly x: number;
  readonly y: number;
} {
  const [ax, ay, az] = [Math.abs(right), Math.abs(up), Math.abs(back)];
  const at = (face: number, across: number, high: number, depth: number) => ({
    face,
    x: across / depth,
    y: high / depth,
  });
  if (ax >= ay && ax >= az) return right > 0 ? at(0, back, up, ax) : at(1, -back, up, ax);
  if (ay >= az) return up > 0 ? at(2, right, back, ay) : at(3, right, -back, ay);
  return back < 0 ? at(4, right, up, az) : at(5, -right, up, az);
}

/** Greatest cosine of the angle between a unit vector and a direction that a face shows. */
export function nearestCosine({ forward, up, right }: CubeFace, axis: Vec3): number {
  const [f, u, r] = [forward, up, right].map((of) => dot(of, axis));
  if (f > 0 && Math.abs(u) <= f && Math.abs(r) <= f) return 1;
  // Along an edge the cosine (p + q s)/√(2 + s²) is greatest at s = 2q/p where p > 0, otherwise at an end.
  const along = (p: number, q: number): number => {
    const cosine = (s: number) => (p + q * s) / Math.sqrt(2 + s * s);
    const top = p > 0 ? Math.max(-1, Math.min(1, (2 * q) / p)) : 1;
    return Math.max(cosine(-1), cosine(1), cosine(top));
  };
  return Math.max(along(f + r, u), along(f - r, u), along(f + u, r), along(f - u, r));
}
