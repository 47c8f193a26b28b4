import { readdirSync, readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { transcode } from '../../../../tests/support/basisTranscoder.ts';
import { plainKtx2, storedZstd, uastcKtx2 } from '../../../../tests/support/ktx2Kit.ts';
import { InputError } from '../../../scene/types.ts';
import type { DecodedImage } from '../decodeImage.ts';
import { decodeKtx2 } from './readKtx2.ts';

const testdata = new URL('testdata/', import.meta.url);
const names = readdirSync(testdata).filter((name) => name.endsWith('.ktx2'));
const fixture = (name: string): Uint8Array => new Uint8Array(readFileSync(new URL(name, testdata)));
const decoded = (bytes: Uint8Array): DecodedImage | undefined => {
  try {
    return decodeKtx2(bytes, 'it');
  } catch (thrown) {
    expect(thrown).toBeInstanceOf(InputError);
    return undefined;
  }
};

describe('Basis Universal', () => {
  it.each(names)('%s: the bytes that the transcoder of its authors gives', async (name) => {
    const [own, theirs] = [decodeKtx2(fixture(name), name), (await transcode(fixture(name)))!];
    // Their two channels are grey and alpha.
    if (name.startsWith('rg_'))
      for (let i = 0; i < theirs.data.length; i += 4) theirs.data.set([theirs.data[i], theirs.data[i + 3], 0, 255], i);
    expect(own).toEqual(theirs);
  });

  it('UASTC: all modes, of blocks by chance', async () => {
    const block = fc.uint8Array({ minLength: 16, maxLength: 16 });
    const seen = new Set<boolean>();
    await fc.assert(
      fc.asyncProperty(block, fc.integer({ min: 0, max: 127 }), async (bytes, prefix) => {
        // Rare modes have long prefixes.
        bytes[0] = (bytes[0] & 0x80) | prefix;
        const picture = uastcKtx2({ width: 4, height: 4, data: bytes });
        const own = decoded(picture);
        seen.add(own !== undefined);
        expect(own).toEqual(await transcode(picture));
      }),
      { numRuns: 4000 },
    );
    expect(seen).toEqual(new Set([true, false]));
  });

  it('UASTC with Zstandard is the same picture', () => {
    const bytes = fixture('luminance_alpha_reference_uastc.ktx2');
    const data = bytes.slice(-16 * 64);
    const plain = uastcKtx2({ width: 32, height: 32, data });
    const packed = uastcKtx2({ width: 32, height: 32, data: storedZstd(data), unpacked: data.length });
    expect(decodeKtx2(packed, 'it')).toEqual(decodeKtx2(plain, 'it'));
  });
});

describe('pictures of 8 bits a channel', () => {
  it.each([
    ['R8', 9, [10], [10, 10, 10, 255]],
    ['R8G8', 16, [10, 20], [10, 20, 0, 255]],
    ['R8G8B8', 23, [10, 20, 30], [10, 20, 30, 255]],
    ['B8G8R8', 30, [30, 20, 10], [10, 20, 30, 255]],
    ['R8G8B8A8_SRGB', 43, [10, 20, 30, 40], [10, 20, 30, 40]],
    ['B8G8R8A8', 44, [30, 20, 10, 40], [10, 20, 30, 40]],
  ] as const)('%s', (_, format, from, to) => {
    const data = Uint8Array.from([...from, ...from.map((x) => x + 100)]);
    const { data: out } = decodeKtx2(plainKtx2(format, { width: 2, height: 1, data }), 'it');
    expect([...out.subarray(0, 4)]).toEqual(to);
  });

  it.each([
    ['rd', [1, 2, 3, 4]],
    ['ru', [3, 4, 1, 2]],
    ['ld', [2, 1, 4, 3]],
    ['lu', [4, 3, 2, 1]],
  ])('have their first row at the top, written %s', (orientation, reds) => {
    const picture = plainKtx2(9, { width: 2, height: 2, data: Uint8Array.of(1, 2, 3, 4), orientation });
    const { data } = decodeKtx2(picture, 'it');
    expect([0, 4, 8, 12].map((i) => data[i])).toEqual(reds);
  });
});

describe('what is not read', () => {
  const data = new Uint8Array(64);
  /** With another number in its header. */
  const changed = (at: number, value: number): Uint8Array => {
    const bytes = plainKtx2(37, { width: 4, height: 4, data });
    new DataView(bytes.buffer).setUint32(at, value, true);
    return bytes;
  };
  const [FORMAT, WIDTH, LAYERS, FACES, SCHEME] = [12, 20, 32, 36, 44];
  it.each([
    ['a cube', changed(FACES, 6), /a KTX2 with several pictures/],
    ['an array', changed(LAYERS, 3), /a KTX2 with several pictures/],
    ['BC7', changed(FORMAT, 145), /a KTX2 with format 145 of Vulkan, which is not read/],
    ['zlib', changed(SCHEME, 3), /a KTX2 with supercompression 3, which is not read/],
    ['a huge one', changed(WIDTH, 60000), /it: the picture is 60000 × 4 pixels/],
    ['a short one', changed(WIDTH, 5), /it: the KTX2 is damaged or cut off/],
  ])('%s is refused with the reason', (_, picture, reason) => {
    expect(() => decodeKtx2(picture, 'it')).toThrow(reason);
  });

  it('cut off and changed files end in a picture or in an error that names them', () => {
    for (const name of names) {
      const bytes = fixture(name);
      for (let length = 0; length < bytes.length; length += 1 + (bytes.length >> 6)) decoded(bytes.slice(0, length));
      for (let at = 0; at < bytes.length; at += 1 + (bytes.length >> 8)) {
        const changed = bytes.slice();
        changed[at] ^= 0x55;
        decoded(changed);
      }
    }
  });

  it('a frame of Zstandard that grows without end is cut where the picture ends', () => {
    const blocks = 20_000;
    const bomb = new Uint8Array(6 + 4 * blocks);
    bomb.set([0x28, 0xb5, 0x2f, 0xfd, 0, 0x58]);
    // 128 KiB of one byte each.
    for (let i = 0; i < blocks; i++) bomb.set([i === blocks - 1 ? 3 : 2, 0, 16, 7], 6 + 4 * i);
    const picture = plainKtx2(9, { width: 4, height: 4, data: bomb, unpacked: 16 });
    expect([...decodeKtx2(picture, 'it').data]).toEqual(Array.from({ length: 64 }, (_, i) => (i % 4 === 3 ? 255 : 7)));
  });
});
