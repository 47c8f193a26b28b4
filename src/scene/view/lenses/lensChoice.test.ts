import fc from 'fast-check';
import { expect, it } from 'vitest';
import { MessageError } from '../../../messages/messageError.ts';
import { assertLensShape, choiceOf, fittedSize, LENS_CHOICES, type LensChoice, panoramicLens } from './lensChoice.ts';
import { lensDirection } from './lenses.ts';

const names = Object.keys(LENS_CHOICES) as LensChoice[];
const choices = fc.record({
  lens: fc.constantFrom(...names.filter((name) => name !== 'perspective')),
  aperture: fc.double({ min: 1, max: 360, noNaN: true }),
  domeTilt: fc.double({ min: -90, max: 80, noNaN: true }),
  eyeSeparation: fc.double({ min: 0.001, max: 100, noNaN: true }),
});
const sizes = fc.record({ width: fc.integer({ min: 6, max: 4000 }), height: fc.integer({ min: 2, max: 4000 }) });

it('a lens is found again from what was chosen', () => {
  fc.assert(
    fc.property(choices, (choice) => {
      const lens = panoramicLens(choice)!;
      const again = panoramicLens(choiceOf(lens))!;
      expect(again.kind).toBe(lens.kind);
      for (const [key, value] of Object.entries(lens))
        if (typeof value === 'number') expect(Number(Reflect.get(again, key))).toBeCloseTo(value, 12);
        else expect(Reflect.get(again, key)).toBe(value);
    }),
  );
});

it('a fitted size lies within, has the lens’s shape, and shows a direction at all corners but those of a circle', () => {
  fc.assert(
    fc.property(choices, sizes, (choice, size) => {
      const lens = panoramicLens(choice)!;
      const fitted = fittedSize(lens, size);
      expect(fitted.width).toBeLessThanOrEqual(size.width);
      expect(fitted.height).toBeLessThanOrEqual(size.height);
      expect(() => assertLensShape(lens, fitted)).not.toThrow();
      if (lens.kind !== 'fisheye')
        for (const [x, y] of [
          [0.5, 0.5],
          [fitted.width - 0.5, fitted.height - 0.5],
        ] as const)
          expect(lensDirection(lens, x, y, fitted)).toBeDefined();
    }),
  );
});

it('another shape is refused for a file, and leaves bars elsewhere', () => {
  const lens = { kind: 'equirectangular' } as const;
  const size = { width: 300, height: 200 };
  expect(() => assertLensShape(lens, size)).toThrow(MessageError);
  expect(lensDirection(lens, 150, 20, size)).toBeUndefined();
  expect(lensDirection(lens, 150, 100, size)).toEqual([0, 0, -1].map((value) => expect.closeTo(value, 12)));
});
