import { fromAxisAngle, IDENTITY, type Quat, rotate, shortestRotation } from '../../math/quat.ts';
import { add, addScaled, cross, distance, lerp, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { pieceAt } from '../motion/poses.ts';
import { type PoseSamples, sampleMotion } from '../motion/resample.ts';
import type { Pose, RigidMotion, SampledMotion } from '../types.ts';
import { perpendicularTo } from './arrange.ts';

/** The path of a frame before the size of what it carries is known. Places in the scene's frame [m], between two world times [s]. */
export type MotionPath =
  | { readonly kind: 'frame'; readonly motion: RigidMotion }
  | (CircularPath & TimeSpan & { readonly kind: 'circle' })
  | (SpinPath & TimeSpan & { readonly kind: 'spin' })
  | (CurvePath & TimeSpan & { readonly kind: 'path' });

/** World times at which a path begins and ends; before and after them the frame rests. */
export interface TimeSpan {
  readonly from: number;
  readonly to: number;
}
export interface CircularPath {
  readonly center: Vec3;
  /** Unit. */
  readonly axis: Vec3;
  readonly radius: number;
  /** [rad/s] */
  readonly rate: number;
  /** Whether the frame turns with the circle. */
  readonly facing: boolean;
}
export interface SpinPath {
  readonly center: Vec3;
  /** Unit. */
  readonly axis: Vec3;
  /** [rad/s] */
  readonly rate: number;
}
export interface CurvePath {
  /** At least two. */
  readonly points: readonly Vec3[];
  /** Whether −Z of the frame turns to the direction of motion. */
  readonly facing: boolean;
}

type PathMotion<P extends MotionPath> = (path: P, reach: number) => RigidMotion;

const PATH_MOTIONS: { readonly [K in MotionPath['kind']]: PathMotion<Extract<MotionPath, { readonly kind: K }>> } = {
  frame: ({ motion }) => motion,
  circle: (path, reach) => circularMotion(path, { ...path, reach }),
  spin: (path, reach) => spinMotion(path, { ...path, reach }),
  path: (path, reach) => curveMotion(path, { ...path, reach }),
};

/** The motion along a path; `reach` [m]: greatest distance from the frame's origin of what it carries. */
export const motionFromPath = (path: MotionPath, reach: number): RigidMotion =>
  (PATH_MOTIONS[path.kind] as PathMotion<MotionPath>)(path, reach);

interface SamplingSpan extends TimeSpan {
  readonly reach: number;
}

/** Greatest distance of a vertex from its path, as a fraction of the path's size. */
const PATH_TOLERANCE = 1e-4;

/** Samples a path within the tolerance for all vertices. */
function samplePath(
  at: (t: number) => Pose,
  { from, to, reach }: SamplingSpan,
  size: number,
  steps: number,
): SampledMotion {
  const times = Float64Array.from({ length: steps + 1 }, (_, k) => from + ((to - from) * k) / steps);
  const samples: PoseSamples = sampleMotion(at, times, reach, PATH_TOLERANCE * (size + reach));
  return { kind: 'sampled', ...samples };
}

function circularMotion({ center, axis, radius, rate, facing }: CircularPath, span: SamplingSpan): SampledMotion {
  const x = perpendicularTo(axis);
  const y = cross(axis, x);
  const at = (t: number): Pose => {
    const angle = rate * (t - span.from);
    const out = add(scale(x, Math.cos(angle)), scale(y, Math.sin(angle)));
    return { position: addScaled(center, out, radius), orientation: facing ? fromAxisAngle(axis, angle) : IDENTITY };
  };
  return samplePath(at, span, radius, eighthTurns(rate, span));
}

function spinMotion({ center, axis, rate }: SpinPath, span: SamplingSpan): SampledMotion {
  const at = (t: number): Pose => {
    const orientation = fromAxisAngle(axis, rate * (t - span.from));
    return { position: sub(center, rotate(orientation, center)), orientation };
  };
  return samplePath(at, span, span.reach, eighthTurns(rate, span));
}

/** Number of pieces of at most an eighth of a turn, since motion between two samples takes the smaller angle. */
const eighthTurns = (rate: number, { from, to }: SamplingSpan): number =>
  Math.max(1, Math.ceil((Math.abs(rate) * (to - from)) / (Math.PI / 4)));

/** A pose at a time. */
export interface PoseKey {
  /** [s] */
  readonly time: number;
  readonly position: Vec3;
  readonly orientation: Quat;
}

/** Straight from key to key, turning uniformly. */
export function keyframedMotion(keys: readonly PoseKey[]): SampledMotion {
  const poses = new Float64Array(7 * keys.length);
  keys.forEach(({ position, orientation }, k) => void poses.set([...position, ...orientation], 7 * k));
  return { kind: 'sampled', times: Float64Array.from(keys, ({ time }) => time), poses };
}

/**
 * Along a smooth curve through places at constant speed, from the first to the last (centripetal Catmull–Rom, Yuksel et al. 2011: no cusps,
 * no loops).
 */
function curveMotion({ points: places, facing }: CurvePath, span: SamplingSpan): SampledMotion {
  const curve = curveThrough(places);
  const part = (t: number): number => Math.min(1, Math.max(0, (t - span.from) / (span.to - span.from)));
  const at = (t: number): Pose => {
    const s = curve.parameter(part(t));
    const orientation = facing ? shortestRotation([0, 0, -1], curve.tangent(s)) : IDENTITY;
    return { position: curve.point(s), orientation };
  };
  return samplePath(at, span, curve.length, 8 * places.length);
}

/** Step of the difference quotient of a curve's tangent, in pieces. */
const STEP = 1e-4;
/** Chords per piece from which a curve's length is computed. */
const CHORDS = 64;

/** A curve through places, with a parameter that is i at place i; `parameter` gives it by fraction of the length. */
function curveThrough(places: readonly Vec3[]) {
  const last = places.length - 1;
  const point = (s: number): Vec3 => {
    const i = Math.min(Math.floor(s), last - 1);
    return catmullRom(places, i, s - i);
  };
  const tangent = (s: number): Vec3 => sub(point(Math.min(last, s + STEP)), point(Math.max(0, s - STEP)));
  const lengths = new Float64Array(CHORDS * last + 1);
  for (let k = 1; k < lengths.length; k++)
    lengths[k] = lengths[k - 1] + distance(point((k - 1) / CHORDS), point(k / CHORDS));
  const length = lengths[lengths.length - 1];
  const parameter = (fraction: number): number => {
    const { before, s } = pieceAt(lengths, fraction * length);
    return (before + s) / CHORDS;
  };
  return { point, tangent, parameter, length };
}

/** Point between place i and the next, by Barry and Goldman's pyramid with knots √distance apart. */
function catmullRom(places: readonly Vec3[], i: number, s: number): Vec3 {
  const [b, c] = [places[i], places[i + 1]];
  const a = places[i - 1] ?? sub(scale(b, 2), c);
  const d = places[i + 2] ?? sub(scale(c, 2), b);
  const knots = [0, 0, 0, 0];
  [a, b, c].forEach((from, k) => {
    knots[k + 1] = knots[k] + Math.max(Math.sqrt(distance(from, [b, c, d][k])), 1e-9);
  });
  const t = knots[1] + s * (knots[2] - knots[1]);
  const mix = (p: Vec3, q: Vec3, from: number, to: number): Vec3 =>
    lerp(p, q, (t - knots[from]) / (knots[to] - knots[from]));
  const [ab, bc, cd] = [mix(a, b, 0, 1), mix(b, c, 1, 2), mix(c, d, 2, 3)];
  return mix(mix(ab, bc, 0, 2), mix(bc, cd, 1, 3), 1, 2);
}
