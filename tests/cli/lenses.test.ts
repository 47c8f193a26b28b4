import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { readExr } from '../../src/formats/index.ts';
import { sphericalOf } from '../../src/formats/spherical/sphericalOf.ts';
import { ask, outputFolder, programResult, scene, slowlight, slowlightJson, start } from './program.ts';

const folder = outputFolder();
const out = (name: string): string => join(folder, name);
const movers = scene('movers.usda');
const MOVING = ['--time', '1', '--beta', '0.2,0.1,-0.6', '--c', '10', '--exposure', '0', '--metering', 'manual'];

const drawn = async (name: string, ...flags: readonly string[]): Promise<string> => {
  await slowlight('render', movers, '-o', out(name), ...MOVING, ...flags);
  return out(name);
};

async function rgb(file: string): Promise<Uint8Array> {
  await ask('ffmpeg', '-v', 'error', '-y', '-i', file, '-f', 'rawvideo', '-pix_fmt', 'rgb24', `${file}.rgb`);
  return new Uint8Array(readFileSync(`${file}.rgb`));
}

/** Mean difference of two pictures [8-bit steps], where both show something. */
async function difference(a: string, b: string): Promise<number> {
  const [p, q] = [await rgb(a), await rgb(b)];
  expect(p.length).toBe(q.length);
  let [sum, count] = [0, 0];
  for (let i = 0; i < p.length; i += 3) {
    if (p[i]! + p[i + 1]! + p[i + 2]! === 0 || q[i]! + q[i + 1]! + q[i + 2]! === 0) continue;
    for (let k = 0; k < 3; k++) sum += Math.abs(p[i + k]! - q[i + k]!);
    count += 3;
  }
  expect(count).toBeGreaterThan(p.length / 2);
  return sum / count;
}

test('pictures of all lenses are those that ffmpeg makes of one of them', async () => {
  const around = await drawn('around.png', '--lens', 'equirectangular', '--size', '256x128', '--samples', '2');
  expect(new Set(await rgb(around)).size).toBeGreaterThan(100);
  const cases = [
    ['cube.png', '288x192', 'c3x2:e:w=256:h=128', '--lens', 'cube'],
    ['strip.png', '576x96', 'c6x1:e:w=256:h=128', '--lens', 'cube-strip'],
  ] as const;
  for (const [name, size, filter, ...lens] of cases) {
    const picture = await drawn(name, ...lens, '--size', size, '--samples', '2');
    const converted = out(`around-${name}`);
    await ask('ffmpeg', '-v', 'error', '-y', '-i', picture, '-vf', `v360=${filter}`, converted);
    expect(await difference(converted, around)).toBeLessThan(3);
  }
  // `fisheye` of v360 is the equidistant one; a dome has its middle 90° up.
  for (const [name, pitch, ...lens] of [
    ['fisheye.png', 0, '--lens', 'fisheye'],
    ['dome.png', 60, '--lens', 'dome', '--dome-tilt', '30'],
  ] as const) {
    const picture = await drawn(name, ...lens, '--size', '128x128', '--samples', '2');
    const converted = out(`of-${name}`);
    const filter = `v360=e:fisheye:h_fov=180:v_fov=180:pitch=${pitch}:w=128:h=128`;
    await ask('ffmpeg', '-v', 'error', '-y', '-i', around, '-vf', filter, converted);
    expect(await difference(converted, picture)).toBeLessThan(3);
  }
});

test('both backends and the reference draw the same', async () => {
  const flags = ['--lens', 'dome', '--aperture', '220', '--size', '80x80', '--samples', '3', '--occlusion-radius', '0'];
  const here = await drawn('webgpu.png', ...flags);
  expect(await difference(here, await drawn('webgl.png', ...flags, '--backend', 'webgl'))).toBeLessThan(0.5);
  const plain = flags.slice(0, -2);
  expect(await difference(here, await drawn('truth.png', ...plain, '--pipeline', 'reference'))).toBeLessThan(4);
});

test('the eyes of a stereo picture see what stands beside, in both renderers; a vantage is for both, too', async () => {
  const stereo = ['--lens', 'stereo', '--eye-separation', '0.5', '--size', '96x96'];
  const here = await drawn('eyes.png', ...stereo, '--samples', '3', '--occlusion-radius', '0');
  const truth = await drawn('eyes-truth.png', ...stereo, '--samples', '3', '--pipeline', 'reference');
  expect(await difference(here, truth)).toBeLessThan(4);
  const aside = ['--vantage', '0.5,1,0.3', '--size', '96x64', '--samples', '3'];
  const raster = await drawn('aside.png', ...aside, '--occlusion-radius', '0');
  expect(await difference(raster, await drawn('aside-truth.png', ...aside, '--pipeline', 'reference'))).toBeLessThan(5);
});

test('files say that they are 360° pictures: PNG, EXR with data channels, MP4', async () => {
  const of = async (file: string) => {
    const bytes = readFileSync(file);
    return sphericalOf({ size: bytes.length, read: async (from, to) => bytes.subarray(from, to) }, file);
  };
  const lens = ['--lens', 'equirectangular', '--size', '64x32', '--samples', '1'];
  const png = await drawn('marked.png', ...lens);
  expect(await of(png)).toMatchObject({ projection: 'equirectangular', stereo: 'none' });
  const exr = await drawn('marked.exr', ...lens, '--aov', 'beauty,depth,object');
  expect(readExr(readFileSync(exr), exr)).toMatchObject({ width: 64, height: 32, envmap: 'latlong' });
  expect(await of(exr)).toMatchObject({ projection: 'equirectangular' });
  await slowlight('render', movers, '-o', out('film.mp4'), ...lens, '--frames', '0:2', '--fps', '24');
  const asked = ['-v', 'error', '-show_entries', 'stream_side_data=projection:stream=nb_frames', '-of', 'csv=p=0'];
  expect(await ask('ffprobe', ...asked, out('film.mp4'))).toMatch(/3[\s\S]*equirectangular/);
  const both = ['--lens', 'stereo', '--size', '64x64', '--samples', '1'];
  expect(await of(await drawn('both.png', ...both))).toMatchObject({
    projection: 'equirectangular',
    stereo: 'top-bottom',
  });
  await slowlight('render', movers, '-o', out('both.mp4'), ...both, '--frames', '0:2', '--fps', '24');
  const sides = ['-v', 'error', '-show_entries', 'stream_side_data=type,projection', '-of', 'csv=p=0'];
  expect(await ask('ffprobe', ...sides, out('both.mp4'))).toMatch(/top and bottom[\s\S]*equirectangular/);
  expect(await of(await drawn('legend.png', ...lens, '--false-colour', 'doppler', '--legend'))).toBeUndefined();
  expect(await of(await drawn('dome-only.png', '--lens', 'dome', '--size', '32x32', '--samples', '1'))).toBeUndefined();
});

test('a lens has a size of its own, and what does not fit it is refused', async () => {
  const report = await slowlightJson<{ width: number; height: number }>(
    ...['render', movers, '-o', out('own.png'), '--lens', 'cube-strip', '--samples', '1', '--metering', 'manual'],
  );
  expect(report).toMatchObject({ width: 3072, height: 512 });
  const refused = async (...flags: readonly string[]) =>
    (await programResult(start('render', movers, '-o', out('none.png'), ...flags))).err;
  expect(await refused('--lens', 'equirectangular', '--size', '100x60')).toContain('take 100 × 50');
  expect(await refused('--lens', 'cube', '--size', '1000x700')).toContain('take 999 × 666');
  expect(await refused('--lens', 'dome', '--fov', '60')).toContain('--fov');
  expect(await refused('--aperture', '90')).toContain('--aperture');
  expect(await refused('--lens', 'fisheye', '--dome-tilt', '9')).toContain('--dome-tilt');
  expect(await refused('--lens', 'dome', '--aperture', '0')).toContain('360');
  expect(await refused('--lens', 'stereo', '--size', '100x90')).toContain('take 90 × 90');
  expect(await refused('--lens', 'dome', '--eye-separation', '1')).toContain('--lens stereo');
});
