import { dot, scale, type Vec3 } from '../math/vec3.ts';
import type { Force } from './forces/force.ts';

/** Points with masses, what acts between and upon them, and the speed that none of them reaches. World frame, SI units. */
export interface System {
  /** [m/s]; Infinity: Newton's mechanics. */
  readonly c: number;
  /** At rest, of each point [kg], above 0. */
  readonly masses: Float64Array;
  /** 1 where a point is held: where it is, or where it is led. */
  readonly pinned: Uint8Array;
  /** Where some of those that are held go. */
  readonly led?: readonly KinematicPoint[];
  /** All that has a potential; the force is the sum of theirs. */
  readonly forces: readonly Force[];
  /** Of each point [C]; absent: none is charged. */
  readonly charges?: Float64Array;
  /** The same everywhere and always [T]. Its force q v × B does no work. */
  readonly magneticField?: Vec3;
  /** What air takes away: dp/dt = −drag · p [1/s]. */
  readonly drag: number;
}

/** A point that goes its way whatever pushes it, slower than light. What it takes and gives is in no books. */
export interface KinematicPoint {
  readonly point: number;
  /** [m], at t [s]. */
  positionAt(t: number): Vec3;
}

/** Where all points are, and how they go, at a time. x, y, z of one point after the other. */
export interface State {
  /** [s] */
  t: number;
  /** [m] */
  readonly x: Float64Array;
  /** p = γ m v [kg m/s] */
  readonly p: Float64Array;
}

/** What messages call a point; who knows what it is of says that instead. */
export const pointName = (i: number): string => `point ${i}`;

/** Of x, y, z of one point after the other. */
export const pointAt = (x: Float64Array, i: number): Vec3 => [x[3 * i], x[3 * i + 1], x[3 * i + 2]];

export const copyState = ({ t, x, p }: State): State => ({ t, x: x.slice(), p: p.slice() });

/** Makes a state what another is; both of the same number of points. */
export function assignState(to: State, from: State): void {
  to.t = from.t;
  to.x.set(from.x);
  to.p.set(from.p);
}

/** Something about a system that cannot be, with what to do. */
export class SystemError extends Error {
  /** That it is about, where it is one. */
  readonly point: number | undefined;

  constructor(message: string, point?: number) {
    super(message);
    this.point = point;
  }
}

const MAX_POINTS = 1_000_000;

/** A system with what is left out filled in. Throws a SystemError for what cannot be moved. */
export function makeSystem({
  masses,
  pinned = new Uint8Array(masses.length),
  forces = [],
  c = Number.POSITIVE_INFINITY,
  drag = 0,
  ...rest
}: Partial<System> & Pick<System, 'masses'>): System {
  if (!(c > 0)) throw new SystemError(`the speed of light is ${c} m/s; make it above 0`);
  if (!(drag >= 0 && Number.isFinite(drag))) throw new SystemError(`the drag is ${drag} 1/s; make it 0 or above`);
  if (masses.length > MAX_POINTS)
    throw new SystemError(`there are ${masses.length} points, more than ${MAX_POINTS}; take a coarser mesh`);
  const odd = masses.findIndex((mass) => !(mass > 0 && Number.isFinite(mass)));
  if (odd >= 0) throw new SystemError(`${pointName(odd)} has the mass ${masses[odd]} kg; make it above 0`);
  return { masses, pinned, forces, c, drag, ...rest };
}

/** A state at rest. */
export const stateAtRest = (x: Float64Array, t = 0): State => ({ t, x, p: new Float64Array(x.length) });

/** p = γ m v of a mass; v [m/s] below c. */
export const momentum = (mass: number, v: Vec3, c: number): Vec3 => scale(v, mass / Math.sqrt(1 - dot(v, v) / (c * c)));

/** p = γ m v of all points; v [m/s] below c. Those that are pinned rest. */
export function momenta({ c, masses, pinned }: System, v: ArrayLike<number>): Float64Array {
  const p = new Float64Array(v.length);
  for (let i = 0; i < masses.length; i++) {
    const [vx, vy, vz] = [v[3 * i], v[3 * i + 1], v[3 * i + 2]];
    const rest = 1 - (vx * vx + vy * vy + vz * vz) / (c * c);
    if (!(rest > 0))
      throw new SystemError(
        `${pointName(i)} goes at ${Math.hypot(vx, vy, vz).toPrecision(4)} m/s, not below c = ${c} m/s`,
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

/** v = p/√(m² + p²/c²) [m/s], below c whatever p is. */
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
