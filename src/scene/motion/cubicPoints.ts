import { slopeRule } from '../../math/hermite.ts';
import { length, lerp, type Vec3 } from '../../math/vec3.ts';
import { type CubicPiece, controlVelocities, subluminalBend } from '../../physics/worldLines/cubicPiece.ts';
import { isListed } from '../streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../types.ts';

/** Points that move along cubic pieces. */
export interface CubicPointsMotion extends SampledPointsMotion {
  readonly points: readonly Float32Array[];
  readonly velocities: readonly Float32Array[];
}

export const isCubic = (motion: SampledPointsMotion): motion is CubicPointsMotion =>
  motion.velocities !== undefined && isListed(motion.points);

/** The velocity of every point at each sample, that of the parabola through its neighbours [m/s]; 3 numbers per point. */
export const parabolaVelocities = (times: Float64Array, points: readonly Float32Array[]): Float32Array[] =>
  points.map((_, k) => parabolaVelocityAt(times, (j) => points[j], k));

/** The same at sample k; `pointsAt` is called only for the samples needed. */
export function parabolaVelocityAt(
  times: Float64Array,
  pointsAt: (k: number) => Float32Array,
  k: number,
): Float32Array {
  const { middle, share } = slopeRule(times, k);
  const [a, b] = [pointsAt(middle - 1), pointsAt(middle)];
  const c = share === 0 ? b : pointsAt(middle + 1);
  const first = (1 - share) / (times[middle] - times[middle - 1]);
  const second = share === 0 ? 0 : share / (times[middle + 1] - times[middle]);
  const out = new Float32Array(a.length);
  for (let i = 0; i < out.length; i++) out[i] = (b[i] - a[i]) * first + (c[i] - b[i]) * second;
  return out;
}

/** Greatest number of coordinates that `estimateChordError` evaluates. */
const MAX_ESTIMATED_COORDINATES = 2 ** 22;

/**
 * Estimates the greatest distance of cubics through the points from their chords [m]: h|v₁ − v₀|/8 in the middle of a piece; of large motions
 * evenly chosen points. 0 for two samples.
 */
export function estimateChordError(times: Float64Array, points: readonly Float32Array[]): number {
  const step = Math.max(1, Math.ceil((points[0].length * times.length) / MAX_ESTIMATED_COORDINATES));
  let error = 0;
  for (let k = 0; k + 1 < times.length; k++)
    error = Math.max(error, ((times[k + 1] - times[k]) / 8) * maxVelocityChange(times, points, k, step));
  return error;
}

/** The greatest |v₁ − v₀| of the piece after sample k, of every `step`-th point [m/s]: a weighted sum of the chords of three pieces. */
function maxVelocityChange(times: Float64Array, points: readonly Float32Array[], k: number, step: number): number {
  const weights = [0, 0, 0];
  for (const end of [0, 1]) {
    const { middle, share } = slopeRule(times, k + end);
    const sign = end === 0 ? -1 : 1;
    weights[middle - k] += (sign * (1 - share)) / (times[middle] - times[middle - 1]);
    if (share !== 0) weights[middle - k + 1] += (sign * share) / (times[middle + 1] - times[middle]);
  }
  const [first, second, third] = weights;
  const [a, b, c, d] = [k - 1, k, k + 1, k + 2].map((j) => points[Math.min(Math.max(j, 0), points.length - 1)]);
  let greatest = 0;
  for (let i = 0; i < a.length; i += 3 * step) {
    let square = 0;
    for (let j = i; j < i + 3; j++)
      square += (first * (b[j] - a[j]) + second * (c[j] - b[j]) + third * (d[j] - c[j])) ** 2;
    if (square > greatest && square < Number.POSITIVE_INFINITY) greatest = square;
  }
  return Math.sqrt(greatest);
}

/** Point i between samples k and k + 1, relative to the motion's origin, with its full bend [m, m/s]. */
export function pointPiece({ times, points, velocities }: CubicPointsMotion, k: number, i: number): CubicPiece {
  const read = (from: Float32Array): readonly [number, number, number] => [
    from[3 * i],
    from[3 * i + 1],
    from[3 * i + 2],
  ];
  return {
    a: read(points[k]),
    va: read(velocities[k]),
    b: read(points[k + 1]),
    vb: read(velocities[k + 1]),
    span: times[k + 1] - times[k],
  };
}

/**
 * The two inner Bézier control points of every point between samples k and k + 1, relative to the motion's origin [m]: with any bend factor, its path is within
 * the convex hull of these and its places at the samples.
 */
export function innerControlPoints(
  { times, points, velocities }: CubicPointsMotion,
  k: number,
): readonly [Float32Array, Float32Array] {
  const third = (times[k + 1] - times[k]) / 3;
  return [
    points[k].map((x, i) => x + third * velocities[k][i]),
    points[k + 1].map((x, i) => x - third * velocities[k + 1][i]),
  ];
}

/** Greatest control velocity of a cubic, as a fraction of c. */
export const MAX_CONTROL_SPEED = 0.999;

/** Cached values of a motion's pieces: greatest control velocity [m/s], and bend factor for one speed of light. NaN: not computed yet. */
interface SpeedCache {
  readonly greatest: Float64Array;
  c: number;
  bends: Float64Array;
}
const speedCaches = new WeakMap<CubicPointsMotion, SpeedCache>();

function speedCacheOf(motion: CubicPointsMotion): SpeedCache {
  const empty = () => new Float64Array(motion.times.length - 1).fill(Number.NaN);
  const cache = speedCaches.get(motion) ?? { greatest: empty(), c: Number.NaN, bends: empty() };
  speedCaches.set(motion, cache);
  return cache;
}

/** Upper bound of all speeds between samples k and k + 1, with the full bend [m/s]. */
export function maxControlSpeed(motion: CubicPointsMotion, k: number): number {
  const { greatest } = speedCacheOf(motion);
  if (Number.isNaN(greatest[k])) greatest[k] = Math.sqrt(maxControlSpeedSquared(motion, k));
  return greatest[k];
}

function maxControlSpeedSquared(motion: CubicPointsMotion, k: number): number {
  let greatest = 0;
  for (let i = 0; 3 * i < motion.points[k].length; i++)
    greatest = Math.max(greatest, controlSpeedSquared(motion, k, i));
  return greatest;
}

/** The square of the greatest control velocity of point i between samples k and k + 1, without allocating per point, since meshes are large. */
function controlSpeedSquared({ times, points, velocities }: CubicPointsMotion, k: number, i: number): number {
  const a = points[k];
  const b = points[k + 1];
  const va = velocities[k];
  const vb = velocities[k + 1];
  const threefold = 3 / (times[k + 1] - times[k]);
  let begin = 0;
  let middle = 0;
  let end = 0;
  for (let j = 3 * i; j < 3 * i + 3; j++) {
    begin += va[j] ** 2;
    middle += (threefold * (b[j] - a[j]) - va[j] - vb[j]) ** 2;
    end += vb[j] ** 2;
  }
  return Math.max(begin, middle, end);
}

/** Upper bound of the speed of point i between samples k and k + 1, with any bend factor [m/s]. */
export const pointSpeedBound = (motion: CubicPointsMotion, k: number, i: number): number =>
  Math.sqrt(controlSpeedSquared(motion, k, i));

/**
 * The bend factor of the piece after sample k at the speed of light c [m/s], the same for all points: 1, unless a control velocity exceeds
 * `MAX_CONTROL_SPEED`; then the smallest of all points' (`subluminalBend`), down to 0 for the chords.
 */
export function bendFactor(motion: CubicPointsMotion, k: number, c: number): number {
  if (maxControlSpeed(motion, k) <= MAX_CONTROL_SPEED * c) return 1;
  const cache = speedCacheOf(motion);
  if (cache.c !== c) {
    cache.c = c;
    cache.bends.fill(Number.NaN);
  }
  if (Number.isNaN(cache.bends[k])) {
    let least = 1;
    for (let i = 0; 3 * i < motion.points[k].length; i++)
      least = Math.min(least, subluminalBend(pointPiece(motion, k, i), MAX_CONTROL_SPEED * c));
    cache.bends[k] = least;
  }
  return cache.bends[k];
}

/** The samples k whose following piece is straightened at the speed of light c [m/s], and the fraction of its bend that is lost. */
export function straightenedPieces(
  motion: CubicPointsMotion,
  c: number,
): { readonly k: number; readonly lost: number }[] {
  return Array.from({ length: motion.times.length - 1 }, (_, k) => ({ k, lost: 1 - bendFactor(motion, k, c) })).filter(
    ({ lost }) => lost > 0,
  );
}

/** The greatest speed in a piece, with a relative error of 10⁻⁹, or `atLeast` if that is greater. The velocity is a Bézier curve, subdivided until its inner control point is no longer the greatest. */
export function maxPieceSpeed(piece: CubicPiece, atLeast = 0): number {
  const greatest = ([a, b, c]: readonly [Vec3, Vec3, Vec3], bound: number, halvings: number): number => {
    const ends = Math.max(bound, length(a), length(c));
    if (length(b) <= ends * (1 + 1e-9) || halvings === 0) return ends;
    const [ab, bc] = [lerp(a, b, 0.5), lerp(b, c, 0.5)];
    const middle = lerp(ab, bc, 0.5);
    return greatest([middle, bc, c], greatest([a, ab, middle], ends, halvings - 1), halvings - 1);
  };
  return greatest(controlVelocities(piece), atLeast, 30);
}
