import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  box,
  boxesIn,
  chunkStarts,
  concat,
  type FilmPart,
  filmOf,
  inside,
  moovOf,
  type TestFilm,
  type TestTrack,
  u32,
  wideBox,
} from '../../../tests/support/mp4Kit.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { memoryFile } from '../zip/zipSource.ts';
import { sphericalMp4Edit, withSphericalMp4 } from './sphericalMp4.ts';
import { sphericalOf } from './sphericalOf.ts';

const FULL: SphericalPicture = { projection: 'equirectangular', stereo: 'none' };
/** Exact in 32 bits. */
const part = fc.integer({ min: 0, max: 2 ** 31 - 2 }).map((n) => n / 2 ** 32);
const stereo = fc.constantFrom('none', 'top-bottom', 'left-right');
const picture: fc.Arbitrary<SphericalPicture> = fc.oneof(
  fc.record({ projection: fc.constant('equirectangular'), stereo }),
  fc.record({ projection: fc.constant('cubemap'), stereo }),
  fc.record({
    projection: fc.constant('equirectangular'),
    stereo,
    crop: fc.record({ left: part.map((x) => x + 2 ** -32), right: part, top: part, bottom: part }),
  }),
);

const TRACKS: readonly TestTrack[] = [
  { handler: 'soun', isWide: false },
  { handler: 'vide', isWide: false },
  { handler: 'vide', isWide: true },
];
const media = fc.record({
  media: fc.array(fc.record({ track: fc.nat(2), data: fc.uint8Array({ minLength: 1, maxLength: 9 }) }), {
    maxLength: 5,
  }),
  isWide: fc.boolean(),
});
const free = fc
  .oneof(fc.integer({ min: 8, max: 60 }), fc.integer({ min: 2000, max: 5000 }))
  .map((size) => ({ free: size }));
/** Any film of one `moov` among media and free space. */
const film = fc
  .tuple(fc.array(fc.oneof(media, free), { maxLength: 3 }), fc.array(fc.oneof(media, free), { maxLength: 3 }))
  .map(([before, after]): TestFilm => filmOf(TRACKS, [...before, 'moov', ...after] as FilmPart[]));

/** The bytes of all chunks, found by the offsets that the film tells. */
const chunksOf = (bytes: Uint8Array, { chunks }: TestFilm): Uint8Array[][] =>
  chunkStarts(bytes).map((starts, i) => starts.map((at, k) => bytes.slice(at, at + chunks[i][k].length)));

/** The bytes with all of a text replaced by another. */
const replaced = (bytes: Uint8Array, from: string, to: string): Uint8Array =>
  Uint8Array.from(new TextDecoder('latin1').decode(bytes).replaceAll(from, to), (c) => c.charCodeAt(0));

const told = (bytes: Uint8Array) => sphericalOf(memoryFile(bytes), 'film.mp4');
const CHUNK: FilmPart = { media: [{ track: 1, data: Uint8Array.of(1, 2, 3) }], isWide: false };

describe('a marked film', () => {
  it('says what it was marked with, and its chunks are those that it had', () =>
    fc.assert(
      fc.asyncProperty(film, picture, async (made, how) => {
        const marked = await withSphericalMp4(made.bytes, 'film.mp4', how);
        expect(await told(marked)).toEqual(how);
        expect(chunksOf(marked, made)).toEqual(made.chunks);
        expect(await told(made.bytes)).toBeUndefined();
      }),
      { numRuns: 300 },
    ));

  it('can be marked again, as if it had not been', () =>
    fc.assert(
      fc.asyncProperty(film, picture, picture, async (made, first, second) => {
        const twice = await withSphericalMp4(await withSphericalMp4(made.bytes, 'a', first), 'a', second);
        const once = await withSphericalMp4(made.bytes, 'a', second);
        expect(await told(twice)).toEqual(second);
        expect(chunksOf(twice, made)).toEqual(made.chunks);
        const [[a], [b]] = [twice, once].map((bytes) => inside(bytes, 'moov'));
        expect(boxesIn(a).map(({ type, content }) => [type, content.length])).toEqual(
          boxesIn(b).map(({ type, content }) => [type, content.length]),
        );
      }),
      { numRuns: 100 },
    ));

  it('has the boxes of V2 between the codec and the shape of pixels, and V1 in the video tracks only', async () => {
    const { bytes } = filmOf(TRACKS, ['moov']);
    const how: SphericalPicture = { projection: 'equirectangular', stereo: 'top-bottom' };
    const marked = await withSphericalMp4(bytes, 'film.mp4', how);
    const entries = inside(marked, 'moov', 'trak', 'mdia', 'minf', 'stbl', 'stsd').map(
      (stsd) => boxesIn(stsd.subarray(8))[0],
    );
    expect(entries.map(({ type }) => type)).toEqual(['mp4a', 'avc1', 'avc1']);
    const types = boxesIn(entries[1].content.subarray(78)).map(({ type }) => type);
    expect(types).toEqual(['avcC', 'st3d', 'sv3d', 'pasp']);
    expect(inside(marked, 'moov', 'trak').map((track) => boxesIn(track).map(({ type }) => type))).toEqual([
      ['tkhd', 'mdia'],
      ['tkhd', 'mdia', 'uuid'],
      ['tkhd', 'mdia', 'uuid'],
    ]);
  });

  it('of a cube map has no V1 box, which only tells equirectangular films', async () => {
    const { bytes } = filmOf(TRACKS, ['moov']);
    const marked = await withSphericalMp4(bytes, 'film.mp4', { projection: 'cubemap', stereo: 'none' });
    expect(inside(marked, 'moov', 'trak', 'uuid')).toEqual([]);
  });

  it('is said by V2 where both versions speak, and by V1 alone', async () => {
    const { bytes } = filmOf(TRACKS, ['moov']);
    const marked = await withSphericalMp4(bytes, 'film.mp4', { projection: 'equirectangular', stereo: 'left-right' });
    expect(await told(replaced(marked, '>left-right<', '>top-bottom<'))).toMatchObject({ stereo: 'left-right' });
    expect(await told(replaced(marked, 'sv3d', 'free'))).toEqual({
      projection: 'equirectangular',
      stereo: 'left-right',
    });
  });

  it('with a V1 box like those of early tools, without a namespace for rdf, is read', async () => {
    const xml = `<rdf:SphericalVideo xmlns:GSpherical="http://ns.google.com/videos/1.0/spherical/">
      <GSpherical:Spherical> true </GSpherical:Spherical><GSpherical:Stitched>true</GSpherical:Stitched>
      <GSpherical:ProjectionType>equirectangular</GSpherical:ProjectionType>
      <GSpherical:CroppedAreaImageWidthPixels>1000</GSpherical:CroppedAreaImageWidthPixels>
      <GSpherical:CroppedAreaImageHeightPixels>800</GSpherical:CroppedAreaImageHeightPixels>
      <GSpherical:FullPanoWidthPixels>2000</GSpherical:FullPanoWidthPixels>
      <GSpherical:FullPanoHeightPixels>1000</GSpherical:FullPanoHeightPixels>
      <GSpherical:CroppedAreaLeftPixels>500</GSpherical:CroppedAreaLeftPixels>
      <GSpherical:CroppedAreaTopPixels>200</GSpherical:CroppedAreaTopPixels></rdf:SphericalVideo>`;
    const [v1] = inside(await withSphericalMp4(filmOf(TRACKS, ['moov']).bytes, 'a', FULL), 'moov', 'trak', 'uuid');
    const uuid = box('uuid', v1.subarray(0, 16), new TextEncoder().encode(xml));
    const track = concat(inside(moovOf([TRACKS[1]], []), 'moov', 'trak')[0], uuid);
    expect(await told(box('moov', box('trak', track)))).toEqual({
      projection: 'equirectangular',
      stereo: 'none',
      crop: { left: 0.25, right: 0.25, top: 0.2, bottom: 0 },
    });
  });
});

describe('the edit of a film', () => {
  const edit = (bytes: Uint8Array) => sphericalMp4Edit(memoryFile(bytes), 'film.mp4', FULL);

  it('uses free space behind moov, so that nothing else moves', async () => {
    const { bytes } = filmOf(TRACKS, ['moov', { free: 4000 }, CHUNK]);
    const { at, removed, bytes: box } = await edit(bytes);
    expect([at, removed]).toEqual([20, box.length]);
    expect(removed).toBeLessThan(3000);
    const marked = await withSphericalMp4(bytes, 'film.mp4', FULL);
    expect(boxesIn(marked).map(({ type }) => type)).toEqual(['ftyp', 'moov', 'free', 'mdat']);
    expect(chunkStarts(marked)).toEqual(chunkStarts(bytes));
  });

  it('only lengthens a film that ends with moov', async () => {
    const { bytes } = filmOf(TRACKS, [CHUNK, 'moov']);
    const { at, removed, bytes: box } = await edit(bytes);
    expect(at + removed).toBe(bytes.length);
    expect(boxesIn(box).map(({ type }) => type)).toEqual(['moov']);
  });

  it('reads no media of a film larger than memory, and widens offsets that grow beyond 32 bits', async () => {
    const near = 2 ** 32 - 10;
    const start = concat(box('ftyp', u32(0, 0)), moovOf(TRACKS, [[5000], [near], [near + 5]]));
    const size = near + 1000;
    const head = concat(start, u32(1, 0x6d646174), u32(0, size - start.length));
    const reads: number[] = [];
    const file = {
      size,
      read: async (from: number, to: number) => {
        reads.push(to - from);
        return concat(head.slice(from, to), new Uint8Array(Math.max(0, to - Math.max(from, head.length))));
      },
    };
    const { removed, bytes } = await sphericalMp4Edit(file, 'film.mp4', FULL);
    const grown = bytes.length - removed;
    expect(reads.reduce((sum, length) => sum + length, 0)).toBeLessThan(head.length + 100);
    expect(chunkStarts(bytes)).toEqual([[5000 + grown], [near + grown], [near + 5 + grown]]);
    expect(inside(bytes, 'moov', 'trak', 'mdia', 'minf', 'stbl', 'co64')).toHaveLength(3);
  });
});

describe('a film is refused, with its name and place:', () => {
  const { bytes } = filmOf(TRACKS, ['moov', CHUNK]);
  const extra = [box('saio', u32(0, 1, 99))];
  it.each([
    ['fragmented', concat(bytes, box('moof')), 'film.mp4: the film is fragmented'],
    ['without moov', box('ftyp', u32(0)), 'film.mp4: there is no moov box'],
    ['with two', concat(bytes, box('moov')), 'film.mp4: there are two moov boxes, at byte 20 and '],
    ['without video', box('moov', box('trak', box('mdia', box('hdlr', new Uint8Array(20))))), 'no video track'],
    ['cut off', bytes.subarray(0, bytes.length - 1), 'film.mp4: mdat at byte'],
    [
      'without sample entries',
      moovOf([{ handler: 'vide', isWide: false }], []).map((byte, i, all) =>
        // The type of the sample table.
        String.fromCharCode(...all.subarray(i, i + 4)) === 'stsd' ? 0x78 : byte,
      ),
      'moov/trak does not describe its frames',
    ],
    ['with positions of another kind', filmOf(TRACKS, ['moov', CHUNK], extra).bytes, 'saio holds positions'],
    ['with items', concat(bytes, box('meta')), 'meta holds positions'],
    [
      'with chunks in moov',
      concat(moovOf(TRACKS, [[], [60]]), box('mdat')),
      'a chunk is at byte 60, inside moov or free space',
    ],
    ['with a huge moov', concat(u32(2 ** 26 + 1, 0x6d6f6f76), new Uint8Array(2 ** 26)), 'moov has 64.0 MiB'],
  ])('%s', async (_, film, words) => {
    const problem = await withSphericalMp4(film, 'film.mp4', FULL).catch((error) => error);
    expect(problem).toBeInstanceOf(MessageError);
    expect(problem.message).toContain(words);
  });

  it('with ten thousand boxes, at once', async () => {
    const many = new Uint8Array(8 * 10_001).map((_, i) => (i % 8 === 3 ? 8 : i % 8 > 3 ? 0x66 : 0));
    await expect(withSphericalMp4(many, 'film.mp4', FULL)).rejects.toThrow('more than 10000 boxes');
  });

  it.each(['mshp', 'abcd'])('spherical in a way that is not read: %s', async (projection) => {
    const marked = await withSphericalMp4(bytes, 'film.mp4', FULL);
    // 28 is the size of the box.
    const changed = replaced(marked, '\x1cequi', `\x1c${projection}`);
    await expect(told(changed)).rejects.toThrow(`film.mp4: the projection ${projection} is not read`);
  });
});

describe('a damaged film', () => {
  const { bytes } = filmOf(TRACKS, ['moov', CHUNK]);
  /** What comes of it, or the error that is not for users. */
  const attempt = async (broken: Uint8Array): Promise<unknown> => {
    for (const use of [() => told(broken), () => withSphericalMp4(broken, 'film.mp4', FULL)])
      try {
        await use();
      } catch (error) {
        if (!(error instanceof MessageError)) return error;
      }
    return undefined;
  };

  it('cut off anywhere is read or refused', async () => {
    const marked = await withSphericalMp4(bytes, 'film.mp4', { ...FULL, stereo: 'top-bottom' });
    for (let n = 0; n < marked.length; n++) expect(await attempt(marked.subarray(0, n))).toBeUndefined();
  });

  it('with any byte changed is read or refused', async () => {
    const crop = { left: 0.25, right: 0, top: 0, bottom: 0.5 };
    const marked = await withSphericalMp4(bytes, 'film.mp4', { ...FULL, stereo: 'top-bottom', crop });
    for (let i = 0; i < marked.length; i++)
      for (const value of [0, 1, 8, 255, marked[i] ^ (1 << (i % 8))])
        expect(await attempt(marked.with(i, value))).toBeUndefined();
  });
});

it('a wide moov and boxes that end with zeros keep what they have', async () => {
  const inner = inside(moovOf([TRACKS[1]], [[]]), 'moov')[0];
  const film = concat(box('ftyp', u32(0, 0)), wideBox('moov', inner, u32(0)));
  const marked = await withSphericalMp4(film, 'film.mp4', FULL);
  expect(await told(marked)).toEqual(FULL);
  expect([...marked.subarray(-4)]).toEqual([0, 0, 0, 0]);
});
