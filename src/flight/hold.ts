import { type Quat, rotate } from '../math/quat.ts';
import { add, addScaled, length, scale, type Vec3 } from '../math/vec3.ts';
import type { FlightControls, FlightRules } from './controls.ts';
import { walkingSpeed } from './modes/velocity.ts';
import { turnLevel } from './turning.ts';

/** The camera of one who walks about in what an observer sees at one event, which is held still: his past light cone as a thing in space. */
export interface HeldCamera {
  /** From the observer's eye, in his space: the world's axes carried by his boost [m]. */
  readonly vantage: Vec3;
  /** Camera axes (−Z forward, +Y up) against the same axes. */
  readonly orientation: Quat;
}

/**
 * The camera after dt [s]. It goes with the speeds that flying asks for, walking or the greatest, but at once: where nothing happens there is no inertia.
 * Nose and sides give its directions, and `up` rises, as in flight.
 */
export function walkAbout(
  { vantage, orientation }: HeldCamera,
  { thrust, turn, fullSpeed }: Pick<FlightControls, 'thrust' | 'turn' | 'fullSpeed'>,
  dt: number,
  rules: Pick<FlightRules, 'c' | 'maxSpeed' | 'up'>,
): HeldCamera {
  const turned = length(turn) > 0 ? turnLevel(orientation, turn, rules.up) : orientation;
  const [right, up, back] = thrust;
  const direction = addScaled(rotate(turned, [right, 0, back]), rules.up, up);
  const speed = rules.c * (fullSpeed ? rules.maxSpeed : walkingSpeed(rules));
  return { vantage: add(vantage, scale(direction, speed * dt)), orientation: turned };
}
