import { decode } from 'fast-png';
import { expect, it } from 'vitest';
import { encodePng } from './encodePng.ts';
import { withPngText } from './pngText.ts';

const picture = encodePng(
  3,
  2,
  Uint8Array.from({ length: 24 }, (_, i) => 10 * i),
);

it('adds texts readable by another program, and does not change pixels', () => {
  const read = decode(withPngText(picture, { worldTime: '6.5 s', falseColors: 'doppler from 0.5 to 2' }), {
    checkCrc: true,
  });
  expect(read.text).toEqual({ worldTime: '6.5 s', falseColors: 'doppler from 0.5 to 2' });
  expect(read.data).toEqual(decode(picture).data);
});

it('rejects texts that cannot be encoded', () => {
  expect(() => withPngText(picture, { title: '光' })).toThrow('“光”');
  expect(() => withPngText(picture, { '': 'x' })).toThrow('1 … 79');
  expect(() => withPngText(picture, { ['k'.repeat(80)]: 'x' })).toThrow('1 … 79');
});
