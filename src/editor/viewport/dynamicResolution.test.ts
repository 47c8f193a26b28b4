import { expect, it } from 'vitest';
import { DynamicResolution } from './dynamicResolution.ts';

/** Frames of equal duration while the picture changes, then a rest. */
function run(resolution: DynamicResolution, from: number, frames: number, interval: number): number {
  let now = from;
  for (let i = 0; i < frames; i++) {
    now += interval;
    resolution.recordFrame(true, now, interval);
  }
  return now;
}

it('has full resolution while frames are fast', () => {
  const resolution = new DynamicResolution();
  run(resolution, 0, 100, 16);
  expect(resolution.scale).toBe(1);
  expect(resolution.fullQuality).toBe(true);
});

it('decreases stepwise while frames are slow, is full at rest, and is remembered', () => {
  const resolution = new DynamicResolution();
  let now = run(resolution, 0, 30, 200);
  expect(resolution.scale).toBe(0.5);
  expect(resolution.fullQuality).toBe(false);
  resolution.recordFrame(false, now + 100, 100);
  expect(resolution.scale).toBe(0.5);
  now += 300;
  resolution.recordFrame(false, now, 16);
  expect(resolution.scale).toBe(1);
  expect([resolution.isStill, resolution.fullQuality]).toEqual([true, true]);
  run(resolution, now, 1, 16);
  expect(resolution.scale).toBe(0.5);
  expect(resolution.isStill).toBe(false);
});

it('increases again if there is time, and settles in between', () => {
  const resolution = new DynamicResolution();
  const now = run(resolution, 0, 30, 200);
  run(resolution, now, 40, 16);
  expect(resolution.scale).toBe(1);
  const steady = new DynamicResolution();
  run(steady, 0, 8, 100);
  const level = steady.scale;
  run(steady, 800, 100, 40);
  expect(steady.scale).toBe(level);
});
