import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import { decodeImage } from '../../src/formats/image/decodeImage.ts';
import { makePaintedFilm } from '../support/testFilm.ts';
import { outputFolder, slowlight, slowlightJson } from './program.ts';

const folder = outputFolder();
const at = (name: string): string => join(folder, name);

const [W, H, RATE, FRAMES] = [128, 64, 10, 40];
/** Grey by frame, 0 … 255. */
const level = (frame: number): number => 16 + 6 * frame;
/** Where and when the film is seen, at a speed of light of 10 m/s. */
const [X, T, C] = [5, 2.03, 10];
const HERE = ['--time', String(T), '--position', `${X},0,0`, '--c', String(C)];
/** Pixels are directions, and grey what the film has. */
const PLAIN = ['--lens', 'equirectangular', '--size', `${W}x${H}`, '--metering', 'manual', '--tone', 'linear'];

beforeAll(() => {
  makePaintedFilm(folder, 'grey.mp4', {
    ...{ frames: FRAMES, rate: RATE, width: W, height: H },
    paint: (frame) => [level(frame), level(frame), level(frame)],
    how: ['-crf', '2'],
  });
});

interface Grey {
  /** Levels of red, green and blue. */
  readonly rgb: readonly number[];
  /** cos of the angle between the pixel's direction and +X, in the observer's frame. */
  readonly right: number;
}

function greysOf(name: string): Grey[] {
  const { width, height, data } = decodeImage(new Uint8Array(readFileSync(at(name))), name);
  expect([width, height]).toEqual([W, H]);
  return Array.from({ length: W * H }, (_, i) => {
    const longitude = 2 * Math.PI * (((i % W) + 0.5) / W - 0.5);
    const horizontal = Math.cos(Math.PI * (0.5 - (Math.floor(i / W) + 0.5) / H));
    return {
      rgb: Array.from(data.subarray(4 * i, 4 * i + 3)),
      right: horizontal * Math.sin(longitude),
    };
  });
}

async function drawn(name: string, ...flags: readonly string[]): Promise<Grey[]> {
  const { code, err } = await slowlight('render', at('grey.mp4'), '-o', at(name), ...HERE, ...PLAIN, ...flags);
  expect(code, err).toBe(0);
  return greysOf(name);
}

/** Expects the frames of the film's times [s]; where two meet, within `blur` frames, texels of both are blended. */
function expectFrames(greys: readonly Grey[], time: (grey: Grey) => number, tolerance: number, blur: number): void {
  const frames = new Set<number>();
  const wrong = greys.filter((grey) => {
    const played = time(grey) * RATE;
    const from = Math.floor(played - blur);
    const to = Math.floor(played + blur);
    frames.add(from);
    const [low, high] = [from, to].map((frame) => level(Math.min(Math.max(frame, 0), FRAMES - 1))) as [number, number];
    return grey.rgb.some((value) => value < low - tolerance || value > high + tolerance);
  });
  expect(wrong.slice(0, 5)).toEqual([]);
  expect(frames.size).toBeGreaterThan(8);
}

describe('a film of all directions', () => {
  /** A texel is 2.8° wide, and so 0.25 frames at most. */
  const BLUR = 0.3;

  test.each([
    ['reference', 2],
    ['raster', 3],
  ])('has in direction n the frame of t + n·x/c: %s', async (pipeline, tolerance) => {
    const greys = await drawn(`${pipeline}.png`, '--pipeline', pipeline, '--no-antialiasing');
    expectFrames(greys, ({ right }) => T + (right * X) / C, tolerance, BLUR);
    const there = ['--pipeline', pipeline, '--no-antialiasing', '--position', '0,0,0'];
    const origin = await drawn(`${pipeline}-origin.png`, ...there);
    for (const { rgb } of origin) for (const value of rgb) expect(Math.abs(value - level(20))).toBeLessThanOrEqual(2);
  });

  test.each(['reference', 'raster'])('has its frames where aberration has their directions: %s', async (pipeline) => {
    const beta = 0.6;
    const places = ['--beta', `${beta},0,0`, '--beaming', '0', '--doppler-mix', '0', '--colors', 'approximate'];
    const greys = await drawn(`${pipeline}-fast.png`, '--pipeline', pipeline, '--no-antialiasing', ...places);
    // Behind, a pixel is of a wider angle of the world.
    const world = (right: number): number => (right - beta) / (1 - beta * right);
    expectFrames(greys, ({ right }) => T + (world(right) * X) / C, 3, 2 * BLUR);
  });

  test('of the rasterizer and of the reference are the same, picture by picture', async () => {
    const frames = ['--frames', '0:2', '--fps', '1', '--position', '0,-2,4', '--samples', '2'];
    const pictures: Grey[][][] = [];
    for (const pipeline of ['reference', 'raster']) {
      const name = (k: string | number): string => `${pipeline}-${k}.png`;
      const how = [...HERE.slice(4), ...PLAIN, ...frames, '--pipeline', pipeline];
      const { code, err } = await slowlight('render', at('grey.mp4'), '-o', at(name('#')), ...how);
      expect(code, err).toBe(0);
      pictures.push([0, 1, 2].map((k) => greysOf(name(k))));
    }
    const [truth, raster] = pictures as [Grey[][], Grey[][]];
    truth.forEach((greys, k) => {
      const off = greys.map(({ rgb }, i) => Math.abs(rgb[0]! - raster[k]![i]!.rgb[0]!));
      expect(Math.max(...off)).toBeLessThanOrEqual(6);
      expect(off.reduce((sum, each) => sum + each, 0) / off.length).toBeLessThan(1);
    });
    const middle = truth.map((greys) => greys[(H / 2) * W + W / 2]!.rgb[0]!);
    // Ahead is −Z, of which an observer at z = 4 m sees what was there 0.4 s ago.
    expect(middle.map((grey) => Math.round((grey - 16) / 6))).toEqual([0, 6, 16]);
  });

  test('takes the time that it takes, and as many time codes a second', async () => {
    expect(await slowlightJson('inspect', at('grey.mp4'))).toMatchObject({
      startTime: 0,
      endTime: FRAMES / RATE,
      timeCodesPerSecond: RATE,
    });
    const { out } = await slowlight('inspect', at('grey.mp4'));
    expect(out).toContain(`grey  (dome light, a film of ${FRAMES} frames)`);
  });

  test('is written as its first picture, which is said', async () => {
    const { code, err } = await slowlight('convert', at('grey.mp4'), at('grey.usda'));
    expect(code).toBe(0);
    expect(err).toMatch(/grey: its film is not written, only its first picture/);
  });

  test('that is no panorama is refused, with its name', async () => {
    makePaintedFilm(folder, 'flat.mp4', { frames: 2, rate: 10, width: 64, height: 36, paint: () => [9, 9, 9] });
    const { code, err } = await slowlight('render', at('flat.mp4'), '-o', at('flat.png'), ...PLAIN);
    expect(code).toBe(3);
    expect(err).toMatch(/flat\.mp4: the film has 64 × 36 pixels, and is no panorama/);
  });
});
