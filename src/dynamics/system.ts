import { dot, scale, type Vec3 } from '../math/vec3.ts';
import { inEnglish, type LocalizedText, type Message, msg } from '../messages/message.ts';
import { MessageError } from '../messages/messageError.ts';
import type { Force } from './forces/force.ts';

/** Point masses, the forces on and between them, and the limiting speed. World frame, SI units. */
export interface System {
  /** [m/s]; Infinity: Newtonian mechanics. */
  readonly c: number;
  /** Rest mass of each point [kg], positive. */
  readonly masses: Float64Array;
  /** 1 for points that are fixed or kinematic. */
  readonly pinned: Uint8Array;
  /** Prescribed motions of some of the pinned points. */
  readonly kinematic?: readonly KinematicPoint[];
  /** Potentials; the force is the sum of theirs. */
  readonly forces: readonly Force[];
  /** Charge of each point [C]; absent: none. */
  readonly charges?: Float64Array;
  /** Uniform and constant [T]. Its force q v × B does no work. */
  readonly magneticField?: Vec3;
  /** Linear drag: dp/dt = −drag · p [1/s]. */
  readonly drag: number;
}

/** A point with prescribed motion, slower than light. The energy it exchanges is not recorded. */
export interface KinematicPoint {
  /** Its index; it is pinned. */
  readonly point: number;
  /** Position [m] at t [s]. */
  positionAt(t: number): Vec3;
}

/** Positions and momenta of all points at a time. x, y, z of each point. */
export interface State {
  /** [s] */
  t: number;
  /** [m] */
  readonly x: Float64Array;
  /** p = γ m v [kg m/s] */
  readonly p: Float64Array;
}

/** What a point is called where its object is not known. */
export const pointName = (i: number): Message => msg`point ${i}`;

/** The message with another name of a point. */
export const withPointName = (message: Message, point: number, name: LocalizedText): Message => ({
  ...message,
  values: message.values.map((value) => {
    if (typeof value !== 'object') return value;
    return inEnglish(value) === inEnglish(pointName(point)) ? name : withPointName(value, point, name);
  }),
});

/** Components of a point in x, y, z order. */
export const pointAt = (x: Float64Array, i: number): Vec3 => [x[3 * i], x[3 * i + 1], x[3 * i + 2]];

/**
 * A state of its own, with the same numbers.
 * @example
 * const state = stateAtRest(Float64Array.of(1, 2, 3));
 * copyState(state).x === state.x; // false
 */
export const copyState = ({ t, x, p }: State): State => ({ t, x: x.slice(), p: p.slice() });

/** Copies a state of the same number of points. */
export function assignState(to: State, from: State): void {
  to.t = from.t;
  to.x.set(from.x);
  to.p.set(from.p);
}

/**
 * An invalid system, with what to do about it.
 * @example
 * import { msg } from 'slowlight/messages';
 * const error = new SystemError(msg`point 2 has no mass`, 2);
 * error.point; // 2
 */
export class SystemError extends MessageError {
  /** The affected point, if there is one. */
  readonly point: number | undefined;

  constructor(text: Message, point?: number) {
    super(text);
    this.point = point;
  }
}

const MAX_POINTS = 1_000_000;

/**
 * Fills in defaults. Throws a SystemError for an invalid system.
 * @example
 * makeSystem({ masses: Float64Array.of(1, 2) }); // { c: Infinity, pinned: [0, 0], drag: 0 }
 */
export function makeSystem({
  masses,
  pinned = new Uint8Array(masses.length),
  forces = [],
  c = Number.POSITIVE_INFINITY,
  drag = 0,
  ...rest
}: Partial<System> & Pick<System, 'masses'>): System {
  if (!(c > 0)) throw new SystemError(msg`the speed of light is ${c} m/s; make it above 0`);
  if (!(drag >= 0 && Number.isFinite(drag))) throw new SystemError(msg`the drag is ${drag} 1/s; make it 0 or above`);
  if (masses.length > MAX_POINTS)
    throw new SystemError(msg`there are ${masses.length} points, more than ${MAX_POINTS}; take a coarser mesh`);
  const odd = masses.findIndex((mass) => !(mass > 0 && Number.isFinite(mass)));
  if (odd >= 0) throw new SystemError(msg`${pointName(odd)} has the mass ${masses[odd]} kg; make it above 0`);
  return { masses, pinned, forces, c, drag, ...rest };
}

/**
 * A state at rest.
 * @example
 * stateAtRest(Float64Array.of(1, 2, 3)); // { t: 0, x: [1, 2, 3], p: [0, 0, 0] }
 */
export const stateAtRest = (x: Float64Array, t = 0): State => ({ t, x, p: new Float64Array(x.length) });

/** p = γ m v of a mass; v [m/s] below c. */
export const momentum = (mass: number, v: Vec3, c: number): Vec3 => scale(v, mass / Math.sqrt(1 - dot(v, v) / (c * c)));

/**
 * p = γ m v of all points; v [m/s] below c. Pinned points are at rest.
 * @example
 * // γ m v at 0.6 c, with c = 10 m/s.
 * momenta(makeSystem({ masses: Float64Array.of(2), c: 10 }), [6, 0, 0]); // [15, 0, 0] kg m/s
 */
export function momenta({ c, masses, pinned }: System, v: ArrayLike<number>): Float64Array {
  const p = new Float64Array(v.length);
  for (let i = 0; i < masses.length; i++) {
    const [vx, vy, vz] = [v[3 * i], v[3 * i + 1], v[3 * i + 2]];
    const rest = 1 - (vx * vx + vy * vy + vz * vz) / (c * c);
    if (!(rest > 0))
      throw new SystemError(
        msg`${pointName(i)} goes at ${Math.hypot(vx, vy, vz).toPrecision(4)} m/s, not below c = ${c} m/s`,
        i,
      );
    const mass = pinned[i] ? 0 : masses[i] / Math.sqrt(rest);
    p[3 * i] = mass * vx;
    p[3 * i + 1] = mass * vy;
    p[3 * i + 2] = mass * vz;
  }
  return p;
}

/** E/c² = √(m² + p²/c²) = γm of each point [kg]. */
export function relativisticMasses({ c, masses }: System, p: Float64Array, out: Float64Array): void {
  const perSquare = 1 / (c * c);
  for (let i = 0, j = 0; i < masses.length; i++, j += 3)
    out[i] = Math.sqrt(masses[i] * masses[i] + (p[j] * p[j] + p[j + 1] * p[j + 1] + p[j + 2] * p[j + 2]) * perSquare);
}

/**
 * v = p/√(m² + p²/c²) [m/s], below c for any p.
 * @example
 * const v = new Float64Array(3);
 * velocities(makeSystem({ masses: Float64Array.of(1), c: 10 }), Float64Array.of(7.5, 0, 0), v);
 * v; // [6, 0, 0] m/s
 */
export function velocities(system: System, p: Float64Array, out: Float64Array): void {
  const { c, masses } = system;
  const perSquare = 1 / (c * c);
  for (let i = 0, j = 0; i < masses.length; i++, j += 3) {
    const square = p[j] * p[j] + p[j + 1] * p[j + 1] + p[j + 2] * p[j + 2];
    const slow = 1 / Math.sqrt(masses[i] * masses[i] + square * perSquare);
    out[j] = p[j] * slow;
    out[j + 1] = p[j + 1] * slow;
    out[j + 2] = p[j + 2] * slow;
  }
}
