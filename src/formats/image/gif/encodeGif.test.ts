import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { inEnglish } from '../../../messages/message.ts';
import { GifEncoder, gifDelay } from './encodeGif.ts';
import { gifProblem } from './gifLimits.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-gif-'));
afterAll(() => rmSync(folder, { recursive: true }));

type Picture = (x: number, y: number) => readonly [number, number, number];

/** The film of some pictures, and what ffmpeg decodes of it: durations [s] and frames of RGB. */
function film(width: number, height: number, fps: number, pictures: readonly Picture[]) {
  const encoder = new GifEncoder({ width, height }, fps);
  const frames = pictures.map((picture) =>
    Uint8Array.from({ length: 4 * width * height }, (_, i) => {
      const pixel = Math.floor(i / 4);
      return [...picture(pixel % width, Math.floor(pixel / width)), 255][i % 4]!;
    }),
  );
  const bytes = Buffer.concat([...frames.map((rgba) => encoder.add(rgba)), encoder.finish()]);
  const path = join(folder, 'film.gif');
  writeFileSync(path, bytes);
  const asked = ['-v', 'error', '-show_entries', 'stream=width,height:packet=duration_time', '-of', 'json', path];
  const told = JSON.parse(execFileSync('ffprobe', asked, { encoding: 'utf8' })) as {
    packets: { duration_time: string }[];
    streams: { width: number; height: number }[];
  };
  const raw = join(folder, 'film.raw');
  const decode = ['-v', 'error', '-y', '-i', path, '-fps_mode', 'passthrough', '-f', 'rawvideo', '-pix_fmt', 'rgb24'];
  execFileSync('ffmpeg', [...decode, raw]);
  const pixels = new Uint8Array(readFileSync(raw));
  const size = 3 * width * height;
  return {
    bytes,
    frames,
    size: told.streams[0],
    durations: told.packets.map(({ duration_time }) => Number(duration_time)),
    decoded: Array.from({ length: pixels.length / size }, (_, k) => pixels.subarray(k * size, (k + 1) * size)),
  };
}

const rgbOf = (rgba: Uint8Array): number[] => [...rgba].filter((_, i) => i % 4 !== 3);
/** Colours, averaged over squares of 8 × 8 pixels. */
function blurred(rgb: ArrayLike<number>, width: number, height: number): number[] {
  const cells = (width / 8) * (height / 8);
  const sums = Array.from({ length: 3 * cells }, () => 0);
  for (let i = 0; i < 3 * width * height; i++) {
    const pixel = Math.floor(i / 3);
    const cell = Math.floor(Math.floor(pixel / width) / 8) * (width / 8) + Math.floor((pixel % width) / 8);
    sums[3 * cell + (i % 3)]! += rgb[i]! / 64;
  }
  return sums;
}

describe('an animated GIF, as ffmpeg decodes it', () => {
  it('has every frame, of its size, and few colours exactly', () => {
    const colors = [
      [250, 3, 17],
      [4, 200, 9],
      [1, 2, 255],
      [128, 128, 127],
    ] as const;
    // Stripes that move; the lower half is at rest, and the last frame does not change at all.
    const pictures = [0, 1, 2, 2].map(
      (k): Picture =>
        (x, y) =>
          colors[y < 12 ? (Math.floor(x / 5) + k) % 4 : 3]!,
    );
    const { decoded, frames, size } = film(37, 23, 10, pictures);
    expect(size).toEqual({ width: 37, height: 23 });
    expect(decoded).toHaveLength(4);
    decoded.forEach((picture, k) => {
      expect([...picture]).toEqual(rgbOf(frames[k]!));
    });
  });

  it('compresses and decodes noise, which fills the table of codes many times', () => {
    let seed = 1;
    const next = (): number => (seed = (seed * 48_271) % 2_147_483_647);
    const noise = Array.from({ length: 160 * 120 }, () => 4 * (next() % 60));
    const { decoded, frames } = film(160, 120, 10, [(x, y) => [noise[160 * y + x]!, 0, 0]]);
    expect([...decoded[0]!]).toEqual(rgbOf(frames[0]!));
  });

  it('has smooth gradients on average, though no pixel has more than 256 colours, and patterns that stay in place', () => {
    const sky: Picture = (x, y) => [40 + x / 2 + y / 4, 90 + x, 200 - x / 4 + y / 3];
    // A small thing moves in front of a gradient.
    const pictures = [0, 1, 2].map(
      (k): Picture =>
        (x, y) =>
          x >= 8 * k && x < 8 * k + 8 && y < 8 ? [255, 255, 255] : sky(x, y),
    );
    const { decoded, frames, bytes } = film(128, 96, 20, pictures);
    const [is, wanted] = [blurred(decoded[2]!, 128, 96), blurred(rgbOf(frames[2]!), 128, 96)];
    const errors = is.map((value, i) => Math.abs(value - wanted[i]!));
    expect(errors.reduce((a, b) => a + b) / errors.length).toBeLessThan(0.6);
    // At the corners no colour of the palette is beyond.
    expect(Math.max(...errors)).toBeLessThan(4);
    expect(
      new Set(Array.from({ length: 128 * 96 }, (_, i) => decoded[0]!.slice(3 * i, 3 * i + 3).join())).size,
    ).toBeLessThan(256);
    const below = 3 * 128 * 8;
    expect(Buffer.compare(decoded[2]!.subarray(below), decoded[0]!.subarray(below))).toBe(0);
    // What stays costs nothing.
    expect(bytes.length).toBeLessThan(1.2 * film(128, 96, 20, [sky]).bytes.length);
  });

  it('follows a change of all colours', () => {
    const ramp =
      (channel: number): Picture =>
      (x) =>
        [0, 1, 2].map((k) => (k === channel ? 2 * x : 0)) as [number, number, number];
    const { decoded, frames } = film(128, 16, 20, [ramp(0), ramp(1), ramp(2)]);
    decoded.forEach((picture, k) => {
      const [is, wanted] = [blurred(picture, 128, 16), blurred(rgbOf(frames[k]!), 128, 16)];
      expect(Math.max(...is.map((value, i) => Math.abs(value - wanted[i]!)))).toBeLessThan(1.5);
    });
  });

  it.each([
    [24, 0.04, 0.05],
    [30, 0.03, 0.04],
    [50, 0.02, 0.02],
    [0.5, 2, 2],
  ])('at %s frames a second lasts as long, with frames of %s or %s s', (fps, least, most) => {
    const pictures = Array.from(
      { length: 12 },
      (_, k): Picture =>
        () => [20 * k, 0, 0],
    );
    const { durations } = film(8, 8, fps, pictures);
    expect([Math.min(...durations), Math.max(...durations)]).toEqual([least, most]);
    let sum = 0;
    durations.forEach((duration, k) => {
      sum += duration;
      expect(Math.abs(sum - (k + 1) / fps)).toBeLessThan(0.0051);
    });
    expect(gifDelay(0, fps)).toBe(Math.round(100 / fps));
  });
});

it('is refused where it cannot be: too fast, too slow, too large', () => {
  const said = (width: number, fps: number) => {
    const problem = gifProblem({ width, height: 100 }, fps);
    return problem && inEnglish(problem);
  };
  expect(said(100, 60)).toMatch(/between one frame in 655 s and 50 a second, not 60; choose another rate/);
  expect(said(100, 0.001)).toMatch(/not 0\.001/);
  expect(said(5000, 24)).toMatch(/5000 × 100 pixels is too large; write at most 4096/);
  expect(said(4096, 50)).toBeUndefined();
});
