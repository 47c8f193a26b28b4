import type { Quat } from '../math/quat.ts';
import { addScaled, length, type Vec3 } from '../math/vec3.ts';
import type { FlightControls, FlightRules } from './controls.ts';
import { askedSpeed, pushDirection } from './modes/velocity.ts';
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
  controls: Pick<FlightControls, 'thrust' | 'turn' | 'fullSpeed'>,
  dt: number,
  rules: Pick<FlightRules, 'c' | 'maxSpeed' | 'up'>,
): HeldCamera {
  const { turn, thrust } = controls;
  const turned = length(turn) > 0 ? turnLevel(orientation, turn, rules.up) : orientation;
  const way = rules.c * askedSpeed(controls, rules) * dt;
  return { vantage: addScaled(vantage, pushDirection(turned, thrust, rules.up), way), orientation: turned };
}
