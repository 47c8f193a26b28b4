import { expect, it } from 'vitest';
import { luminanceHistogram, STOP_RANGE } from './luminanceHistogram.ts';

it('one stop of exposure shifts the histogram by one stop, and values above white are counted', () => {
  const light = [2 ** -3.5, 2 ** -3.5, 2 ** -0.5, 0];
  const binOf = (stop: number, bins: readonly number[]) =>
    Math.floor((bins.length * (stop - STOP_RANGE[0])) / (STOP_RANGE[1] - STOP_RANGE[0]));
  const { bins, middle, over } = luminanceHistogram(light, 0);
  expect(bins[binOf(-3.5, bins)]).toBe(1);
  expect(bins[binOf(-0.5, bins)]).toBe(0.5);
  expect(bins.reduce((sum, bin) => sum + bin, 0)).toBe(1.5);
  expect([middle, over]).toEqual([-3.5, 0]);
  const brighter = luminanceHistogram(light, 1);
  expect(brighter.bins[binOf(-2.5, bins)]).toBe(1);
  expect([brighter.middle, brighter.over]).toEqual([-2.5, 0.25]);
});

it('without light there is no histogram, and values out of range are in the end bins', () => {
  expect(luminanceHistogram([0, 0], 0)).toMatchObject({ middle: 0, over: 0 });
  const { bins } = luminanceHistogram([2 ** -40, 2 ** 40], 0);
  expect([bins.at(0), bins.at(-1)]).toEqual([1, 1]);
});
