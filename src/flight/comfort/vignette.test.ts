import fc from 'fast-check';
import { expect, it } from 'vitest';
import { closingFor, nextClosing } from './vignette.ts';

const flows = fc.double({ min: 0, max: 10, noNaN: true });

it('closes with the flow: not at all in calm motion, wholly in fast motion, and never less for more', () => {
  expect(closingFor(0)).toBe(0);
  expect(closingFor(0.25)).toBe(0);
  expect(closingFor(0.75)).toBeCloseTo(0.5, 12);
  expect(closingFor(100)).toBe(1);
  fc.assert(
    fc.property(flows, flows, (a, b) => {
      expect(closingFor(Math.max(a, b))).toBeGreaterThanOrEqual(closingFor(Math.min(a, b)));
    }),
  );
});

it('goes to it without passing it, at the same pace in steps of any length', () =>
  fc.assert(
    fc.property(fc.double({ min: 0, max: 1, noNaN: true }), flows, (closing, flow) => {
      const after = nextClosing(closing, flow, 0.3);
      expect(nextClosing(nextClosing(closing, flow, 0.1), flow, 0.2)).toBeCloseTo(after, 12);
      expect(Math.abs(after - closingFor(flow))).toBeLessThanOrEqual(Math.abs(closing - closingFor(flow)));
    }),
  ));

it('closes sooner than it opens', () => {
  expect(nextClosing(0, 5, 0.2)).toBeGreaterThan(1 - nextClosing(1, 0, 0.2));
});
