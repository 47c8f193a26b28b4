import { appendFileSync, copyFileSync, existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { COUNTED, countedColor, filmsInContainers, makePaintedFilm } from '../../../tests/support/testFilm.ts';
import type { FilmFrame, FilmFrames } from '../../formats/film/filmFrames.ts';
import { readFilmTrack } from '../../formats/film/filmTrack.ts';
import { random } from '../../math/random.ts';
import type { FilmTrack } from '../../scene/film/film.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { openDiskFile, readDiskFile } from './diskFiles.ts';
import { openFfmpegFrames } from './ffmpegFrames.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-frames-test-'));
const at = (name: string): string => join(folder, name);
let begins: Readonly<Record<string, number>>;
beforeAll(() => {
  setFileReader(readDiskFile);
  begins = filmsInContainers(folder);
});
afterAll(() => rmSync(folder, { recursive: true }));

async function trackOf(name: string, place: 'disk' | 'memory'): Promise<FilmTrack> {
  if (place === 'memory') {
    const handle = new Uint8Array(readFileSync(at(name)));
    return readFilmTrack({ name, handle }, handle.length);
  }
  const { file, size } = openDiskFile(at(name), name)!;
  return readFilmTrack(file, size);
}

async function using<T>(track: FilmTrack, work: (frames: FilmFrames) => Promise<T>): Promise<T> {
  const frames = openFfmpegFrames(track);
  try {
    return await work(frames);
  } finally {
    frames.close();
  }
}

/** Greatest difference of a frame's pixels from a colour, as wide and high as they should be. */
function off({ width, height, data }: FilmFrame, color: readonly number[], size = COUNTED): number {
  expect([width, height, data.length]).toEqual([size.width, size.height, 4 * size.width * size.height]);
  return data.reduce((most, value, i) => Math.max(most, Math.abs(value - (color[i % 4] ?? 255))), 0);
}

/** Frames in an order, as far as they are not of their colours: those of others are 64 steps away. */
async function wrong(track: FilmTrack, first: number, order: readonly number[]): Promise<unknown[]> {
  return using(track, async (frames) => {
    const found: unknown[] = [];
    for (const index of order) {
      const frame = await frames.frame(index);
      const most = off(frame, countedColor(first + index));
      if (most > 12) found.push({ index, most, seen: frame.data.slice(0, 3) });
    }
    return found;
  });
}

const NAMES = ['plain.mp4', 'fragmented.mp4', 'cut.mp4', 'plain.mov', 'plain.mkv', 'plain.webm'];

describe('frames by ffmpeg', () => {
  it.each(NAMES)('of %s are those that are asked for, forward, backward and at random', async (name) => {
    const track = await trackOf(name, 'disk');
    const first = begins[name]!;
    const count = COUNTED.frames - first;
    expect(track.times.length).toBe(count);
    const forward = Array.from({ length: count }, (_, i) => i);
    const next = random(3);
    expect(await wrong(track, first, forward)).toEqual([]);
    expect(await wrong(track, first, forward.filter((i) => i % 2 === 1).reverse())).toEqual([]);
    expect(
      await wrong(
        track,
        first,
        Array.from({ length: 15 }, () => Math.floor(count * next())),
      ),
    ).toEqual([]);
    expect(await wrong(track, first, [3, 3, 3, 0, 0])).toEqual([]);
  });

  it.each(['plain.mp4', 'plain.webm'])('of %s in memory are the same, and nothing is left behind', async (name) => {
    const left = () => readdirSync(tmpdir()).filter((each) => /^slowlight-\w{6}$/.test(each));
    const before = new Set(left());
    const track = await trackOf(name, 'memory');
    expect(await wrong(track, 0, [0, 1, 2, 45, 5, 4])).toEqual([]);
    expect(left().filter((each) => !before.has(each) && existsSync(join(tmpdir(), each, 'film')))).toEqual([]);
  });

  it('that are far ahead are found in a long film', async () => {
    const size = { width: 32, height: 16 } as const;
    const level = (k: number): [number, number, number] => [16 + 2 * (k % 100), 16 + 2 * (k % 100), 255 - (k % 100)];
    makePaintedFilm(folder, 'long.mp4', { ...size, frames: 200, rate: 30, paint: level });
    const track = await trackOf('long.mp4', 'disk');
    await using(track, async (frames) => {
      for (const index of [0, 24, 25, 26, 51, 77, 199, 100, 124, 149, 0])
        expect(off(await frames.frame(index), level(index), size as never), `${index}`).toBeLessThan(8);
    });
  });

  it('have their colours where the film says that they are of BT.709, and where it says nothing', async () => {
    const color = [224, 32, 64] as const;
    const film = { frames: 3, rate: 10, width: 64, height: 32, paint: () => color };
    const told = ['-vf', 'scale=out_color_matrix=bt709', '-colorspace', 'bt709'];
    makePaintedFilm(folder, 'bt709.mp4', { ...film, how: told });
    makePaintedFilm(folder, 'untold.mp4', film);
    // More rows than of standard definition are BT.709 if nothing is said.
    const high = { ...film, frames: 1, width: 1280, height: 640 };
    makePaintedFilm(folder, 'high.mp4', { ...high, how: told.slice(0, 2) });
    for (const [name, size] of [
      ['bt709.mp4', film],
      ['untold.mp4', film],
      ['high.mp4', high],
    ] as const) {
      const track = await trackOf(name, 'disk');
      const most = await using(track, async (frames) => off(await frames.frame(0), color, size as never));
      expect(most, name).toBeLessThan(6);
    }
  });

  it('of a film that is written to after it was opened are refused', async () => {
    copyFileSync(at('plain.mp4'), at('changed.mp4'));
    const track = await trackOf('changed.mp4', 'disk');
    expect(await wrong(track, 0, [2])).toEqual([]);
    appendFileSync(at('changed.mp4'), 'more');
    const refused = using(track, (frames) => frames.frame(0));
    await expect(refused).rejects.toMatchObject({ diagnostic: { code: 'file.changed', place: 'changed.mp4' } });
    await expect(refused).rejects.toThrow('it was written to since');
  });

  it('of a broken film are refused with what ffmpeg says, and those before the damage are shown', async () => {
    makePaintedFilm(folder, 'front.mp4', { ...COUNTED, paint: countedColor, how: ['-movflags', '+faststart'] });
    const whole = new Uint8Array(readFileSync(at('front.mp4')));
    const { file: _, ...rest } = await readFilmTrack({ name: 'front.mp4', handle: whole }, whole.length);
    // What tells of the frames is before them.
    const handle = whole.slice(0, Math.floor(0.75 * whole.length));
    const track = { ...rest, file: { name: 'broken.mp4', handle } };
    expect(track.times.length).toBe(COUNTED.frames);
    expect(await wrong(track, 0, [0, 1])).toEqual([]);
    const refused = using(track, (frames) => frames.frame(COUNTED.frames - 1));
    await expect(refused).rejects.toMatchObject({ diagnostic: { code: 'film.undecodable', place: 'broken.mp4' } });
    await expect(refused).rejects.toThrow(/its frame 47 of 48 cannot be decoded; ffmpeg says: (?!nothing)./);
    const noise = Uint8Array.from({ length: 999 }, (_, i) => (i * 37) % 256);
    const never = using({ ...track, file: { name: 'noise.mp4', handle: noise } }, (frames) => frames.frame(0));
    await expect(never).rejects.toThrow(/noise\.mp4: its frame 0 of 48 cannot be decoded; ffmpeg says: .*[Ii]nvalid/);
  });
});
