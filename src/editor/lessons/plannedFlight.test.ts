import { expect, it } from 'vitest';
import { flightOf } from '../../flight/flightState.ts';
import { FlightPlayback } from '../../flight/recording/playback.ts';
import { parseFlightPlan } from '../../lessons/flightPlan.ts';
import { IDENTITY } from '../../math/quat.ts';
import { plannedFlight } from './plannedFlight.ts';

const START = flightOf({ t: 0, position: [0, 5, 0], u: [0, 0, 0], orientation: IDENTITY, properTime: 0 });
const flown = (plan: string, c: number) => new FlightPlayback(plannedFlight(parseFlightPlan(plan)!, START, c));

it('coasts out and back: γ times as long for the world as for itself', () => {
  const flight = flown('coast 0.6, 0, 0 for 8; coast -0.6, 0, 0 for 8', 10);
  expect(flight.duration).toBe(16);
  const turn = flight.stateAt(8);
  expect(turn.t.value).toBeCloseTo(10, 12);
  expect(turn.position[0].value).toBeCloseTo(60, 12);
  // At the turn it flies back already.
  expect(turn.velocity.direction[0]).toBe(-1);
  const back = flight.stateAt(16);
  expect(back.t.value).toBeCloseTo(20, 12);
  expect(back.position.map(({ value }) => value)).toEqual([0, 5, 0]);
  expect(back.properTime.value).toBe(16);
});

it('a trip ends at rest at its place, after (2c/a) arcosh(1 + ad/2c²)', () => {
  const flight = flown('trip -90, 0, 0 at 5', 16);
  expect(flight.duration).toBeCloseTo((32 / 5) * Math.acosh(1 + (5 * 90) / 512), 12);
  const { position, velocity } = flight.stateAt(flight.duration);
  expect(position[0].value).toBeCloseTo(-90, 10);
  expect(velocity.rapidity).toBe(0);
});
