import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { type ExrImage, readExr } from '../../src/formats/index.ts';
import { ask, outputFolder, programResult, scene, slowlight, slowlightJson, start, startIn } from './program.ts';

const folder = outputFolder();
const out = (name: string): string => join(folder, name);
const movers = scene('movers.usda');
const size = ['--size', '160x90'];

interface Rendered {
  readonly files: string[];
  readonly backend: string;
  readonly adapter: string;
  readonly objects: { id: number; path: string }[];
}
interface Probed {
  readonly seen: {
    readonly object: number;
    readonly distance: number;
    readonly time: number;
    readonly doppler: number;
  };
}

/** Properties of a picture or film by ffprobe. */
async function probed(file: string): Promise<Record<string, string>> {
  const entries = 'stream=codec_name,width,height,pix_fmt,nb_frames,r_frame_rate,color_space';
  const text = await ask('ffprobe', '-v', 'error', '-show_entries', entries, '-of', 'json', file);
  return (JSON.parse(text) as { streams: Record<string, string>[] }).streams[0];
}

/** Pixels as ffmpeg decodes them. */
async function rgb(file: string): Promise<Uint8Array> {
  const raw = `${file}.rgb`;
  const once = ['-fps_mode', 'passthrough'];
  await ask('ffmpeg', '-v', 'error', '-y', '-i', file, ...once, '-f', 'rawvideo', '-pix_fmt', 'rgb24', raw);
  return new Uint8Array(readFileSync(raw));
}

const channel = (image: ExrImage, name: string): Float32Array | Uint32Array => {
  const found = image.channels.find((candidate) => candidate.name === name);
  if (!found) throw new Error(`no channel ${name} among ${image.channels.map((c) => c.name).join(' ')}`);
  return found.data;
};

test('writes a PNG readable by another program, with the red cube in its middle and sky above', async () => {
  const file = out('still.png');
  const { files, objects } = await slowlightJson<Rendered>('render', movers, '-o', file, ...size, '--time', '1');
  expect(files).toEqual([file]);
  expect(objects[0]).toEqual({ id: 1, path: '/World/Still' });
  expect(await probed(file)).toMatchObject({ codec_name: 'png', width: 160, height: 90 });
  const pixels = await rgb(file);
  const at = (x: number, y: number) => pixels.subarray(3 * (y * 160 + x), 3 * (y * 160 + x) + 3);
  const [red, green, blue] = at(80, 45);
  expect(red).toBeGreaterThan(1.5 * green);
  expect(red).toBeGreaterThan(1.5 * blue);
  expect(at(80, 2)[2]).toBeGreaterThan(at(80, 2)[0]);
});

test('an EXR file has data channels that agree with the f64 library, and the names of the objects', async () => {
  const file = out('data.exr');
  const pose = ['--beta', '0,0,-0.5', '--time', '1'];
  const aovs = ['beauty', 'depth', 'emission_time', 'doppler', 'object'];
  const { code, err } = await slowlight(
    'render',
    movers,
    '-o',
    file,
    '--size',
    '101x101',
    ...pose,
    '--aov',
    aovs.join(),
  );
  expect(code, err).toBe(0);
  expect(await probed(file)).toMatchObject({ codec_name: 'exr', width: 101, height: 101 });
  const image = readExr(new Uint8Array(readFileSync(file)), file);
  const { seen } = await slowlightJson<Probed>('probe', movers, '--pixel', '50,50', '--size', '101x101', ...pose);
  const middle = 50 * 101 + 50;
  expect(channel(image, 'object')[middle]).toBe(seen.object);
  expect(channel(image, 'depth')[middle] / seen.distance).toBeCloseTo(1, 3);
  expect(channel(image, 'emission_time')[middle]).toBeCloseTo(seen.time, 2);
  expect(channel(image, 'emission_time_relative')[middle]).toBeCloseTo(seen.time - 1, 2);
  expect(channel(image, 'doppler')[middle] / seen.doppler).toBeCloseTo(1, 3);
  expect([channel(image, 'depth')[0], channel(image, 'object')[0]]).toEqual([0, 0]);
  expect(JSON.parse(image.attributes?.objects ?? '{}')).toMatchObject({ 1: '/World/Still', 3: '/World/Rising' });
});

test('writes a film with all frames, and no other file', async () => {
  const file = out('film.mp4');
  const { code, err } = await slowlight('render', movers, '-o', file, ...size, '--frames', '0:5', '--fps', '12');
  expect(code, err).toBe(0);
  expect(await probed(file)).toMatchObject({
    codec_name: 'h264',
    width: 160,
    height: 90,
    pix_fmt: 'yuv420p',
    nb_frames: '6',
    r_frame_rate: '12/1',
  });
  expect(readdirSync(folder).filter((name) => name.includes('partial'))).toEqual([]);
});

test('writes a GIF of the same pictures, with durations that add up', async () => {
  const [film, still] = [out('film.gif'), out('of-gif.png')];
  // So small, rays take less time than the other pipeline's shaders take to compile without a GPU.
  const at = ['--fps', '12', '--size', '64x36', '--pipeline', 'reference', '--samples', '1'];
  const { files } = await slowlightJson<Rendered>('render', movers, '-o', film, '--frames', '3:8', ...at);
  expect(files).toEqual([film]);
  expect(await probed(film)).toMatchObject({ codec_name: 'gif', width: 64, height: 36 });
  const durations = await ask(
    'ffprobe',
    '-v',
    'error',
    '-show_entries',
    'packet=duration_time',
    '-of',
    'csv=p=0',
    film,
  );
  expect(durations.trim().split('\n').map(Number)).toEqual([0.08, 0.09, 0.08, 0.08, 0.09, 0.08]);
  await slowlight('render', movers, '-o', still, '--frames', '8:8', ...at);
  const [all, last] = [await rgb(film), await rgb(still)];
  expect(all).toHaveLength(6 * last.length);
  const errors = last.map((value, i) => Math.abs(value - all[5 * last.length + i]!));
  expect(errors.reduce((a, b) => a + b, 0) / errors.length).toBeLessThan(3);
  expect(readdirSync(folder).filter((name) => name.includes('partial'))).toEqual([]);
});

test('numbered frames have different times', async () => {
  const frames = ['--frames', '4:6', '--fps', '2', '--size', '64x36', '--pipeline', 'reference', '--samples', '1'];
  const { files } = await slowlightJson<Rendered>('render', movers, '-o', out('f.##.png'), ...frames);
  expect(files.map((file) => file.slice(-6))).toEqual(['04.png', '05.png', '06.png']);
  const [first, second] = [await rgb(files[0]), await rgb(files[1])];
  expect(Buffer.compare(first, second)).not.toBe(0);
});

test('without ffmpeg a film is rejected with the command that installs it', async () => {
  const env = { ...process.env, PATH: folder };
  const { code, err } = await programResult(
    startIn(env, 'render', movers, '-o', out('none.mp4'), ...size, '--frames', '0:2'),
  );
  expect(code).toBe(4);
  expect(err).toContain('apt-get install -y ffmpeg');
  expect(existsSync(out('none.mp4'))).toBe(false);
});

test('Ctrl-C leaves no partial file and no encoder process', async () => {
  const file = out('long.mp4');
  const child = start('render', movers, '-o', file, ...size, '--frames', '0:100000');
  const ended = programResult(child);
  const begun = (): boolean => readdirSync(folder).some((name) => name.startsWith('.long.mp4'));
  while (!begun()) await new Promise((resolve) => setTimeout(resolve, 50));
  child.kill('SIGINT');
  expect((await ended).code).toBe(130);
  expect(begun()).toBe(false);
  expect(existsSync(file)).toBe(false);
});

/**
 * The same shaders on two rasterizers: SwiftShader and llvmpipe differ by rounding in shading, and by a pixel's
 * coverage along edges.
 */
test('WebGPU and WebGL2 make the same picture', async () => {
  const flags = ['--time', '1', '--beta', '0.3,0,-0.6', '--size', '320x180'];
  const made = await Promise.all(
    ['webgpu', 'webgl'].map((backend) =>
      slowlightJson<Rendered>('render', movers, '-o', out(`${backend}.png`), ...flags, '--backend', backend),
    ),
  );
  expect(made.map(({ backend }) => backend)).toEqual(['webgpu', 'webgl']);
  const [a, b] = await Promise.all([rgb(out('webgpu.png')), rgb(out('webgl.png'))]);
  const differences = a.map((value, i) => Math.abs(value - b[i]));
  const beyond = (limit: number): number => differences.filter((d) => d > limit).length / differences.length;
  expect(beyond(2)).toBeLessThan(0.005);
  expect(beyond(24)).toBeLessThan(0.001);
});
