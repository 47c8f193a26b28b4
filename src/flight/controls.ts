import { type Vec3, ZERO } from '../math/vec3.ts';
import type { Boost } from './boost.ts';

/** What the pilot asks of the ship for a moment. */
export interface FlightControls {
  /** Each −1 … 1: right, up, back. */
  readonly thrust: Vec3;
  /** Turn since the last moment [rad]: pitch about the ship's right, yaw about its up, roll about its back. */
  readonly turn: Vec3;
  /** Whether the greatest speed is allowed. */
  readonly fullSpeed: boolean;
  /** Whether to come to rest. */
  readonly brake: boolean;
}
export const NO_CONTROLS: FlightControls = { thrust: ZERO, turn: ZERO, fullSpeed: false, brake: false };

/** Where a ship holds its nose: as it is turned by hand, into the motion, against it, or along the push of its engine. */
export const ATTITUDES = ['hand', 'motion', 'against', 'push'] as const;
export type Attitude = (typeof ATTITUDES)[number];

/** The ground of one who drives. */
export interface Ground {
  /** Of the frame where it rests, in the world. */
  readonly velocity: Boost;
  /** Its unit normal in that frame, on the world's axes carried by the pure boost; upwards. */
  readonly normal: Vec3;
}

/** What the ship can do, and where. */
export interface FlightRules {
  /** [m/s] */
  readonly c: number;
  /** Upper speed limit as a fraction of c. */
  readonly maxSpeed: number;
  /** Whether a velocity that is asked for is kept when nothing is asked; otherwise one brakes to rest. */
  readonly cruise: boolean;
  /** The scene's up axis. */
  readonly up: Vec3;
  /** Proper acceleration along the ship's nose, and across it [m/s²]. */
  readonly along: number;
  readonly across: number;
  /** Whether the horizon stays level where the mode lets one roll. */
  readonly level: boolean;
  readonly attitude: Attitude;
  /** Velocity of the body that is followed, in the world; absent: none is. */
  readonly followed?: Boost;
  /** What one drives on; absent: level, at rest in the world. */
  readonly ground?: Ground;
  /** Where the autopilot goes, world frame [m]; absent: nowhere. */
  readonly destination?: Vec3;
}

/** The state of a ship is exact up to here: e³⁰⁰ is far within what 64 bits hold, and its square too. */
export const MAX_RAPIDITY = 300;

/** The rapidity that a ship does not exceed. */
export const rapidityLimit = ({ maxSpeed }: Pick<FlightRules, 'maxSpeed'>): number =>
  Math.min(MAX_RAPIDITY, Math.atanh(maxSpeed));
