import { expect, it, vi } from 'vitest';
import { flightOf, observerOf } from '../../flight/flightState.ts';
import { parseFlightPlan } from '../../lessons/flightPlan.ts';
import { IDENTITY } from '../../math/quat.ts';
import type { ObserverController } from '../flight/observerController.ts';
import type { Pilot } from '../flight/pilot.ts';
import { plannedFlight } from './plannedFlight.ts';
import { replayFlight } from './replayFlight.ts';

const START = flightOf({ t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, properTime: 0 });
const FLIGHT = plannedFlight(parseFlightPlan('coast 0.6, 0, 0 for 8')!, START, 1);

function replayed(before?: Pilot) {
  const controller = { pilot: before } as ObserverController;
  const abort = new AbortController();
  const onEnd = vi.fn();
  replayFlight(FLIGHT, controller, abort.signal, onEnd);
  return { controller, abort, onEnd, fly: (dt: number, busy = false) => controller.pilot?.replayed(dt, busy) };
}

it('flies in own time to the end, and hands back', () => {
  const { controller, onEnd, fly } = replayed();
  expect(fly(3)!.state.t.value).toBeCloseTo(3.75, 12);
  expect(fly(9)!.state.t.value).toBeCloseTo(10, 12);
  expect(onEnd).not.toHaveBeenCalled();
  expect(fly(0.1)).toBeUndefined();
  const { position, properTime } = observerOf(onEnd.mock.calls[0]![0]);
  expect(position[0]).toBeCloseTo(6, 12);
  expect(properTime).toBe(8);
  expect(controller.pilot).toBeUndefined();
});

it('ends when the user flies, who is the pilot again that was it before', () => {
  const before: Pilot = { fly: ({ state }) => state, replayed: () => undefined };
  const { controller, onEnd, fly } = replayed(before);
  fly(1);
  expect(fly(0.1, true)).toBeUndefined();
  expect(onEnd.mock.calls).toEqual([[undefined]]);
  expect(controller.pilot).toBe(before);
});

it('ends with another step, without a last word', () => {
  const { controller, abort, onEnd, fly } = replayed();
  fly(1);
  abort.abort();
  expect(controller.pilot).toBeUndefined();
  expect(onEnd).not.toHaveBeenCalled();
});

it('leaves a pilot that took over in the meantime', () => {
  const { controller, abort } = replayed();
  const later: Pilot = { fly: ({ state }) => state, replayed: () => undefined };
  controller.pilot = later;
  abort.abort();
  expect(controller.pilot).toBe(later);
});
