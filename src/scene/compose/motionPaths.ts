import { fromAxisAngle, IDENTITY, type Quat, rotate, shortestRotation } from '../../math/quat.ts';
import { add, addScaled, cross, distance, lerp, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { pieceAt } from '../motion/poses.ts';
import { type PoseSamples, sampleMotion } from '../motion/resample.ts';
import type { Pose, RigidMotion, SampledMotion } from '../types.ts';
import { perpendicularTo } from './arrange.ts';

/** How a frame is to move, before it is known how far what it carries reaches. Places in the frame of the scene [m]; between two world times [s]. */
export type MotionPath =
  | { readonly kind: 'frame'; readonly motion: RigidMotion }
  | (CircularPath & TimeSpan & { readonly kind: 'circle' })
  | (SpinPath & TimeSpan & { readonly kind: 'spin' })
  | (CurvePath & TimeSpan & { readonly kind: 'path' });

/** When a course begins and ends; before and after it what it carries rests. */
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
  /** It turns as it goes round. */
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
  /** Its −Z turns the way it goes. */
  readonly facing: boolean;
}

/** A course as a motion; `reach` [m]: how far from the frame's origin anything is that it carries. */
export function motionFromPath(course: MotionPath, reach: number): RigidMotion {
  switch (course.kind) {
    case 'frame':
      return course.motion;
    case 'circle':
      return circularMotion(course, { ...course, reach });
    case 'spin':
      return spinMotion(course, { ...course, reach });
    case 'path':
      return curveMotion(course, { ...course, reach });
  }
}

interface SamplingSpan extends TimeSpan {
  readonly reach: number;
}

/** Share of a path's size that a vertex may be beside its way. */
const PATH_TOLERANCE = 1e-4;

/** A path as rigid samples, close enough that a vertex is nowhere seen beside its way. */
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

function circularMotion({ center, axis, radius, rate, facing }: CircularPath, how: SamplingSpan): SampledMotion {
  const x = perpendicularTo(axis);
  const y = cross(axis, x);
  const at = (t: number): Pose => {
    const angle = rate * (t - how.from);
    const out = add(scale(x, Math.cos(angle)), scale(y, Math.sin(angle)));
    return { position: addScaled(center, out, radius), orientation: facing ? fromAxisAngle(axis, angle) : IDENTITY };
  };
  return samplePath(at, how, radius, eighthTurns(rate, how));
}

function spinMotion({ center, axis, rate }: SpinPath, how: SamplingSpan): SampledMotion {
  const at = (t: number): Pose => {
    const orientation = fromAxisAngle(axis, rate * (t - how.from));
    return { position: sub(center, rotate(orientation, center)), orientation };
  };
  return samplePath(at, how, how.reach, eighthTurns(rate, how));
}

/** Pieces of an eighth of a turn: what two samples have between them goes the shorter way. */
const eighthTurns = (rate: number, { from, to }: SamplingSpan): number =>
  Math.max(1, Math.ceil((Math.abs(rate) * (to - from)) / (Math.PI / 4)));

/** A place to be at a time, and the way the thing is turned there. */
export interface PoseKey {
  /** [s] */
  readonly time: number;
  readonly position: Vec3;
  readonly orientation: Quat;
}

/** Straight from key to key, turning evenly. */
export function keyframedMotion(keys: readonly PoseKey[]): SampledMotion {
  const poses = new Float64Array(7 * keys.length);
  keys.forEach(({ position, orientation }, k) => void poses.set([...position, ...orientation], 7 * k));
  return { kind: 'sampled', times: Float64Array.from(keys, ({ time }) => time), poses };
}

/**
 * Along a smooth curve through places at one speed, from the first to the last (centripetal Catmull–Rom, Yuksel et al. 2011: no cusps,
 * no loops).
 */
function curveMotion({ points: places, facing }: CurvePath, how: SamplingSpan): SampledMotion {
  const curve = curveThrough(places);
  const part = (t: number): number => Math.min(1, Math.max(0, (t - how.from) / (how.to - how.from)));
  const at = (t: number): Pose => {
    const s = curve.parameter(part(t));
    const orientation = facing ? shortestRotation([0, 0, -1], curve.way(s)) : IDENTITY;
    return { position: curve.point(s), orientation };
  };
  return samplePath(at, how, curve.length, 8 * places.length);
}

/** Over so much of a piece the way of a curve is taken. */
const STEP = 1e-4;
/** Chords for each piece of a curve by which its length is known. */
const CHORDS = 64;

/** A curve through places, by a parameter that is i at place i; and the parameter by the share of its length. */
function curveThrough(places: readonly Vec3[]) {
  const last = places.length - 1;
  const point = (s: number): Vec3 => {
    const i = Math.min(Math.floor(s), last - 1);
    return catmullRom(places, i, s - i);
  };
  const way = (s: number): Vec3 => sub(point(Math.min(last, s + STEP)), point(Math.max(0, s - STEP)));
  const lengths = new Float64Array(CHORDS * last + 1);
  for (let k = 1; k < lengths.length; k++)
    lengths[k] = lengths[k - 1] + distance(point((k - 1) / CHORDS), point(k / CHORDS));
  const length = lengths[lengths.length - 1];
  const parameter = (share: number): number => {
    const { before, s } = pieceAt(lengths, share * length);
    return (before + s) / CHORDS;
  };
  return { point, way, parameter, length };
}

/** Between place i and the next, by Barry and Goldman's pyramid with knots √distance apart. */
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
