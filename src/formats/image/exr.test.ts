import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromHalf, toHalf } from '../../math/half.ts';
import { InputError } from '../../scene/types.ts';
import { type ExrChannel, type ExrImage, writeExr } from './exr.ts';
import { readExr } from './readExr.ts';

const { fround } = Math;

/** Every channel type, a dotted name, more than one block, a last block that is not full, text in the header. */
function sample(width = 7, height = 37): ExrImage {
  const make = (name: string, type: ExrChannel['type'], f: (x: number, y: number) => number): ExrChannel => {
    const data = type === 'uint' ? new Uint32Array(width * height) : new Float32Array(width * height);
    for (let i = 0; i < data.length; i++) data[i] = f(i % width, Math.floor(i / width));
    return { name, type, data };
  };
  const channels = [
    make('position.x', 'float', (x, y) => x + 1000 * y + 0.1),
    make('R', 'half', (x, y) => x - y / 4),
    make('object', 'uint', (x, y) => (y === 0 ? 4294967295 : x)),
    make('a.very.long.channel.name.that.is.longer.than.31', 'float', () => Number.NEGATIVE_INFINITY),
  ];
  return { width, height, channels, attributes: { objects: '["/World/方块"]', comment: '' } };
}

describe('EXR', () => {
  it('round-trips every value, name and text', () => {
    const image = sample();
    const read = readExr(writeExr(image), 'a.exr');
    expect([read.width, read.height]).toEqual([image.width, image.height]);
    expect(read.attributes).toEqual(image.attributes);
    const names = read.channels.map((c) => c.name);
    expect(names).toEqual(image.channels.map((c) => c.name).sort());
    for (const channel of image.channels) expect(read.channels.find((c) => c.name === channel.name)).toEqual(channel);
  });

  it('round-trips any bits, also incompressible ones', () => {
    const size = fc.integer({ min: 1, max: 40 });
    const property = fc.property(size, size, fc.infiniteStream(fc.float()), (width, height, values) => {
      const data = Float32Array.from({ length: width * height }, () => values.next().value);
      const image = { width, height, channels: [{ name: 'Z', type: 'float' as const, data }] };
      expect(readExr(writeExr(image), 'a.exr').channels[0].data).toEqual(data);
    });
    fc.assert(property, { numRuns: 30 });
  });

  it('rejects invalid pictures', () => {
    const data = new Float32Array(4);
    const channel = { name: 'R', type: 'float' as const, data };
    expect(() => writeExr({ width: 3, height: 2, channels: [channel] })).toThrow('4 values for 3 × 2');
    expect(() => writeExr({ width: 0, height: 2, channels: [] })).toThrow('0 × 2');
    expect(() => writeExr({ width: 2, height: 2, channels: [channel, channel] })).toThrow(
      'two EXR channels are named R',
    );
  });

  it('reads or rejects with an InputError any truncated or changed file', () => {
    const bytes = writeExr(sample());
    const attempt = (broken: Uint8Array): unknown => {
      try {
        readExr(broken, 'b.exr');
        return undefined;
      } catch (error) {
        return error;
      }
    };
    for (let n = 0; n < bytes.length; n++) expect(attempt(bytes.subarray(0, n))).toBeInstanceOf(InputError);
    for (let i = 0; i < bytes.length; i++) {
      const error = attempt(bytes.with(i, bytes[i] ^ (1 << (i % 8))));
      if (error !== undefined) expect(error).toBeInstanceOf(InputError);
    }
  });

  it('reads a picture of the reference implementation (testdata/make_exr.py)', () => {
    const bytes = readFileSync(new URL('./testdata/openexr-zip.exr', import.meta.url));
    const { width, height, channels, attributes } = readExr(bytes, 'openexr-zip.exr');
    expect([width, height, attributes?.objects]).toEqual([5, 20, '["/World/Cube"]']);
    const formulas: Record<string, (x: number, y: number) => number> = {
      R: (x, y) => x - y / 4,
      object: (x, y) => (x * y * 200_000_000) % 2 ** 32,
      'position.x': (x, y) => fround(x + 1000 * y + 0.1),
    };
    expect(channels.map((c) => [c.name, c.type])).toEqual([
      ['R', 'half'],
      ['object', 'uint'],
      ['position.x', 'float'],
    ]);
    for (const { name, data } of channels) {
      expect([...data]).toEqual(Array.from(data, (_, i) => formulas[name](i % width, Math.floor(i / width))));
    }
  });

  it('reports unsupported features', () => {
    const bytes = writeExr(sample());
    expect(() => readExr(bytes.with(5, 2), 'a.exr')).toThrow(/a\.exr: tiled EXR is not read; save it as/);
    expect(() => readExr(new TextEncoder().encode('hello, world'), 'a.exr')).toThrow('not an OpenEXR picture');
  });
});

describe('half', () => {
  it('represents every half exactly', () => {
    for (let bits = 0; bits < 65536; bits++) {
      const value = fromHalf(bits);
      if (Number.isNaN(value)) expect(fromHalf(toHalf(value))).toBeNaN();
      else if (toHalf(value) !== bits) expect([bits, toHalf(value)]).toEqual([bits, bits]);
    }
  });

  it('rounds to the nearest half, ties to even', () => {
    const property = fc.property(fc.float({ min: fround(-65504), max: fround(65504), noNaN: true }), (value) => {
      const error = Math.abs(fromHalf(toHalf(value)) - value);
      const step = 2 ** Math.max(-24, Math.floor(Math.log2(Math.abs(value) || 1e-9)) - 10);
      expect(error).toBeLessThanOrEqual(step / 2);
    });
    fc.assert(property);
    expect(fromHalf(toHalf(1 + 1 / 2048))).toBe(1);
    expect(fromHalf(toHalf(1 + 3 / 2048))).toBe(1 + 1 / 512);
    expect(fromHalf(toHalf(65520))).toBe(Number.POSITIVE_INFINITY);
    expect(fromHalf(toHalf(65519))).toBe(65504);
    expect(fromHalf(toHalf(2 ** -25))).toBe(0);
    expect(fromHalf(toHalf(1.5 * 2 ** -24))).toBe(2 ** -23);
  });
});
