import { expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { makeObject, restingAt } from '../../scene/defaults.ts';
import { box } from '../../scene/mesh/primitives.ts';
import type { Motion } from '../../scene/types.ts';
import { makeBody } from '../geometry/bodies.ts';
import { type CaptureRequest, CaptureSchedule } from './captureSchedule.ts';

const bodyAt = (id: number, motion: Motion) =>
  makeBody(makeObject({ path: `/${id}`, mesh: box([2, 2, 2]), motion }), id);
const NEAR = bodyAt(1, restingAt([0, 0, -4]));
const FAR = bodyAt(2, restingAt([0, 0, -1000]));
const MOVING = bodyAt(3, {
  kind: 'uniform',
  pose: { position: [0, 0, -1000], orientation: IDENTITY },
  velocity: [1, 0, 0],
});
const asked = (t: number, position: Vec3, key = 'scene'): CaptureRequest => ({
  ...{ key, event: { t, position }, bodies: [NEAR, FAR, MOVING], maxError: 1e-3 },
});

/** What the next picture is drawn with, as the renderer does it. */
function drawn(schedule: CaptureSchedule, request: CaptureRequest): { isDue: boolean; held: readonly number[] } {
  schedule.next(request);
  const { isDue } = schedule;
  if (isDue) schedule.taken(false);
  return { isDue, held: [...schedule.bodies].map(({ id }) => id) };
}

it('captures everything at one event, once', () => {
  const schedule = new CaptureSchedule();
  expect(drawn(schedule, asked(0, [0, 0, 0]))).toEqual({ isDue: true, held: [1, 2, 3] });
  expect(drawn(schedule, asked(0, [0, 0, 0]))).toEqual({ isDue: false, held: [1, 2, 3] });
});

it('leaves what is near, or moves, to geometry while the observer moves, and renews the rest when its error grows too large', () => {
  const schedule = new CaptureSchedule();
  drawn(schedule, asked(0, [0, 0, 0]));
  // 1 cm of 1 km is 1e-5 rad, of 4 m over 1e-3.
  const pictures = Array.from({ length: 200 }, (_, n) => drawn(schedule, asked(n + 1, [0.01 * (n + 1), 0, 0])));
  expect(pictures.every(({ held }) => held.length === 1 && held[0] === 2)).toBe(true);
  // After a metre, 1e-3 rad; a little less, for its size.
  const renewed = pictures.flatMap(({ isDue }, n) => (isDue ? [n] : []));
  expect(renewed[0]).toBe(0);
  expect(renewed).toHaveLength(2);
  expect(Math.abs(renewed[1]! - 99)).toBeLessThan(3);
});

it('captures everything again when the observer stays', () => {
  const schedule = new CaptureSchedule();
  drawn(schedule, asked(0, [0, 0, 0]));
  drawn(schedule, asked(1, [1, 0, 0]));
  expect(drawn(schedule, asked(1, [1, 0, 0]))).toEqual({ isDue: true, held: [1, 2, 3] });
  expect(drawn(schedule, asked(1, [1, 0, 0])).isDue).toBe(false);
});

it('renews what was captured of something else, or not finally', () => {
  const schedule = new CaptureSchedule();
  drawn(schedule, asked(0, [0, 0, 0]));
  expect(drawn(schedule, asked(0, [0, 0, 0], 'another')).isDue).toBe(true);
  schedule.next(asked(0, [0, 0, 0], 'another'));
  expect(schedule.isDue).toBe(false);
  schedule.taken(true);
  expect(drawn(schedule, asked(0, [0, 0, 0], 'another')).isDue).toBe(true);
  expect(drawn(schedule, asked(0, [0, 0, 0], 'another')).isDue).toBe(false);
  schedule.reset();
  expect(drawn(schedule, asked(0, [0, 0, 0], 'another')).isDue).toBe(true);
});
