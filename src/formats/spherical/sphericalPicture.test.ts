import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { cropOfArea, croppedArea, eyeSize } from './sphericalPicture.ts';

describe('a crop', () => {
  it('of the upper half, the middle third of its width', () => {
    const crop = { left: 1 / 3, right: 1 / 3, top: 0, bottom: 0.5 };
    expect(croppedArea(crop, { width: 100, height: 50 })).toEqual({
      full: { width: 300, height: 100 },
      area: { width: 100, height: 50 },
      left: 100,
      top: 0,
    });
  });

  it('absent is the full sphere, and the full sphere has none', () => {
    const area = { width: 64, height: 32 };
    expect(croppedArea(undefined, area)).toEqual({ full: area, area, left: 0, top: 0 });
    expect(cropOfArea({ full: area, area, left: 0, top: 0 })).toBeUndefined();
  });

  const length = fc.integer({ min: 1, max: 20_000 });
  const margin = fc.integer({ min: 0, max: 20_000 });
  it('in pixels comes back from its parts to the pixel, whatever it is', () => {
    fc.assert(
      fc.property(length, length, margin, margin, margin, margin, (width, height, left, right, top, bottom) => {
        const full = { width: left + width + right, height: top + height + bottom };
        const told = { full, area: { width, height }, left, top };
        expect(croppedArea(cropOfArea(told), told.area)).toEqual(told);
      }),
    );
  });

  it('stays inside the sphere when it is rounded to pixels', () => {
    const part = fc.double({ min: 0, max: 0.49, noNaN: true });
    fc.assert(
      fc.property(length, length, part, part, part, part, (width, height, left, right, top, bottom) => {
        const found = croppedArea({ left, right, top, bottom }, { width, height });
        const crop = cropOfArea(found) ?? { left: 0, right: 0, top: 0, bottom: 0 };
        for (const side of ['left', 'right'] as const)
          expect(Math.abs(crop[side] - { left, right }[side]) * found.full.width).toBeLessThan(1.01);
        for (const side of ['top', 'bottom'] as const)
          expect(Math.abs(crop[side] - { top, bottom }[side]) * found.full.height).toBeLessThan(1.01);
      }),
    );
  });

  it('that leaves nothing, or leaves the sphere, is refused with its numbers', () => {
    const size = { width: 4, height: 2 };
    expect(() => croppedArea({ left: 0.5, right: 0.5, top: 0, bottom: 0 }, size)).toThrow('0.5 left, 0.5 right');
    expect(() => croppedArea({ left: 0, right: 0, top: -0.1, bottom: 0 }, size)).toThrow('-0.1 top');
    expect(() => croppedArea({ left: Number.NaN, right: 0, top: 0, bottom: 0 }, size)).toThrow('NaN left');
    expect(() => cropOfArea({ full: { width: 5, height: 2 }, area: size, left: 2, top: 0 })).toThrow(
      '4 × 2 pixels at (2, 0) is not in a sphere of 5 × 2',
    );
  });
});

it('a stereo picture is divided into equal halves', () => {
  const size = { width: 64, height: 30 };
  expect(eyeSize(size, 'none')).toEqual(size);
  expect(eyeSize(size, 'top-bottom')).toEqual({ width: 64, height: 15 });
  expect(eyeSize(size, 'left-right')).toEqual({ width: 32, height: 30 });
  expect(() => eyeSize({ width: 64, height: 31 }, 'top-bottom')).toThrow('64 × 31 pixels has no two equal halves');
});
