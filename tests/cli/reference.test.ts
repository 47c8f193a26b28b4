import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { decodeImage } from '../../src/formats/image/decodeImage.ts';
import type { ExrImage } from '../../src/formats/image/exr.ts';
import { readExr } from '../../src/formats/image/readExr.ts';
import { DEFAULT_LIGHT } from '../../src/reference/lights/lightOptions.ts';
import type { TileRequest } from '../../src/reference/tileRequest.ts';
import { makeScene } from '../../src/scene/defaults.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { AOVS, type AovName, DEFAULT_SETTINGS, type ViewPoint } from '../../src/scene/view/view.ts';
import {
  ask,
  outputFolder,
  type ProgramResult,
  programResult,
  scene,
  slowlight,
  slowlightJson,
  start,
  startIn,
} from './program.ts';

const folder = outputFolder();
const out = (name: string): string => join(folder, name);
const movers = scene('movers.usda');
const size = ['--size', '96x54'];
const flight = ['--time', '1', '--beta', '0.2,0,-0.5'];
const reference = ['--pipeline', 'reference', '--samples', '1'];
const data: readonly AovName[] = ['depth', 'emission_time', 'doppler', 'position', 'velocity', 'object'];

type Seen = Readonly<Record<'distance' | 'time' | 'doppler' | 'object', number>> &
  Readonly<Record<'position' | 'velocity', readonly number[]>>;

/** A machine without GPU and browser: the PATH is empty, and the only Vulkan driver named does not exist. */
const { CHROMIUM: _, ...rest } = process.env;
const noGpu = { ...rest, PATH: folder, VK_ICD_FILENAMES: out('no-driver.json') };
/** A machine on which the GPU libraries do not even load. */
const noLibraries = {
  ...noGpu,
  NODE_OPTIONS: `--import ${new URL('./noGpuLibraries.mjs', import.meta.url).href}`,
};

const without = (env: NodeJS.ProcessEnv, ...args: string[]): Promise<ProgramResult> =>
  programResult(startIn(env, ...args));

test('renders without GPU, GPU libraries and browser: the red cube ahead, sky above', async () => {
  const file = out('still.png');
  const flags = [...size, '--time', '1', '--pipeline', 'reference', '--samples', '2', '--threads', '2', '--json'];
  const { code, err, out: json } = await without(noLibraries, 'render', movers, '-o', file, ...flags);
  expect(code, err).toBe(0);
  expect(JSON.parse(json)).toMatchObject({ pipeline: 'reference', threads: 2, seed: 0, samples: 2 });
  const { width, height, data: pixels } = decodeImage(new Uint8Array(readFileSync(file)), file);
  expect([width, height]).toEqual([96, 54]);
  const at = (x: number, y: number) => pixels.subarray(4 * (y * 96 + x), 4 * (y * 96 + x) + 3);
  const [red, green, blue] = at(48, 27);
  expect(red).toBeGreaterThan(1.5 * green);
  expect(red).toBeGreaterThan(1.5 * blue);
  expect(at(48, 1)[2]).toBeGreaterThan(at(48, 1)[0]);
});

/** The values of an AOV at a pixel. */
function valuesAt(image: ExrImage, name: AovName, x: number, y: number): number[] {
  return AOVS[name].channels.map((channel) => {
    const found = image.channels.find((candidate) => candidate.name === channel);
    if (!found) throw new Error(`no channel ${channel}`);
    return found.data[y * image.width + x];
  });
}

test.each(['light-cone', 'simultaneity', 'galilean'])('data channels equal the probe of a pixel: %s', async (view) => {
  const file = out(`${view}.exr`);
  const how = [...size, ...flight, '--view', view];
  const { code, err } = await slowlight('render', movers, '-o', file, ...how, ...reference, '--aov', data.join());
  expect(code, err).toBe(0);
  const image = readExr(new Uint8Array(readFileSync(file)), file);
  const ids = Array.from(image.channels.find(({ name }) => name === 'object')?.data ?? []);
  const places = [1, 2, 3].map((id) => ids.indexOf(id)).filter((i) => i >= 0);
  // The cube ahead is visible in every view; the moving one only in views with light.
  expect(places.length).toBeGreaterThanOrEqual(view === 'light-cone' ? 2 : 1);
  for (const place of places) {
    const [x, y] = [place % 96, Math.floor(place / 96)];
    const { seen } = await slowlightJson<{ seen: Seen }>('probe', movers, '--pixel', `${x},${y}`, ...how);
    const said: Record<string, readonly number[]> = {
      depth: [seen.distance],
      emission_time: [seen.time],
      doppler: [seen.doppler],
      position: seen.position,
      velocity: seen.velocity,
      object: [seen.object],
    };
    for (const name of data) {
      const found = valuesAt(image, name, x, y);
      // Both are computed in f64; the file holds f32.
      said[name].forEach((value, k) => void expect(found[k], `${name} at ${x},${y}`).toBeCloseTo(value, 5));
    }
  }
});

test('the bits depend on the seed, not on the number of threads', async () => {
  const aovs = ['--aov', ['beauty', 'albedo', 'normal', ...data].join()];
  const draw = async (name: string, ...flags: string[]): Promise<Buffer> => {
    const file = out(`${name}.exr`);
    const how = [...size, ...flight, '--pipeline', 'reference', '--samples', '2', ...aovs];
    const { code, err } = await slowlight('render', movers, '-o', file, ...how, ...flags);
    expect(code, err).toBe(0);
    return readFileSync(file);
  };
  const [one, three, again] = await Promise.all([
    draw('one', '--threads', '1'),
    draw('three', '--threads', '3', '--seed', '0'),
    draw('other', '--threads', '2', '--seed', '7'),
  ]);
  expect(one.equals(three)).toBe(true);
  expect(one.equals(again)).toBe(false);
});

test('adaptive sampling: samples between the least and the most, the same bits by any number of threads', async () => {
  const draw = async (name: string, ...flags: string[]): Promise<Buffer> => {
    const file = out(`${name}.exr`);
    const how = [...size, ...flight, '--pipeline', 'reference', '--samples', '6', '--aov', 'beauty,sample_count'];
    const { code, err } = await slowlight('render', movers, '-o', file, ...how, ...flags);
    expect(code, err).toBe(0);
    return readFileSync(file);
  };
  const noise = ['--noise-threshold', '0.03', '--min-samples', '2'];
  const [one, two, all] = await Promise.all([
    draw('adaptive1', ...noise, '--threads', '1'),
    draw('adaptive2', ...noise, '--threads', '2'),
    draw('uniform'),
  ]);
  expect(one.equals(two)).toBe(true);
  const counts = (file: Buffer) =>
    readExr(new Uint8Array(file), 'exr').channels.find((c) => c.name === 'sample_count')!;
  const found = new Set(counts(one).data);
  expect(found.size).toBeGreaterThan(2);
  expect(Math.min(...found)).toBe(4);
  expect(Math.max(...found)).toBeLessThanOrEqual(36);
  expect(new Set(counts(all).data)).toEqual(new Set([36]));
});

test('denoised pictures have the same bits by any number of threads, and other noise; the grid is refused', async () => {
  const draw = async (name: string, ...flags: string[]): Promise<Float32Array> => {
    const file = out(name);
    const how = [...size, ...flight, '--pipeline', 'reference', '--samples', '1'];
    const { code, err } = await slowlight('render', movers, '-o', file, ...how, ...flags);
    expect(code, err).toBe(0);
    const { channels } = readExr(new Uint8Array(readFileSync(file)), file);
    expect(channels.map(({ name }) => name).sort()).toEqual(['B', 'G', 'R']);
    return channels.find((channel) => channel.name === 'G')!.data as Float32Array;
  };
  const [one, two, noisy] = await Promise.all([
    draw('denoised1.exr', '--denoise', '--threads', '1'),
    draw('denoised2.exr', '--denoise', '--threads', '2'),
    draw('noisy.exr'),
  ]);
  expect(one).toEqual(two);
  expect(one).not.toEqual(noisy);
  const sum = (values: Float32Array): number => values.reduce((all, value) => all + value, 0);
  expect(sum(one) / sum(noisy)).toBeCloseTo(1, 1);
  const grid = ['--pipeline', 'reference', '--samples', '1', '--denoise', '--grid'];
  const { code, err } = await slowlight('render', movers, '-o', out('grid.png'), ...size, ...grid);
  expect(code).not.toBe(0);
  expect(err).toMatch(/the grid would be denoised/);
});

test.each([
  [['--noise-threshold', '-0.1', '--pipeline', 'reference'], /--noise-threshold.*-0\.1.*number from 0 to 1/],
  [['--min-samples', '17', '--pipeline', 'reference'], /--min-samples.*17.*whole number, 1 to 16/],
  [['--noise-threshold', '0.1', '--pipeline', 'raster'], /--noise-threshold is for the reference renderer/],
  [['--aov', 'sample_count'], /--aov sample_count is for the reference renderer: add --pipeline reference/],
  [['--aov', 'sample_count', '--pipeline', 'raster'], /--aov sample_count: --pipeline raster gives beauty/],
])('refuses %j', async (flags, said) => {
  const { code, err } = await slowlight('render', movers, '-o', out('refused.exr'), ...size, ...flags);
  expect(code).toBe(2);
  expect(err).toMatch(said);
});

test.each([['--ghost', 'simultaneity'], ['--past-future']])('it has no %s', async (...flags) => {
  const { code, err } = await slowlight('render', movers, '-o', out('ghost.png'), ...size, ...reference, ...flags);
  expect(code).not.toBe(0);
  expect(err).toContain('a ghost, and past and future apart, are drawn by the rasterizer only');
  expect(existsSync(out('ghost.png'))).toBe(false);
});

test('without a GPU the reference renderer is the fallback, with a message; but not if a GPU was requested', async () => {
  const render = (name: string, ...flags: string[]): Promise<ProgramResult> =>
    without(noGpu, 'render', movers, '-o', out(name), '--size', '32x18', '--json', ...flags);
  const { code, err, out: json } = await render('fallback.png');
  expect(code, err).toBe(0);
  expect(err).toContain('no usable GPU, so the reference renderer draws');
  expect(err).toContain('apt-get install -y chromium');
  expect(JSON.parse(json)).toMatchObject({ pipeline: 'reference' });
  expect(existsSync(out('fallback.png'))).toBe(true);
  for (const flags of [
    ['--pipeline', 'raster'],
    ['--backend', 'webgpu'],
    ['--backend', 'webgl'],
    ['--solver', 'newton'],
  ]) {
    const refused = await render('refused.png', ...flags);
    expect(refused.code, flags.join(' ')).toBe(4);
    expect(refused.err).toContain('Without a GPU: --pipeline reference');
    expect(existsSync(out('refused.png'))).toBe(false);
  }
});

test('a film of the reference renderer has all frames', async () => {
  const file = out('film.mp4');
  const flags = ['--size', '32x18', ...reference, '--frames', '0:3', '--fps', '8'];
  const { code, err } = await slowlight('render', movers, '-o', file, ...flags);
  expect(code, err).toBe(0);
  const entries = ['-show_entries', 'stream=nb_frames,width', '-of', 'csv=p=0'];
  expect((await ask('ffprobe', '-v', 'error', ...entries, file)).trim()).toBe('32,4');
});

test('Ctrl-C stops rendering without a message and without partial files', async () => {
  const frames = ['--frames', '0:9999', '--fps', '100000'];
  const child = start('render', movers, '-o', out('frame.#.png'), '--size', '64x36', ...reference, ...frames);
  const ended = programResult(child);
  while (!existsSync(out('frame.0.png'))) await new Promise((resolve) => setTimeout(resolve, 20));
  child.kill('SIGINT');
  expect(await ended).toMatchObject({ code: 130, err: '' });
  const left = readdirSync(folder).filter((name) => name.includes('frame'));
  expect(left.filter((name) => !/^frame\.\d+\.png$/.test(name))).toEqual([]);
  expect(left.length).toBeLessThan(9999);
});

test('a thread that runs out of memory fails the picture with a remedy', async () => {
  const built = (path: string): string => fileURLToPath(new URL(`../../dist/lib/${path}`, import.meta.url));
  const { nodeThreads } = (await import(
    built('cli/pipelines/nodeThreads.js')
  )) as typeof import('../../src/cli/pipelines/nodeThreads.ts');
  const { openTracerPool } = (await import(
    built('pipelines/referenceSession.js')
  )) as typeof import('../../src/pipelines/referenceSession.ts');
  const limits = { maxOldGenerationSizeMb: 4, maxYoungGenerationSizeMb: 1 };
  const pool = openTracerPool(makeScene({ name: 'empty' }), 10, 2, nodeThreads(limits));
  const view: ViewPoint = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: [0, 0, 0, 1], lens: perspective(1) };
  const request: TileRequest = {
    view,
    settings: DEFAULT_SETTINGS,
    width: 8,
    height: 8,
    layers: ['depth'],
    samples: 1,
    seed: 0,
    light: DEFAULT_LIGHT,
  };
  const draw = (): Promise<void> => pool.render(request, [{ x0: 0, y0: 0, x1: 8, y1: 8 }], () => {});
  await expect(draw()).rejects.toThrow(/out of memory.*--threads/);
  await expect(draw()).rejects.toThrow(/out of memory/);
});
