import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** What a film of one colour after another is made of. */
export interface TestFilm {
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
  { colors, seconds, rate, width, height, how = [] }: TestFilm,
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
