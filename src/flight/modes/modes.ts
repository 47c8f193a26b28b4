import { autopilotMode } from './autopilot.ts';
import { driveMode } from './drive.ts';
import type { FlightMode } from './flightMode.ts';
import { followMode } from './follow.ts';
import { thrustMode, vehicleMode } from './thrust.ts';
import { velocityMode } from './velocity.ts';

/** The ways to fly, by their names in files, in the order in which people choose among them. */
export const FLIGHT_MODES = {
  velocity: velocityMode,
  drive: driveMode,
  thrust: thrustMode,
  vehicle: vehicleMode,
  follow: followMode,
  autopilot: autopilotMode,
} as const satisfies Readonly<Record<string, FlightMode>>;

export type FlightModeName = keyof typeof FLIGHT_MODES;
