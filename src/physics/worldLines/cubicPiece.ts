import { safeguardedNewton } from '../../math/roots.ts';
import { add, addScaled, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { gamma } from '../lorentz/boost.ts';
import { polylineEmission, type RetardedEvent, staticEmission } from './emission.ts';

// Cubic pieces of world lines in Hermite form (docs/physics.md §4.8). Any units in which velocities are lengths per time; in functions of the
// light cone or a slice c = 1 and everything is relative to the observer's event, as in emission.ts.

/** Starts at `a` with the velocity `va` and ends, `span` later, at `b` with `vb`. */
export interface CubicPiece {
  readonly a: Vec3;
  readonly va: Vec3;
  readonly b: Vec3;
  readonly vb: Vec3;
  /** > 0 */
  readonly span: number;
}

/** Position and velocity at the time `s` after the start: with w = s/span and V the chord's velocity, x = a + s [va + w(3V − 2va − vb) + w²(va + vb − 2V)]. */
export function cubicAt({ a, va, b, vb, span }: CubicPiece, s: number): { readonly x: Vec3; readonly v: Vec3 } {
  const w = s / span;
  const at = (i: number): [number, number] => {
    const chord = (b[i] - a[i]) / span;
    const [first, second] = [3 * chord - 2 * va[i] - vb[i], va[i] + vb[i] - 2 * chord];
    return [a[i] + s * (va[i] + w * (first + w * second)), va[i] + w * (2 * first + 3 * w * second)];
  };
  const [x, y, z] = [at(0), at(1), at(2)];
  return { x: [x[0], y[0], z[0]], v: [x[1], y[1], z[1]] };
}

/**
 * The control points of the velocity, a quadratic Bézier curve: va, 3V − va − vb, vb. No velocity in the piece exceeds the
 * largest of them.
 */
export const controlVelocities = ({ a, va, b, vb, span }: CubicPiece): readonly [Vec3, Vec3, Vec3] => [
  va,
  sub(scale(sub(b, a), 3 / span), add(va, vb)),
  vb,
];

/**
 * The largest bend factor λ for which no velocity in the piece exceeds `limit`: 1 keeps the cubic, 0 makes it the chord. All control velocities
 * V + λ(w − V) are then within the limit. Velocities in the unit of `limit`. docs/physics.md §4.8.
 */
export function subluminalBend(piece: CubicPiece, limit: number): number {
  const chord = scale(sub(piece.b, piece.a), 1 / piece.span);
  const room = (limit - length(chord)) * (limit + length(chord));
  if (!(room > 0)) return 0;
  return controlVelocities(piece).reduce((least, w) => Math.min(least, bendWithin(chord, sub(w, chord), room)), 1);
}

/** The largest λ ≤ 1 with |V + λd|² ≤ limit², `room` = limit² − V² > 0; in conjugate form where V·d > 0. */
function bendWithin(chord: Vec3, d: Vec3, room: number): number {
  const [along, square] = [dot(chord, d), dot(d, d)];
  if (2 * along + square <= room) return 1;
  const root = Math.sqrt(along * along + square * room);
  return along > 0 ? room / (along + root) : (root - along) / square;
}

/** The piece with the bend factor applied to its end velocities. */
export function withBend(piece: CubicPiece, bend: number): CubicPiece {
  if (bend === 1) return piece;
  const chord = scale(sub(piece.b, piece.a), 1 / piece.span);
  const towards = (v: Vec3): Vec3 => addScaled(chord, sub(v, chord), bend);
  return { ...piece, va: towards(piece.va), vb: towards(piece.vb) };
}

/**
 * The event at which a piece that starts at tA crosses the past light cone of the origin: the root of f = |x(s)| + tA + s, which increases because
 * all speeds are below c. The piece starts on or inside the cone and ends on or outside it. Lengths and times [m]. docs/physics.md §4.8.
 */
export function cubicEmission(piece: CubicPiece, tA: number): RetardedEvent {
  const late = (s: number): readonly [number, number] => {
    const { x, v } = cubicAt(piece, s);
    const r = length(x);
    return [r + tA + s, 1 + (r > 0 ? dot(x, v) / r : 0)];
  };
  const straight = -polylineEmission(piece.a, tA, piece.b, tA + piece.span).delay - tA;
  return staticEmission(cubicAt(piece, safeguardedNewton(late, 0, piece.span, straight)).x);
}

/** The time s after the start tA at which a piece crosses the slice cΔt = β·Δx: γ(tA + s) − u·x(s) = 0, u = γβ. docs/physics.md §5.4. */
export function cubicCrossing(piece: CubicPiece, tA: number, u: Vec3): number {
  const g = gamma(u);
  const lead = (s: number): readonly [number, number] => {
    const { x, v } = cubicAt(piece, s);
    return [g * (tA + s) - dot(u, x), g - dot(u, v)];
  };
  return safeguardedNewton(lead, 0, piece.span, piece.span / 2);
}
