import type { Mat4 } from '../../math/mat4.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { Gauge } from './look.ts';

// What can be said of all that is seen in a ball at once. L is the matrix of a boost, perhaps with a rotation, that takes (|X|, X) to (|Δx′|, Δx′).

/** The cone that a ball is seen in goes to a cone: (cos, axis) by L, as (|X|, X) does (cull.ts). True only where no pixel can show any of it. */
export function ballOutside(L: Mat4, sides: readonly Vec3[], x: number, y: number, z: number, radius: number): boolean {
  const far = Math.sqrt(x * x + y * y + z * z);
  if (!(far > radius)) return false;
  const sine = radius / far;
  const k = Math.sqrt(1 - sine * sine);
  const cosine = L[0] * k + (L[1] * x + L[2] * y + L[3] * z) / far;
  if (cosine <= 0) return false;
  const ax = L[4] * k + (L[5] * x + L[6] * y + L[7] * z) / far;
  const ay = L[8] * k + (L[9] * x + L[10] * y + L[11] * z) / far;
  const az = L[12] * k + (L[13] * x + L[14] * y + L[15] * z) / far;
  // Its axis is not unit: |axis|² − cosine² is the invariant 1 − k².
  const size = Math.sqrt(ax * ax + ay * ay + az * az);
  for (const s of sides) if (s[0] * ax + s[1] * ay + s[2] * az < -sine - 1e-9 * size) return true;
  return false;
}

/** At most so many pixels [1/m] for a metre at what is seen in a ball without the observer: |Δx′| = D|X|, D = γ + u·n. */
export function pixelsPerMetre(
  L: Mat4,
  { look, corner }: Gauge,
  x: number,
  y: number,
  z: number,
  radius: number,
): number {
  const far = Math.sqrt(x * x + y * y + z * z);
  const w = speedOf(L);
  const turn = cosineBeyond(forwardness(L, w, x, y, z, far), radius / far);
  const least = 1 / (L[0] + w) + w * (1 + turn);
  return (look.focal * corner) / (least * (far - radius));
}

/** At most so many times as long is the image of an edge as its X: √(2γD − 1) along the line of sight and 1 across. */
export function longestImage(L: Mat4, x: number, y: number, z: number, radius: number): number {
  const far = Math.sqrt(x * x + y * y + z * z);
  const w = speedOf(L);
  const turn = -cosineBeyond(-forwardness(L, w, x, y, z, far), radius / far);
  return Math.sqrt(2 * L[0] * (L[0] + w * turn));
}

/** |u| = γβ of a boost. */
export const speedOf = (L: Mat4): number => Math.sqrt(L[1] * L[1] + L[2] * L[2] + L[3] * L[3]);

const forwardness = (L: Mat4, w: number, x: number, y: number, z: number, far: number): number =>
  w > 0 ? Math.max(-1, Math.min(1, (L[1] * x + L[2] * y + L[3] * z) / (w * far))) : 0;

/** The angle whose cosine is given, plus one below a right angle whose sine is given, at most π: its cosine. */
function cosineBeyond(cosine: number, sine: number): number {
  const k = Math.sqrt(Math.max(0, 1 - sine * sine));
  return cosine <= -k ? -1 : cosine * k - Math.sqrt(Math.max(0, 1 - cosine * cosine)) * sine;
}
