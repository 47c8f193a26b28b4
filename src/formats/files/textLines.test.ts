import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { textLines } from './textLines.ts';

const encode = (value: string): Uint8Array => new TextEncoder().encode(value);
const lines = (bytes: Uint8Array): string[] => [...textLines(bytes, 'a.txt')].map(({ text }) => text);

describe('lines of a text', () => {
  it('are separated by line ends of any kind', () => {
    expect(lines(encode('a\nb\r\nc\rd'))).toEqual(['a', 'b', 'c', 'd']);
    expect(lines(encode('a\n\n'))).toEqual(['a', '']);
    expect(lines(new Uint8Array(0))).toEqual([]);
    const words = fc.array(fc.string({ unit: fc.constantFrom('x', 'ü', '€', ' ') }));
    fc.assert(
      fc.property(words, fc.constantFrom('\n', '\r\n', '\r'), (given, end) => {
        expect(lines(encode(given.map((word) => word + end).join('')))).toEqual(given);
      }),
    );
  });

  it('are complete and numbered when a file is read in blocks', () => {
    const given = Array.from({ length: 400_000 }, (_, i) => `line ${i} of €`);
    for (const end of ['\n', '\r\n', '\r']) {
      const read = [...textLines(encode(given.join(end)), 'a.txt')];
      expect(read.length).toBe(given.length);
      expect(read.every(({ number, text }, i) => number === i + 1 && text === given[i])).toBe(true);
    }
  });

  it('of 16 MiB are rejected', () => {
    const bytes = new Uint8Array(2 ** 25).fill(120);
    bytes[0] = 10;
    expect(() => lines(bytes)).toThrow('a.txt: after line 0: a line has more than 16777216 bytes; the file is damaged');
  });
});
