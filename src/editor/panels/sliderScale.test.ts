import fc from 'fast-check';
import { expect, it } from 'vitest';
import { nodeLibrary } from '../../nodes/library.ts';
import { sliderPosition, sliderStep, sliderValue } from './sliderScale.ts';

const numbers = Object.values(nodeLibrary).flatMap((type) =>
  Object.entries(type.params).flatMap(([name, spec]) => (spec.kind === 'number' ? [{ name, spec }] : [])),
);

it.each(numbers)('$name: its slider reaches both ends, is increasing, and invertible', ({ spec }) => {
  expect(sliderValue(spec, 0)).toBeCloseTo(spec.min, 6);
  expect(sliderValue(spec, 1) / spec.max).toBeCloseTo(1, 6);
  const position = fc.double({ min: 0, max: 1, noNaN: true });
  fc.assert(
    fc.property(position, position, (a, b) => {
      if (a < b) expect(sliderValue(spec, a)).toBeLessThanOrEqual(sliderValue(spec, b));
      const value = sliderValue(spec, a);
      expect(sliderValue(spec, sliderPosition(spec, value))).toBeCloseTo(value, 6);
    }),
  );
});

it.each(numbers)('$name: each arrow key changes its value', ({ spec }) => {
  const step = sliderStep(spec);
  fc.assert(
    fc.property(fc.double({ min: 0, max: 1, noNaN: true }), fc.constantFrom(-1, 1), (from, side) => {
      const value = sliderValue(spec, from);
      // Positions are whole steps, as Mantine's are.
      const next = Math.round(sliderPosition(spec, value) / step + side) * step;
      if (next < 0 || next > 1) return;
      expect(Math.sign(sliderValue(spec, next) - value)).toBe(side);
    }),
  );
});
