import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** What a film of one colour after another is made of. */
export interface ColorFilm {
  /** By part, as ffmpeg names them: `red`, `0x404040`; without any there is only silence. */
  readonly colors: readonly string[];
  /** Of a part [s]. */
  readonly seconds: number;
  /** Frames a second. */
  readonly rate: number;
  readonly width: number;
  readonly height: number;
  /** Further arguments for the output. */
  readonly how?: readonly string[];
}

/** Makes a film with ffmpeg: H.264 with B-frames, several key frames, and silence that begins with it. */
export function makeTestFilm(
  folder: string,
  name: string,
  { colors, seconds, rate, width, height, how = [] }: ColorFilm,
): Buffer {
  const parts = colors.map((color) => `color=c=${color}:s=${width}x${height}:r=${rate}:d=${seconds}`);
  const inputs = [...parts, 'anullsrc'].flatMap((filter) => ['-f', 'lavfi', '-i', filter]);
  const joined = `${colors.map((_, i) => `[${i}]`).join('')}concat=n=${colors.length},format=yuv420p[v]`;
  const path = join(folder, name);
  const ends = ['-t', String(Math.max(1, colors.length) * seconds)];
  const pictures = colors.length > 0 ? ['-filter_complex', joined, '-map', '[v]'] : [];
  const maps = [...pictures, '-map', `${colors.length}:a`];
  const made = spawnSync(
    'ffmpeg',
    ['-loglevel', 'error', '-y', ...inputs, ...maps, '-g', '7', '-bf', '2', '-crf', '10', ...how, ...ends, path],
    { encoding: 'utf8' },
  );
  if (made.status !== 0) throw new Error(`ffmpeg: ${made.stderr}`);
  return readFileSync(path);
}

/** What a film of frames that are painted pixel by pixel is made of. */
export interface PaintedFilm extends Omit<ColorFilm, 'colors' | 'seconds'> {
  readonly frames: number;
  /** sRGB of a pixel, 0 … 255, x to the right and y down. */
  readonly paint: (frame: number, x: number, y: number) => readonly [number, number, number];
}

/** Makes a film as `makeTestFilm` does, of any frames. */
export function makePaintedFilm(
  folder: string,
  name: string,
  { frames, paint, rate, width, height, how = [] }: PaintedFilm,
): Buffer {
  const input = new Uint8Array(3 * width * height * frames);
  for (let frame = 0, i = 0; frame < frames; frame++)
    for (let y = 0; y < height; y++) for (let x = 0; x < width; x++, i += 3) input.set(paint(frame, x, y), i);
  const raw = ['-f', 'rawvideo', '-pix_fmt', 'rgb24', '-s', `${width}x${height}`, '-r', String(rate), '-i', '-'];
  const sound = ['-f', 'lavfi', '-i', 'anullsrc', '-t', String(frames / rate)];
  const path = join(folder, name);
  const coded = ['-pix_fmt', 'yuv420p', '-g', '7', '-bf', '2', '-crf', '10', ...how];
  const made = spawnSync('ffmpeg', ['-loglevel', 'error', '-y', ...raw, ...sound, ...coded, path], { input });
  if (made.status !== 0) throw new Error(`ffmpeg: ${made.stderr}`);
  return readFileSync(path);
}

/** What is left of a film from a time [s] on, without decoding: its first frames are hidden by an edit list. */
export function cutTestFilm(folder: string, from: string, name: string, seconds: number): Buffer {
  const [path, cut] = [join(folder, from), join(folder, name)];
  const made = spawnSync('ffmpeg', ['-loglevel', 'error', '-y', '-ss', String(seconds), '-i', path, '-c', 'copy', cut]);
  if (made.status !== 0) throw new Error(`ffmpeg: ${made.stderr}`);
  return readFileSync(cut);
}

/** Frames of `filmsInContainers`. */
export const COUNTED = { frames: 48, rate: 10, width: 64, height: 32 } as const;

/** The colour of frame `k` of them, of which no other is near. */
export const countedColor = (k: number): [number, number, number] => [
  32 + 64 * (k % 4),
  32 + 64 * (Math.floor(k / 4) % 4),
  32 + 64 * Math.floor(k / 16),
];

/** Films whose frames are told apart by colour, by name: with what they begin. They are written to `folder`. */
export function filmsInContainers(folder: string): Readonly<Record<string, number>> {
  const make = (name: string, ...how: string[]): Buffer =>
    makePaintedFilm(folder, name, { ...COUNTED, paint: countedColor, how });
  make('plain.mp4');
  make('fragmented.mp4', '-movflags', 'frag_keyframe+empty_moov');
  cutTestFilm(folder, 'plain.mp4', 'cut.mp4', 0.9);
  make('plain.mov');
  make('plain.mkv');
  make('plain.webm', '-c:v', 'libvpx-vp9', '-b:v', '0');
  return {
    ...{ 'plain.mp4': 0, 'fragmented.mp4': 0, 'cut.mp4': 9 },
    ...{ 'plain.mov': 0, 'plain.mkv': 0, 'plain.webm': 0 },
  };
}
