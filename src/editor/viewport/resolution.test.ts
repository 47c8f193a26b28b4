import { expect, it } from 'vitest';
import { Resolution } from './resolution.ts';

/** Frames of one length while the picture changes, then a rest. */
function run(resolution: Resolution, from: number, frames: number, interval: number): number {
  let now = from;
  for (let i = 0; i < frames; i++) {
    now += interval;
    resolution.note(true, now, interval);
  }
  return now;
}

it('is full while frames are quick', () => {
  const resolution = new Resolution();
  run(resolution, 0, 100, 16);
  expect(resolution.scale).toBe(1);
  expect(resolution.fine).toBe(true);
});

it('goes down step by step while frames are slow, is full at rest, and remembers', () => {
  const resolution = new Resolution();
  let now = run(resolution, 0, 30, 200);
  expect(resolution.scale).toBe(0.5);
  expect(resolution.fine).toBe(false);
  resolution.note(false, now + 100, 100);
  expect(resolution.scale).toBe(0.5);
  now += 300;
  resolution.note(false, now, 16);
  expect(resolution.scale).toBe(1);
  expect([resolution.resting, resolution.fine]).toEqual([true, true]);
  run(resolution, now, 1, 16);
  expect(resolution.scale).toBe(0.5);
  expect(resolution.resting).toBe(false);
});

it('comes back where there is room, and settles between', () => {
  const resolution = new Resolution();
  const now = run(resolution, 0, 30, 200);
  run(resolution, now, 40, 16);
  expect(resolution.scale).toBe(1);
  const steady = new Resolution();
  run(steady, 0, 8, 100);
  const level = steady.scale;
  run(steady, 800, 100, 40);
  expect(steady.scale).toBe(level);
});
