import { expect, test } from 'vitest';
import { aovDifference, channelErrors } from './aovDifference.ts';
import type { ChannelPicture } from './channels.ts';

const of = (channels: Record<string, number[]>): ChannelPicture => ({
  width: 4,
  height: 1,
  channels: new Map(Object.entries(channels)),
});

// Background, two pixels of one object, one of another in A only.
const a = of({
  R: [1, 1, 1, 1],
  depth: [0, 10, 20, 5],
  object: [0, 1, 1, 2],
  'position.x': [0, 3, 0, 9],
  'position.y': [0, 4, 5, 9],
  doppler: [0, 1, 1, 1],
});
const b = of({
  R: [1, 1, 1, 0.5],
  depth: [0, 10, 22, 50],
  object: [0, 1, 1, 1],
  'position.x': [0, 3.5, 0, 0],
  'position.y': [0, 4, 5, 0],
  velocity: [0, 0, 0, 0],
});
const channel = (name: string, found = aovDifference(a, b)) => found.channels.find((c) => c.name === name);

test('data are compared where both show the same object, light everywhere', () => {
  expect(channel('depth')).toMatchObject({ pixels: 2, notFinite: 0, absolute: { max: 2, mean: 1 } });
  expect(channel('R')).toMatchObject({ pixels: 4, absolute: { max: 0.5, mean: 0.125 } });
  expect(aovDifference(a, b).otherObject).toBe(1);
});

test('relative errors are relative to the length of the vector', () => {
  expect(channel('depth')?.relative?.max).toBeCloseTo(2 / 22, 12);
  expect(channel('position.x')?.relative?.max).toBeCloseTo(0.5 / Math.hypot(3.5, 4), 12);
  expect(channel('position.y')?.relative?.max).toBe(0);
});

test('channels missing in one picture are listed', () => {
  expect(aovDifference(a, b)).toMatchObject({ onlyA: ['doppler'], onlyB: ['velocity'] });
  expect(channel('doppler')).toBeUndefined();
});

test('without object channels every pixel is compared, and `otherObject` is undefined', () => {
  const found = aovDifference(of({ depth: [0, 1, 2, 3] }), of({ depth: [0, 1, 2, 4] }));
  expect(found.otherObject).toBeUndefined();
  expect(found.channels[0]).toMatchObject({ pixels: 4, absolute: { max: 1 } });
});

test('equal non-finite values do not differ; one alone is excluded and counted in `notFinite`', () => {
  const [p, q] = [of({ depth: [Infinity, NaN, 1, 2] }), of({ depth: [Infinity, NaN, NaN, 2.5] })];
  expect([...channelErrors(p, q, 'depth')]).toEqual([0, 0, Infinity, 0.5]);
  expect(aovDifference(p, q).channels[0]).toMatchObject({ notFinite: 1, absolute: { max: 0.5 } });
});

test('a picture does not differ from itself', () => {
  const same = aovDifference(a, a);
  expect(same.otherObject).toBe(0);
  for (const { absolute, relative } of same.channels) expect([absolute?.max, relative?.max]).toEqual([0, 0]);
});
