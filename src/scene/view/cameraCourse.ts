import { addScaled, distance, length, lerp, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import {
  type CubicPiece,
  controlVelocities,
  cubicAt,
  subluminalBend,
  withBend,
} from '../../physics/worldLines/cubicPiece.ts';
import { samplePosition } from '../../physics/worldLines/samples.ts';
import { originWorldLine } from '../motion/motion.ts';
import type { CameraCourse, RigidMotion, SceneCamera } from '../types.ts';

/** A knot's velocity is at most so many times the slower of the straight pieces that meet there: the curve never turns back where they do not. Source: Fritsch and Carlson 1980, in one dimension. */
const MAX_OVER_CHORD = 3;
/** A curve is slower than light by at least this part of what its straight piece is. */
const SPEED_RESERVE = 0.1;
/** Of finding knots that are too fast; what is left then is only slowed down. */
const MAX_ROUNDS = 40;

/**
 * The cubic spline through the samples of a motion, with a continuous acceleration (C²) and none at the ends; where its velocity at a sample would be more than three
 * times that of a piece beside it (rests, cuts), or reach c, the velocity there is less, and only it is continuous (C¹). undefined for other motions, and for fewer than
 * three samples, between which nothing jumps. c [m/s]. docs/physics.md §4.14.
 * @example
 * // 1 m in the first second and 2 m in the next: 1.5 m/s between them.
 * const path = { kind: 'sampled', times: Float64Array.of(0, 1, 2), poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 0, 0, 1) } as const;
 * smoothCourse(path, 10)?.line.velocities[3]; // 1.5 m/s
 */
export function smoothCourse(motion: RigidMotion, c: number): CameraCourse | undefined {
  const line = originWorldLine(motion);
  if (line.kind !== 'polyline' || line.times.length < 3) return undefined;
  const { times, positions } = line;
  const count = times.length - 1;
  const spans = Array.from({ length: count }, (_, k) => times[k + 1] - times[k]);
  const chords = spans.map((span, k) => scale(sub(samplePosition(line, k + 1), samplePosition(line, k)), 1 / span));
  const knots = knotVelocities(spans, chords, c);
  const pieces = chords.map((chord, k) => {
    const [a, b] = [samplePosition(line, k), samplePosition(line, k + 1)];
    return slowerThanLight({ a, va: knots[k], b, vb: knots[k + 1], span: spans[k] }, speedLimit(chord, c));
  });
  const velocities = Float64Array.from(pieces.flatMap(({ va, vb }) => [...va, ...vb]));
  const jumps = [...times].filter((_, k) => k > 0 && k < count && jumpsBetween(pieces[k - 1], pieces[k]));
  const strayed = pieces.reduce((most, piece) => Math.max(most, strayedIn(piece)), 0);
  return { line: { kind: 'cubic', times, positions, velocities }, strayed, jumps };
}

/** The camera with its course, if there is one. c [m/s]. */
export function withCourse(camera: SceneCamera, c: number): SceneCamera {
  const course = smoothCourse(camera.motion, c);
  return course ? { ...camera, course } : camera;
}

const slowerThanLight = (piece: CubicPiece, limit: number): CubicPiece =>
  controlVelocities(piece).every((v) => length(v) <= limit) ? piece : withBend(piece, subluminalBend(piece, limit));

/** [m/s] */
const speedLimit = (chord: Vec3, c: number): number => c - SPEED_RESERVE * (c - length(chord));

/** The velocities of the spline at the samples [m/s]. */
function knotVelocities(spans: readonly number[], chords: readonly Vec3[], c: number): readonly Vec3[] {
  const limits = Array.from({ length: chords.length + 1 }, (_, k) => {
    const beside = chords.slice(Math.max(0, k - 1), k + 1);
    return Math.min(...beside.flatMap((chord) => [MAX_OVER_CHORD * length(chord), speedLimit(chord, c)]));
  });
  const fixed = limits.map((limit): Vec3 | undefined => (limit > 0 ? undefined : ZERO));
  // Of the spline itself, what is fast swings through the samples beside it.
  const within = (k: number): Vec3 => {
    const v = parabolaVelocity(spans, chords, k);
    return length(v) > limits[k] ? scale(v, limits[k] / length(v)) : v;
  };
  for (let round = 0; ; round++) {
    const knots = splineVelocities(spans, chords, fixed);
    const fast = knots.flatMap((v, k) => (!fixed[k] && length(v) > limits[k] * (1 + 1e-12) ? [k] : []));
    if (fast.length === 0) return knots;
    if (round === MAX_ROUNDS) return knots.map((v, k) => (fast.includes(k) ? within(k) : v));
    for (const k of fast) fixed[k] = within(k);
  }
}

/** That of the parabola through a sample and its neighbours; at the ends of the chord. */
function parabolaVelocity(spans: readonly number[], chords: readonly Vec3[], k: number): Vec3 {
  if (k === 0 || k === spans.length) return chords[Math.min(k, spans.length - 1)];
  return lerp(chords[k - 1], chords[k], spans[k - 1] / (spans[k - 1] + spans[k]));
}

/**
 * The velocities at the samples for which the acceleration of the cubics between them is continuous where none is given, and 0 at the ends:
 * v₋/h₋ + 2(1/h₋ + 1/h₊)v + v₊/h₊ = 3(V₋/h₋ + V₊/h₊) with the spans h and the chords' velocities V. Source: de Boor, A Practical Guide to Splines, ch. IV.
 */
function splineVelocities(
  spans: readonly number[],
  chords: readonly Vec3[],
  fixed: readonly (Vec3 | undefined)[],
): readonly Vec3[] {
  // Elimination from the first sample on: v = free[k] − next[k]·(the next one).
  const next: number[] = [];
  const free: Vec3[] = [];
  for (let k = 0; k <= spans.length; k++) {
    const given = fixed[k];
    const [before, after] = [k > 0 ? 1 / spans[k - 1] : 0, k < spans.length ? 1 / spans[k] : 0];
    const rest = 2 * (before + after) - before * (next[k - 1] ?? 0);
    const wanted = addScaled(scale(chords[k - 1] ?? ZERO, 3 * before), chords[k] ?? ZERO, 3 * after);
    next.push(given ? 0 : after / rest);
    free.push(given ?? scale(addScaled(wanted, free[k - 1] ?? ZERO, -before), 1 / rest));
  }
  const found = [...free];
  for (let k = spans.length - 1; k >= 0; k--) found[k] = addScaled(free[k], found[k + 1], -next[k]);
  return found;
}

const jumpsBetween = ({ vb }: CubicPiece, { va }: CubicPiece): boolean =>
  distance(vb, va) > 1e-9 * (length(vb) + length(va));

function strayedIn(piece: CubicPiece): number {
  const chord = scale(sub(piece.b, piece.a), 1 / piece.span);
  const at = (s: number): number => distance(cubicAt(piece, s).x, addScaled(piece.a, chord, s));
  return Math.max(...Array.from({ length: 8 }, (_, i) => at(((i + 0.5) / 8) * piece.span)));
}
