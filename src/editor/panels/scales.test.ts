import fc from 'fast-check';
import { expect, it } from 'vitest';
import { nodeLibrary } from '../../nodes/library.ts';
import { positionOf, valueAt } from './scales.ts';

const numbers = Object.values(nodeLibrary).flatMap((type) =>
  Object.entries(type.params).flatMap(([name, spec]) => (spec.kind === 'number' ? [{ name, spec }] : [])),
);

it.each(numbers)('$name: its slider reaches both ends, rises, and comes back', ({ spec }) => {
  expect(valueAt(spec, 0)).toBeCloseTo(spec.min, 6);
  expect(valueAt(spec, 1) / spec.max).toBeCloseTo(1, 6);
  const position = fc.double({ min: 0, max: 1, noNaN: true });
  fc.assert(
    fc.property(position, position, (a, b) => {
      if (a < b) expect(valueAt(spec, a)).toBeLessThanOrEqual(valueAt(spec, b));
      const value = valueAt(spec, a);
      expect(valueAt(spec, positionOf(spec, value))).toBeCloseTo(value, 6);
    }),
  );
});
