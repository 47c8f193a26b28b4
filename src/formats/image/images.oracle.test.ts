import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { decodeImage } from './decodeImage.ts';
import { encodePng } from './encodePng.ts';
import { type ExrChannel, writeExr } from './exr.ts';

/** Our pictures, read by independent programs: OpenEXR (PyPI) and ffmpeg. */

const folder = mkdtempSync(join(tmpdir(), 'slowlight-exr-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const python = process.env.SLOWLIGHT_PYTHON ?? 'python3';
const hasOpenExr = spawnSync(python, ['-c', 'import OpenEXR, numpy']).status === 0;
const ffmpeg = 'ffmpeg';
const hasFfmpeg = spawnSync(ffmpeg, ['-version']).status === 0;
if (!hasOpenExr)
  console.warn('skipped: EXR against OpenEXR; pip install OpenEXR, or name a Python with it in SLOWLIGHT_PYTHON');
if (!hasFfmpeg) console.warn('skipped: EXR and PNG against ffmpeg, which is not installed');

const width = 33;
const height = 41;
const at = (i: number): [number, number] => [i % width, Math.floor(i / width)];
const float = (f: (x: number, y: number) => number): Float32Array =>
  Float32Array.from({ length: width * height }, (_, i) => f(...at(i)));
const channels: readonly ExrChannel[] = [
  { name: 'R', type: 'float', data: float((x, y) => x + y / 64) },
  { name: 'G', type: 'float', data: float((x) => Math.sin(x)) },
  { name: 'B', type: 'float', data: float((_, y) => -y) },
  { name: 'position.x', type: 'float', data: float((x, y) => x + 1e4 * y) },
  { name: 'doppler', type: 'half', data: float((x, y) => (x - y) / 8) },
  { name: 'object', type: 'uint', data: Uint32Array.from({ length: width * height }, (_, i) => i * 3_000_000) },
];
const names = '["/World/Cube","/World/方块"]';

const dump = `
import sys, json, OpenEXR
with OpenEXR.File(sys.argv[1], separate_channels=True) as f:
    h = f.header()
    c = {k: [str(v.pixels.dtype), v.pixels.astype('float64').ravel().tolist()] for k, v in f.channels().items()}
    print(json.dumps({'objects': h['objects'], 'compression': str(h['compression']), 'channels': c}))
`;

describe.skipIf(!hasOpenExr)('OpenEXR reads what we write', () => {
  it('with every value, type, name and text', () => {
    const path = join(folder, 'a.exr');
    writeFileSync(path, writeExr({ width, height, channels, attributes: { objects: names } }));
    const run = spawnSync(python, ['-c', dump, path], { encoding: 'utf8', maxBuffer: 1 << 26 });
    expect(run.stderr).toBe('');
    const read = JSON.parse(run.stdout);
    expect(read.objects).toBe(names);
    expect(read.compression).toContain('ZIP');
    const dtype = { float: 'float32', half: 'float16', uint: 'uint32' };
    expect(Object.keys(read.channels).sort()).toEqual(channels.map((c) => c.name).sort());
    for (const { name, type, data } of channels) expect(read.channels[name]).toEqual([dtype[type], [...data]]);
  });
});

describe.skipIf(!hasFfmpeg)('ffmpeg reads what we write', () => {
  const rawPixels = (path: string, format: string): Buffer =>
    spawnSync(ffmpeg, ['-v', 'error', '-i', path, '-f', 'rawvideo', '-pix_fmt', format, '-'], { maxBuffer: 1 << 26 })
      .stdout;

  it('EXR: R, G and B to the bit', () => {
    const path = join(folder, 'b.exr');
    writeFileSync(path, writeExr({ width, height, channels: channels.slice(0, 3) }));
    const raw = rawPixels(path, 'gbrpf32le');
    const values = new Float32Array(Uint8Array.from(raw).buffer);
    const plane = width * height;
    for (const [i, name] of ['G', 'B', 'R'].entries()) {
      expect(values.slice(i * plane, (i + 1) * plane)).toEqual(channels.find((c) => c.name === name)?.data);
    }
  });

  it('PNG: every byte', () => {
    const path = join(folder, 'a.png');
    const rgba = Uint8Array.from({ length: width * height * 4 }, (_, i) => (i * 37 + (i >> 5)) & 255);
    writeFileSync(path, encodePng(width, height, rgba));
    expect(Uint8Array.from(rawPixels(path, 'rgba'))).toEqual(rgba);
  });

  it.each(['none', 'sub', 'up', 'avg', 'paeth', 'mixed'])('and we read its PNG with row filter %s', (filter) => {
    const path = join(folder, `${filter}.png`);
    const input = ['-v', 'error', '-y', '-f', 'lavfi', '-i', 'testsrc=size=61x47:duration=1:rate=1'];
    spawnSync(ffmpeg, [...input, '-frames:v', '1', '-pred', filter, path]);
    const { data } = decodeImage(readFileSync(path), path);
    expect(data).toEqual(Uint8Array.from(rawPixels(path, 'rgba')));
  });
});
