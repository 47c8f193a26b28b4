import { dot, length, type Vec3, ZERO } from '../../math/vec3.ts';
import { gamma, velocity } from '../lorentz/boost.ts';
import type { ObserverEvent } from './kinds/worldLineKind.ts';
import { pastLightCone } from './lightCone.ts';
import { simultaneitySlice } from './simultaneity.ts';
import type { SimultaneousEvent } from './slice.ts';
import type { WorldLine } from './worldLine.ts';

/** The gradient of c(t − t_o) over the world's space, outwards: a constant vector, and a part along the direction away from the observer. */
export interface TimeGradient {
  readonly linear: Vec3;
  readonly radial: number;
}

/**
 * A hypersurface of spacetime through the observer's event that every world line intersects at most once: the events that a picture shows.
 * Times are relative to the observer's event, c(t − t_o) [m of light]; places are observer → event, world frame [m]; u is the observer's γβ.
 */
export interface Hypersurface {
  /** Whether it is the past light cone, else it is spacelike. */
  readonly isLightCone: boolean;
  /** What light travels on from lamps to the events that are shown: each other's past light cones, or one moment. */
  readonly lightSurface: LightSurfaceName;
  /** γβ of the frame whose moment it is, or, of a cone between, begins as; 0 for the light cone. */
  momentVelocity(u: Vec3): Vec3;
  /** Its intersection with a world line; undefined behind a horizon. c [m/s]. */
  intersect(line: WorldLine, observer: ObserverEvent, u: Vec3, c: number): SimultaneousEvent | undefined;
  /** The most by which c(t − t_o) changes per metre of the world. */
  steepness(u: Vec3): number;
  /** c(t − t_o) at Δx. */
  timeAt(dx: Vec3, u: Vec3): number;
  /** How far an event lies to the future of the hypersurface [m of light, times a positive constant]; it increases along every world line. `g`: γ of u. */
  lateness(x: number, y: number, z: number, t: number, u: Vec3, g: number): number;
  /** d(lateness)/d(ct) at (x, y, z, t) along a world line with velocity v [c]. */
  latenessRate(
    x: number,
    y: number,
    z: number,
    t: number,
    vx: number,
    vy: number,
    vz: number,
    u: Vec3,
    g: number,
  ): number;
  /** Time [m of light] that a point with velocity v [c] takes from its place a at the time T before the observer's to the hypersurface. */
  crossingTime(
    T: number,
    ax: number,
    ay: number,
    az: number,
    vx: number,
    vy: number,
    vz: number,
    u: Vec3,
    g: number,
  ): number;
}

/** One on which light can travel. */
export interface LightSurface extends Hypersurface {
  timeGradient(u: Vec3): TimeGradient;
}

/** |Δx| = −c(t − t_o): what is seen. docs/physics.md §3.1. */
const PAST_LIGHT_CONE: LightSurface = {
  isLightCone: true,
  lightSurface: 'past-light-cone',
  momentVelocity: () => ZERO,
  intersect(line, observer, _, c) {
    const seen = pastLightCone(line, observer, c);
    return seen && { offset: seen.offset, ahead: -seen.delay };
  },
  steepness: () => 1,
  timeGradient: () => ({ linear: ZERO, radial: -1 }),
  timeAt: (dx) => -length(dx),
  lateness: (x, y, z, t) => Math.sqrt(x * x + y * y + z * z) + t,
  latenessRate(x, y, z, _t, vx, vy, vz) {
    const r = Math.sqrt(x * x + y * y + z * z);
    return r > 0 ? 1 + (x * vx + y * vy + z * vz) / r : 1;
  },
  // As `timeSince` of emission.ts.
  crossingTime(T, ax, ay, az, vx, vy, vz) {
    const nx = ax + vx * T;
    const ny = ay + vy * T;
    const nz = az + vz * T;
    const slow = 1 - (vx * vx + vy * vy + vz * vz);
    const away = nx * vx + ny * vy + nz * vz;
    const now = nx * nx + ny * ny + nz * nz;
    const root = Math.sqrt(Math.max(0, away * away + slow * now));
    if (away > 0) return T - now / (away + root);
    const g = T + ax * vx + ay * vy + az * vz;
    const r = Math.sqrt(ax * ax + ay * ay + az * az);
    return g > 0 ? ((T - r) * (T + r)) / (g + root) : (g - root) / slow;
  },
};

/** c(t − t_o) = β·Δx: one moment of the observer's frame. docs/physics.md §5.2. */
const SLICE: LightSurface = {
  isLightCone: false,
  lightSurface: 'slice',
  momentVelocity: (u) => u,
  intersect: (line, observer, u, c) => simultaneitySlice(line, observer, u, c),
  steepness: (u) => length(velocity(u)),
  timeGradient: (u) => ({ linear: velocity(u), radial: 0 }),
  timeAt: (dx, u) => dot(u, dx) / gamma(u),
  lateness: (x, y, z, t, u, g) => g * t - (u[0] * x + u[1] * y + u[2] * z),
  latenessRate: (_x, _y, _z, _t, vx, vy, vz, u, g) => g - (u[0] * vx + u[1] * vy + u[2] * vz),
  // As `uniformSlice`.
  crossingTime: (T, ax, ay, az, vx, vy, vz, u, g) =>
    (u[0] * ax + u[1] * ay + u[2] * az + g * T) / (g - (u[0] * vx + u[1] * vy + u[2] * vz)),
};

/** t = t_o: one moment of the world's frame. */
const NOW: LightSurface = {
  isLightCone: false,
  lightSurface: 'now',
  momentVelocity: () => ZERO,
  intersect: (line, observer, _, c) => simultaneitySlice(line, observer, ZERO, c),
  steepness: () => 0,
  timeGradient: () => ({ linear: ZERO, radial: 0 }),
  timeAt: () => 0,
  lateness: (_x, _y, _z, t) => t,
  latenessRate: () => 1,
  crossingTime: (T) => T,
};

export const LIGHT_SURFACES = {
  'past-light-cone': PAST_LIGHT_CONE,
  slice: SLICE,
  now: NOW,
} as const satisfies Readonly<Record<string, LightSurface>>;
export type LightSurfaceName = keyof typeof LIGHT_SURFACES;
