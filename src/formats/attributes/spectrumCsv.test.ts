import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { inEnglish } from '../../messages/message.ts';
import { InputError } from '../../scene/types.ts';
import { colorOfSpectrum } from '../../spectrum/color/observerColor.ts';
import { LIGHT_PRESETS } from '../../spectrum/sources/lightPresets.ts';
import type { SampledSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import { readSpectrumCsv, writeSpectrumCsv } from './spectrumCsv.ts';

const read = (text: string): SampledSpectrum => readSpectrumCsv(new TextEncoder().encode(text), 'lamp.csv');
const close = (values: readonly number[]) => values.map((value) => expect.closeTo(value, 9));

describe('a spectrum from CSV', () => {
  test.each([
    ['commas', 'wavelength,value\n400,1\n410,2.5\n420,0\n'],
    ['blanks and comments', '# a lamp\r\n\r\n400  1\r\n410 2.5\r\n420 0'],
    ['tabs', '400\t1\n410\t2.5\n420\t0'],
    ['semicolons and decimal commas', '\uFEFFnm;W\n400,0;1,0\n410,0;2,5\n420,0;-0,01'],
    ['more columns', '400, 1, 7\n410, 2.5, 7\n420, 0, 7'],
  ])('with %s', (_, text) => {
    const { kind, first, step, values } = read(text);
    expect({ kind, first, step, values }).toEqual({
      kind: 'sampled',
      first: expect.closeTo(400e-9, 15),
      step: expect.closeTo(10e-9, 15),
      values: close([1, 2.5, 0]),
    });
  });

  test('round-trips', () => {
    const led = LIGHT_PRESETS.get('led')!.spectrum as SampledSpectrum;
    const { first, step, values } = readSpectrumCsv(writeSpectrumCsv(led), 'led.csv');
    expect([first, step]).toEqual([expect.closeTo(led.first, 15), expect.closeTo(led.step, 15)]);
    expect(values).toEqual(led.values);
  });

  test('of a light preset is that preset', () => {
    const { first, step, values } = LIGHT_PRESETS.get('led')!.spectrum as SampledSpectrum;
    const text = values.map((value, i) => `${(first + i * step) * 1e9},${value}`).join('\n');
    colorOfSpectrum(read(text)).forEach((value, k) => {
      expect(value).toBeCloseTo(colorOfSpectrum(LIGHT_PRESETS.get('led')!.spectrum)[k], 9);
    });
  });

  test('with uneven steps conserves its light, with a limited number of samples', () => {
    const gap = fc.double({ min: 0.01, max: 300, noNaN: true });
    const value = fc.double({ min: 0, max: 1e3, noNaN: true });
    fc.assert(
      fc.property(fc.array(fc.tuple(gap, value), { minLength: 3, maxLength: 60 }), (gaps) => {
        const at = (i: number) => gaps.slice(0, i + 1).reduce((sum, [width]) => sum + width, 300);
        const rows = gaps.map(([, height], i) => [at(i), height] as const);
        fc.pre(rows.some(([, height]) => height > 1e-3));
        const { first, step, values } = read(rows.map((row) => row.join(',')).join('\n'));
        expect(values.length).toBeLessThanOrEqual(4096);
        expect(first * 1e9).toBeCloseTo(rows[0][0], 6);
        expect((first + step * (values.length - 1)) * 1e9).toBeCloseTo(rows[rows.length - 1][0], 6);
        const area = rows.slice(1).reduce((sum, [x, y], i) => sum + ((x - rows[i][0]) * (y + rows[i][1])) / 2, 0);
        // The first and last samples have half a step's weight.
        const ours =
          values.reduce((sum, y, i) => sum + (i === 0 || i === values.length - 1 ? y / 2 : y), 0) * step * 1e9;
        expect(ours / area).toBeCloseTo(1, 6);
      }),
    );
  });

  test.each([
    ['', 'lamp.csv', 'fewer than two'],
    ['400,1', 'lamp.csv', 'fewer than two'],
    ['a,b\nc,d', 'lamp.csv', 'fewer than two'],
    ['400,0\n500,0', 'lamp.csv', 'all of its values are 0'],
    ['400,1\n390,1', 'lamp.csv: line 2', '390 nm comes after 400 nm'],
    ['400,1\n400,1', 'lamp.csv: line 2', 'comes after'],
    ['0.4,1\n0.5,1', 'lamp.csv: line 1', 'is not between'],
    ['400,1\n500,NaN', 'lamp.csv: line 2', 'is not two numbers'],
    ['400,1\n500,1e99', 'lamp.csv: line 2', 'is not two numbers'],
    ['400,1\n500', 'lamp.csv: line 2', 'is not two numbers'],
    [Array.from({ length: 100_002 }, (_, i) => `${i + 1},1`).join('\n'), 'lamp.csv: line 100001', 'more than'],
  ])('is rejected with its line: %#', (text, place, message) => {
    const error = (() => {
      try {
        return read(text);
      } catch (thrown) {
        return thrown;
      }
    })();
    expect(error).toBeInstanceOf(InputError);
    const { diagnostic } = error as InputError;
    expect([diagnostic.code, inEnglish(diagnostic.place)]).toEqual(['spectrum.csv', place]);
    expect(inEnglish(diagnostic.message)).toContain(message);
  });

  test('of any bytes is read or rejected', () => {
    fc.assert(
      fc.property(
        fc.oneof(
          fc.uint8Array(),
          fc.stringMatching(/^[\d,;.\s e-]{0,40}$/).map((text) => new TextEncoder().encode(text)),
        ),
        (bytes) => {
          try {
            const { first, step, values } = readSpectrumCsv(bytes, 'x');
            expect([first, step, ...values].every(Number.isFinite)).toBe(true);
          } catch (thrown) {
            expect(thrown).toBeInstanceOf(InputError);
          }
        },
      ),
    );
  });
});
