import type { Vec3 } from '../math/vec3.ts';

/** A part of a flight that a lesson shows: at one velocity [c] for so long by the own clock [s], or a trip from rest to rest. */
type FlightPart =
  | { readonly kind: 'coast'; readonly beta: Vec3; readonly lasts: number }
  | { readonly kind: 'trip'; readonly by: Vec3; readonly acceleration: number };
export type FlightPlan = readonly FlightPart[];

const COAST = /^coast (.+) for (\d+(?:\.\d+)?)$/;
const TRIP = /^trip (.+) at (\d+(?:\.\d+)?)$/;

/**
 * `coast 0.6, 0, 0 for 8` (β and own seconds), `trip -90, 0, 0 at 5` (a way [m] and a proper acceleration [m/s²]), several
 * with `;` between them, or `none`. Undefined if it is none of these.
 */
export function parseFlightPlan(text: string): FlightPlan | undefined {
  if (text === 'none') return [];
  const parts = text.split(';').map((part) => parsePart(part.trim()));
  return parts.every((part) => part !== undefined) ? parts : undefined;
}

function parsePart(text: string): FlightPart | undefined {
  const [, velocity = '', lasts] = COAST.exec(text) ?? [];
  const beta = parseVector(velocity);
  if (beta && Math.hypot(...beta) < 1) return { kind: 'coast', beta, lasts: Number(lasts) };
  const [, way = '', acceleration] = TRIP.exec(text) ?? [];
  const by = parseVector(way);
  return by && Number(acceleration) > 0 ? { kind: 'trip', by, acceleration: Number(acceleration) } : undefined;
}

function parseVector(text: string): Vec3 | undefined {
  const [x, y, z, more] = text.split(',').map((part) => (part.trim() === '' ? Number.NaN : Number(part)));
  const vector = [x, y, z].every((part) => part !== undefined && Number.isFinite(part));
  return vector && more === undefined ? [x!, y!, z!] : undefined;
}
