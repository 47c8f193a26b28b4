import type { FlightConditions } from '../../src/flight/arc.ts';
import type { FlightRules } from '../../src/flight/controls.ts';
import { IDENTITY } from '../../src/math/quat.ts';
import type { ObserverState } from '../../src/physics/lorentz/observer.ts';

/** At rest at the origin. */
export const AT_REST: ObserverState = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, properTime: 0 };

/** A ship that is flown by hand. */
export const FLIGHT_RULES: FlightRules = {
  c: 10,
  maxSpeed: 0.99,
  cruise: false,
  up: [0, 1, 0],
  along: 5,
  across: 2,
  level: false,
  attitude: 'hand',
};

/** Nothing holds it, and world time runs. */
export const FREELY: FlightConditions = { c: FLIGHT_RULES.c, lock: 'free', playing: true };
