import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { COUNTED, countedColor, filmsInContainers, makePaintedFilm } from '../../../tests/support/testFilm.ts';
import { openFfmpegFrames } from '../../cli/files/ffmpegFrames.ts';
import { filmDuration } from '../../scene/film/film.ts';
import { type FilmedDome, filmedDome } from '../../scene/film/seenFilm.ts';
import type { Scene } from '../../scene/types.ts';
import { domeLens } from '../../scene/view/lenses/fisheyeLens.ts';
import { memorySource } from '../files/fileSource.ts';
import { openScene } from '../open.ts';
import type { ReadOptions } from '../readOptions.ts';
import { withSphericalMp4 } from '../spherical/sphericalMp4.ts';
import { readFilmTrack } from './filmTrack.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-film-test-'));
let begins: Readonly<Record<string, number>>;
beforeAll(() => {
  begins = filmsInContainers(folder);
});
afterAll(() => rmSync(folder, { recursive: true }));

const bytesOf = (name: string): Uint8Array => new Uint8Array(readFileSync(join(folder, name)));
const trackOf = (name: string, bytes = bytesOf(name)) => readFilmTrack({ name, handle: bytes }, bytes.length);
const ffmpeg = (...args: readonly string[]): void =>
  void execFileSync('ffmpeg', ['-loglevel', 'error', '-y', ...args], { cwd: folder });

/** When frames are shown, and the last one ends, by ffprobe, which decodes them [s]. */
function probed(name: string): { readonly times: readonly number[]; readonly end: number } {
  const entries = ['-select_streams', 'V:0', '-show_entries', 'frame=pts_time', '-of', 'json', name];
  const told = execFileSync('ffprobe', ['-v', 'error', ...entries], { cwd: folder, encoding: 'utf8' });
  const { frames } = JSON.parse(told) as { readonly frames: readonly { readonly pts_time: string }[] };
  const times = frames.map(({ pts_time }) => Number(pts_time));
  return { times, end: times.at(-1)! + 1 / COUNTED.rate };
}

const open = (name: string, bytes = bytesOf(name), options: ReadOptions = {}): Promise<Scene> =>
  openScene(memorySource({ [name]: bytes }), name, { openFilm: openFfmpegFrames, ...options });

/** The dome of a scene of a film, and its texel at a part of its picture's width and height. */
function domeOf(scene: Scene): { readonly dome: FilmedDome; readonly at: (u: number, v: number) => readonly number[] } {
  const dome = filmedDome(scene)!;
  const { width, height, data } = dome.texture;
  return {
    dome,
    at: (u, v) => {
      const i = 4 * (Math.floor(v * height) * width + Math.floor(u * width));
      return Array.from(data.slice(i, i + 3));
    },
  };
}

function expectColor(found: readonly number[], color: readonly number[], tolerance = 12): void {
  const most = Math.max(...color.map((value, k) => Math.abs(value - found[k]!)));
  expect(most, `${found} for ${color}`).toBeLessThanOrEqual(tolerance);
}

const NAMES = ['plain.mp4', 'fragmented.mp4', 'cut.mp4', 'plain.mov', 'plain.mkv', 'plain.webm'];

describe('the frames of a film', () => {
  it.each(NAMES)('begin when ffprobe has them: %s', async (name) => {
    const track = await trackOf(name);
    const { times, end } = probed(name);
    expect(track.times.length).toBe(COUNTED.frames - begins[name]!);
    expect(times.length).toBe(track.times.length);
    // Files tell milliseconds, and ffprobe micro-seconds.
    times.forEach((time, i) => void expect(track.times[i], `frame ${i}`).toBeCloseTo(time, 5));
    expect(Math.abs(track.end - end)).toBeLessThan(0.0011);
    expect([track.width, track.height]).toEqual([COUNTED.width, COUNTED.height]);
    expect(track.bytes).toBe(bytesOf(name).length);
  });

  it('may take different times', async () => {
    const film = { ...COUNTED, frames: 20, paint: countedColor };
    // The frames 5, 6 and 7 are left out.
    makePaintedFilm(folder, 'uneven.mp4', {
      ...film,
      how: ['-vf', "select='lt(n,5)+gt(n,7)'", '-fps_mode', 'passthrough'],
    });
    const { times } = await trackOf('uneven.mp4');
    expect(times.length).toBe(17);
    expect(Array.from(times, (time) => Math.round(10 * (time - times[0]!)))).toEqual([
      0, 1, 2, 3, 4, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    ]);
  });

  it('are as wide as they are shown, where their pixels are not square', async () => {
    makePaintedFilm(folder, 'wide-pixels.mp4', {
      ...COUNTED,
      frames: 3,
      width: 32,
      paint: countedColor,
      how: ['-aspect', '2'],
    });
    const { width, height } = await trackOf('wide-pixels.mp4');
    expect([width, height]).toEqual([64, 32]);
    const scene = await open('wide-pixels.mp4');
    expect([domeOf(scene).dome.texture.width, domeOf(scene).dome.texture.height]).toEqual([64, 32]);
  });
});

describe('a film is surroundings', () => {
  it.each(NAMES)('with the time that it takes and its first picture: %s', async (name) => {
    const scene = await open(name);
    const { dome, at } = domeOf(scene);
    const duration = (COUNTED.frames - begins[name]!) / COUNTED.rate;
    expect(scene.startTime).toBe(0);
    expect(scene.endTime).toBeCloseTo(duration, 2);
    expect(filmDuration(dome.film)).toBe(scene.endTime);
    expect(scene.timeCodesPerSecond).toBe(COUNTED.rate);
    expect(dome.film).toMatchObject({ start: 0, speed: 1, repeats: false, layout: {} });
    expect(dome.texture).toMatchObject({ width: 64, height: 32, colorSpace: 'srgb' });
    for (const u of [0.1, 0.5, 0.9]) expectColor(at(u, 0.5), countedColor(begins[name]!));
    expect([scene.name, scene.diagnostics, scene.cameras.length]).toEqual([name.split('.')[0], [], 1]);
  });

  it('of both eyes, one above the other, that of the left is shown', async () => {
    const [left, right] = [
      [200, 40, 90],
      [40, 200, 90],
    ] as const;
    makePaintedFilm(folder, 'eyes.mp4', {
      ...{ frames: 4, rate: 10, width: 64, height: 64 },
      paint: (_frame, _x, y) => (y < 32 ? left : right),
    });
    const marked = await withSphericalMp4(bytesOf('eyes.mp4'), 'eyes.mp4', {
      ...{ projection: 'equirectangular', stereo: 'top-bottom' },
    });
    const scene = await open('eyes.mp4', marked);
    const { dome, at } = domeOf(scene);
    expect([dome.texture.width, dome.texture.height]).toEqual([64, 32]);
    for (const v of [0.05, 0.5, 0.9]) expectColor(at(0.5, v), left);
    expect(scene.diagnostics.map(({ code }) => code)).toEqual(['panorama.stereo']);
    expect(dome.film.layout).toEqual({ coverage: { projection: 'equirectangular', stereo: 'top-bottom' } });
    // Without the mark it is a square.
    await expect(open('eyes.mp4')).rejects.toMatchObject({ diagnostic: { code: 'panorama.size' } });
  });

  it('of a dome master where that is said: what is in its middle is in the zenith', async () => {
    const size = 96;
    const [zenith, rim] = [
      [210, 60, 60],
      [60, 60, 210],
    ] as const;
    makePaintedFilm(folder, 'dome.mp4', {
      ...{ frames: 3, rate: 10, width: size, height: size },
      paint: (_frame, x, y) => (Math.hypot(x + 0.5 - size / 2, y + 0.5 - size / 2) < size / 4 ? zenith : rim),
    });
    const fisheye = domeLens(Math.PI, 0);
    const { dome, at } = domeOf(await open('dome.mp4', undefined, { fisheye }));
    expect(dome.film.layout).toEqual({ fisheye });
    expect(dome.texture.width).toBe(2 * dome.texture.height);
    // A quarter of the width from the middle of the circle is 45° from the zenith.
    for (const u of [0.1, 0.5, 0.8]) {
      expectColor(at(u, 0.05), zenith);
      expectColor(at(u, 0.2), zenith);
      expectColor(at(u, 0.3), rim);
      expectColor(at(u, 0.45), rim);
      expectColor(at(u, 0.7), [0, 0, 0]);
    }
  });

  it('of six faces of a cube', async () => {
    makePaintedFilm(folder, 'cube.mp4', {
      ...{ frames: 3, rate: 10, width: 192, height: 32 },
      paint: (_frame, x) => countedColor(5 * Math.floor(x / 32)),
    });
    const { dome, at } = domeOf(await open('cube.mp4'));
    expect(dome.texture.width).toBe(2 * dome.texture.height);
    // Right, left, up, down, ahead, behind; ahead is in the middle.
    expectColor(at(0.5, 0.5), countedColor(20));
    expectColor(at(0.75, 0.5), countedColor(0));
    expectColor(at(0.25, 0.5), countedColor(5));
    expectColor(at(0.5, 0.02), countedColor(10));
    expectColor(at(0.5, 0.98), countedColor(15));
    expectColor(at(0.01, 0.5), countedColor(25));
  });
});

describe('what is refused', () => {
  const refused = async (name: string, code: string, words: RegExp, bytes?: Uint8Array, options?: ReadOptions) => {
    const thrown = await open(name, bytes, options).then(
      () => undefined,
      (error: unknown) => error,
    );
    expect(thrown).toMatchObject({ diagnostic: { code, place: name, severity: 'error' } });
    expect(String(thrown)).toMatch(words);
  };

  it('text by the name of a film', () =>
    refused(
      'text.mp4',
      'film.unreadable',
      /no film in MP4, QuickTime, Matroska or WebM, or it is damaged; convert it/,
      new TextEncoder().encode('These are words, and no film.\n'.repeat(99)),
    ));

  it.each(['mp4', 'mkv', 'webm'])('sound alone: %s', async (extension) => {
    ffmpeg('-f', 'lavfi', '-i', 'anullsrc', '-t', '1', `sound.${extension}`);
    await refused(`sound.${extension}`, 'film.empty', /there are no pictures in it/);
  });

  it.each(['smpte2084', 'arib-std-b67'])('high dynamic range: %s', async (transfer) => {
    const colors = ['-color_primaries', 'bt2020', '-color_trc', transfer, '-colorspace', 'bt2020nc'];
    makePaintedFilm(folder, 'hdr.mp4', { ...COUNTED, frames: 3, paint: countedColor, how: colors });
    await refused('hdr.mp4', 'film.hdr', /high dynamic range.*convert it to BT\.709/);
  });

  it('the shape of a film that is no panorama', async () => {
    makePaintedFilm(folder, 'flat.mp4', { ...COUNTED, frames: 3, height: 36, paint: countedColor });
    await refused('flat.mp4', 'panorama.size', /64 × 36 pixels, and is no panorama: one is twice as wide as high/);
  });

  it('a film where nothing decodes it', () =>
    refused('plain.mp4', 'film.undecodable', /films are not decoded here/, undefined, {
      openFilm: undefined,
    } as never));

  it('a film of which nothing but the beginning or the end is there', async () => {
    const whole = bytesOf('plain.mp4');
    const half = whole.slice(0, whole.length / 2);
    await refused('part.mp4', 'film.unreadable', /damaged: mdat at byte \d+ claims \d+ bytes of the \d+/, half);
    const unfinished = whole.slice(0, Buffer.from(whole).indexOf('moov') - 4);
    await refused('part.mp4', 'film.unreadable', /damaged: there is no moov box: the film is cut off/, unfinished);
    await refused('part.mp4', 'film.unreadable', /no film/, whole.slice(whole.length / 2));
    await refused('part.mp4', 'file.empty', /0 bytes/, new Uint8Array());
    // Its table comes first, and its pictures are missing.
    makePaintedFilm(folder, 'front.mp4', { ...COUNTED, paint: countedColor, how: ['-movflags', '+faststart'] });
    const front = bytesOf('front.mp4');
    const data = Buffer.from(front).indexOf('mdat') + 16;
    await refused('front.mp4', 'film.unreadable', /damaged: mdat at byte/, front.slice(0, data));
  });

  it.each([
    ['plain.mp4', 'stsz', 8, /stbl\/stsz claims 4294967295 samples, more than a film can have/],
    ['plain.mp4', 'stts', 8, /stbl\/stts claims \d{10} samples/],
    ['plain.mp4', 'ctts', 8, /stbl\/ctts claims \d{10} samples/],
    ['plain.mp4', 'ctts', 4, /stbl\/ctts ends before its byte/],
    ['plain.mp4', 'stsc', 12, /stbl\/stsc claims \d{10,} samples/],
    ['fragmented.mp4', 'trun', 4, /moof claims \d{10} samples/],
  ] as const)('a count that is huge: %s, %s at %i', async (name, box, at, words) => {
    const film = bytesOf(name).slice();
    const table = Buffer.from(film).indexOf(box) + 4;
    film.set([255, 255, 255, 255], table + at);
    await refused('huge.mp4', 'film.unreadable', words, film);
  });
});
