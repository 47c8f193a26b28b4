import { expect, test } from 'vitest';
import { assertPictureSize } from './maxSize.ts';

test('a picture larger than the graphics device can draw is rejected, whichever side is too long', () => {
  expect(() => assertPictureSize({ width: 8192, height: 8192 }, 8192)).not.toThrow();
  expect(() => assertPictureSize({ width: 8193, height: 9 }, 8192)).toThrow(
    /^8193 × 9 pixels .* up to 8192 along each side/,
  );
  expect(() => assertPictureSize({ width: 9, height: 8193 }, 8192)).toThrow(/^9 × 8193 pixels/);
});
