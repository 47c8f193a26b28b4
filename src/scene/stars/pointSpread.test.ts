import { expect, test } from 'vitest';
import { pointSpread, spreadRadius } from './pointSpread.ts';

test('a star’s light is conserved, wherever in a pixel it is', () => {
  for (const [x, y] of [
    [0, 0],
    [0.5, 0.5],
    [0.3, 0.1],
  ]) {
    let sum = 0;
    for (let i = -400; i <= 400; i++) for (let j = -400; j <= 400; j++) sum += pointSpread(Math.hypot(i - x, j - y));
    expect(Math.abs(sum - 1)).toBeLessThan(0.004);
  }
});

test('beyond its radius it is below the resolution of 8 bits, except for very bright stars', () => {
  for (const radiance of [0.01, 1, 30]) {
    const r = spreadRadius(radiance);
    expect(radiance * pointSpread(r)).toBeLessThan(1 / (255 * 12.92));
    expect(r).toBeLessThan(48);
  }
  expect(spreadRadius(1e9)).toBe(48);
});
