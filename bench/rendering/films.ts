import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openFfmpegFrames } from '../../src/cli/files/ffmpegFrames.ts';
import { openSceneFile } from '../../src/cli/files/sceneFiles.ts';
import { FilmPanorama } from '../../src/formats/film/filmPanorama.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { domeMaps } from '../../src/render/lights/sky/domeMaps.ts';
import { filmedDome } from '../../src/scene/film/seenFilm.ts';
import { type Bench, median, timed } from '../support/bench.ts';

/** Frames a second of the film, and how many are measured. */
const [RATE, MEASURED] = [24, 8];
const WIDTHS = [1024, 2048, 4096];
/** Away from the origin a picture has frames of this long before and after [s]. */
const DELAY = 0.5;

export const films: Bench = {
  name: 'films',
  title: 'Films as surroundings',
  about:
    'A 360° film of 24 frames a second (H.264, a moving test pattern), whose frames are seen one after another: what it takes to make the picture of a dome of each, by ffmpeg on the command line, which is the picture’s cost besides drawing it. Decoding, at the origin and half a light second from it, where 25 frames make a picture; then the maps that the rasterizer needs of it, and those for light on things that move, coarse as in the page, fine as in files. ' +
    'In the page all of it is done by a worker while pictures go on.',
  async run() {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-bench-'));
    try {
      const rows: number[][] = [];
      for (const width of WIDTHS) rows.push(await measured(join(folder, `${width}.mp4`), width));
      const columns = [
        'width [px]',
        'one frame [ms]',
        'frames of 1 s [ms]',
        'maps [ms]',
        'light, coarse [ms]',
        'fine [ms]',
      ];
      return [{ columns, rows }];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};

async function measured(file: string, width: number): Promise<number[]> {
  const pattern = `testsrc2=s=${width}x${width / 2}:r=${RATE}:d=3`;
  const made = spawnSync('ffmpeg', ['-loglevel', 'error', '-f', 'lavfi', '-i', pattern, '-pix_fmt', 'yuv420p', file]);
  if (made.status !== 0) throw new Error(`ffmpeg: ${made.stderr}`);
  const dome = filmedDome(await openSceneFile(file));
  if (!dome) throw new Error('there is no film');
  const film = new FilmPanorama(dome, openFfmpegFrames, 2 ** 30);
  const seen = (t: number, position: Vec3) => film.seenAt({ t, position, speedOfLight: 1 });
  await seen(1, [0, 0, 0]);
  const [one, many]: [number[], number[]] = [[], []];
  for (let i = 1; i <= MEASURED; i++) one.push(await timed(() => seen(1 + i / RATE, [0, 0, 0]).then(() => {})));
  await seen(1, [DELAY, 0, 0]);
  for (let i = 1; i <= MEASURED; i++) many.push(await timed(() => seen(1 + i / RATE, [DELAY, 0, 0]).then(() => {})));
  const picture = await seen(2, [0, 0, 0]);
  film.close();
  const maps: number[][] = [];
  for (let i = 0; i < 3; i++) {
    const all: number[] = [];
    for (const means of ['none', 'coarse', 'fine'] as const) all.push(await timed(() => void domeMaps(picture, means)));
    maps.push(all);
  }
  const [none, coarse, fine] = [0, 1, 2].map((k) => median(maps.map((all) => all[k])));
  return [width, median(one), median(many), none, coarse - none, fine - none];
}
