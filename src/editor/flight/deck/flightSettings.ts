import * as z from 'zod/mini';
import type { CollisionKind } from '../../../flight/collision/collide.ts';
import { ATTITUDES, type Attitude } from '../../../flight/controls.ts';
import { FLIGHT_MODES, type FlightModeName } from '../../../flight/modes/modes.ts';

/** How the user flies, which the page remembers. */
export interface FlightSettings {
  readonly mode: FlightModeName;
  /** Proper acceleration along the nose and across it, in units of c per second. */
  readonly along: number;
  readonly across: number;
  /** Whether the horizon is kept level. */
  readonly level: boolean;
  readonly attitude: Attitude;
  /** What happens at walls; absent: one flies through them. */
  readonly collision?: CollisionKind | undefined;
  /** How far one stays from walls [m]. */
  readonly clearance: number;
  /** Whether one who drives keeps to the ground, with the eye so high above it [m]. */
  readonly ground: boolean;
  readonly eyeHeight: number;
}

export const MODE_NAMES = Object.keys(FLIGHT_MODES) as FlightModeName[];

/** Greatest thrust [c per second]. */
export const MAX_THRUST = 3;

const thrust = z.number().check(z.positive(), z.maximum(MAX_THRUST));
const settingsSchema = z.object({
  mode: z.catch(z.enum(MODE_NAMES), 'velocity'),
  along: z.catch(thrust, 0.5),
  across: z.catch(thrust, 0.25),
  level: z.catch(z.boolean(), false),
  attitude: z.catch(z.enum(ATTITUDES), 'hand'),
  collision: z.catch(z.optional(z.enum(['stop', 'slide'])), undefined),
  clearance: z.catch(z.number().check(z.positive()), 0.3),
  ground: z.catch(z.boolean(), false),
  eyeHeight: z.catch(z.number().check(z.positive()), 1.7),
});

/** The settings of an earlier visit; what of them cannot be read is as at first. */
export const keptSettings = (kept: unknown): FlightSettings =>
  settingsSchema.safeParse(kept).data ?? settingsSchema.parse({});

/** What of a state is kept. */
export const settingsOf = (state: FlightSettings): FlightSettings => settingsSchema.parse(state);
