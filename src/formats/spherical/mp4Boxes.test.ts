import fc from 'fast-check';
import { expect, it } from 'vitest';
import { box, concat, u32, wideBox } from '../../../tests/support/mp4Kit.ts';
import { changedAt, contentsAt, readMp4Boxes, writeMp4Boxes } from './mp4Boxes.ts';

const type = fc
  .string({ minLength: 4, maxLength: 4, unit: fc.constantFrom(...'abcdefgh ©') })
  .filter((s) => !s.includes('©'));
const content = fc.uint8Array({ maxLength: 40 });
const boxes = fc
  .array(fc.record({ type, content, isWide: fc.boolean() }), { maxLength: 8 })
  .map((list) => concat(...list.map((each) => (each.isWide ? wideBox : box)(each.type, each.content))));

it('any sequence of boxes comes back, with what follows', () => {
  fc.assert(
    fc.property(boxes, fc.uint8Array({ maxLength: 7 }), (list, rest) => {
      const bytes = concat(list, rest);
      expect(writeMp4Boxes(readMp4Boxes(bytes, 'moov'))).toEqual(bytes);
    }),
  );
});

it('a change inside reaches the sizes of all boxes around it, and nothing else', () => {
  const film = (inner: Uint8Array) =>
    concat(
      box('free', u32(7)),
      wideBox('moov', box('trak', box('tkhd', inner), box('mdia')), box('trak', box('tkhd', inner))),
    );
  fc.assert(
    fc.property(content, content, (before, after) => {
      expect(changedAt(film(before), ['moov', 'trak', 'tkhd'], 'film', () => after)).toEqual(film(after));
      expect(contentsAt(film(before), ['moov', 'trak', 'tkhd'], 'film')).toEqual([before, before]);
    }),
  );
});

it.each([
  [
    'longer than what holds it',
    u32(100, 0x74726b20, 0),
    'moov/trk  at byte 0 claims 100 bytes of the 12 that are left',
  ],
  ['shorter than its header', concat(box('free'), u32(7, 0x7472616b)), 'moov/trak at byte 8 claims 7 bytes'],
  ['without a size', u32(0, 0x7472616b, 0), 'moov/trak at byte 0 claims 0 bytes'],
  ['of 64 bits, cut off', u32(1, 0x7472616b, 0), 'the header of moov/trak at byte 0 is cut off'],
])('a box %s is refused, with its place', (_, bytes, words) => {
  expect(() => readMp4Boxes(bytes, 'moov')).toThrow(words);
});

it('a hundred thousand boxes are read, and no more', () => {
  const many = new Uint8Array(8 * 100_001);
  for (let at = 3; at < many.length; at += 8) many[at] = 8;
  expect(readMp4Boxes(many.subarray(8), 'moov').boxes).toHaveLength(100_000);
  expect(() => readMp4Boxes(many, 'moov')).toThrow('moov has more than 100000 boxes');
});
