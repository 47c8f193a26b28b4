import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { writeExr } from '../image/exr.ts';
import { readExr } from '../image/readExr.ts';
import { memoryFile } from '../zip/zipSource.ts';
import { withSphericalMp4 } from './sphericalMp4.ts';
import { sphericalOf } from './sphericalOf.ts';
import { sphericalExr } from './sphericalPictures.ts';

/** Films of ffmpeg, marked, and read back by it; and EXRs, read and made by OpenEXR (PyPI). */

const folder = mkdtempSync(join(tmpdir(), 'slowlight-spherical-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const python = process.env.SLOWLIGHT_PYTHON ?? 'python3';
const hasOpenExr = spawnSync(python, ['-c', 'import OpenEXR, numpy']).status === 0;
const hasFfmpeg = [['ffmpeg'], ['ffprobe']].every(([name]) => spawnSync(name, ['-version']).status === 0);
if (!hasOpenExr) console.warn('skipped: envmap against OpenEXR, which is not installed');
if (!hasFfmpeg) console.warn('skipped: spherical films against ffmpeg, which is not installed');

const run = (program: string, ...args: readonly string[]): string =>
  execFileSync(program, args, { encoding: 'utf8', maxBuffer: 2 ** 26 });

const PICTURES = ['-f', 'lavfi', '-i', 'testsrc=size=128x64:rate=12:duration=2'];
const TONE = ['-f', 'lavfi', '-i', 'sine=duration=2', '-c:a', 'aac'];
const H264 = ['-c:v', 'libx264', '-pix_fmt', 'yuv420p'];

function filmOf(name: string, ...flags: readonly string[]): string {
  const path = join(folder, name);
  run('ffmpeg', '-v', 'error', '-y', ...PICTURES, ...TONE, ...H264, ...flags, path);
  return path;
}

/** What ffprobe says of the first video stream beside its frames. */
function sideData(path: string): Record<string, unknown>[] {
  const told = JSON.parse(run('ffprobe', '-v', 'error', '-print_format', 'json', '-show_streams', path));
  const stream = told.streams.find((each: { codec_type: string }) => each.codec_type === 'video');
  return stream.side_data_list ?? [];
}

/** A checksum of each decoded frame and each stretch of sound. */
const frames = (path: string): string => run('ffmpeg', '-v', 'error', '-i', path, '-f', 'framemd5', '-');

async function mark(path: string, picture: SphericalPicture): Promise<string> {
  const marked = join(folder, `marked-${path.split('/').at(-1)}`);
  writeFileSync(marked, await withSphericalMp4(readFileSync(path), path, picture));
  return marked;
}

const MAPPING = { side_data_type: 'Spherical Mapping', yaw: 0, pitch: 0, roll: 0 };
const EQUIRECTANGULAR = { ...MAPPING, projection: 'equirectangular' };
const TOP_BOTTOM = { side_data_type: 'Stereo 3D', type: 'top and bottom', inverted: 0 };

describe.skipIf(!hasFfmpeg)('ffmpeg', () => {
  const LAYOUTS: readonly (readonly [string, readonly string[]])[] = [
    ['moov at the end', []],
    ['moov before the media', ['-movflags', '+faststart']],
  ];
  const CASES: readonly (readonly [SphericalPicture, readonly Record<string, unknown>[]])[] = [
    [{ projection: 'equirectangular', stereo: 'none' }, [EQUIRECTANGULAR]],
    [{ projection: 'equirectangular', stereo: 'top-bottom' }, [TOP_BOTTOM, EQUIRECTANGULAR]],
    [{ projection: 'cubemap', stereo: 'none' }, [{ ...MAPPING, projection: 'cubemap', padding: 0 }]],
  ];

  describe.each(LAYOUTS)('with %s', (layout, flags) => {
    it('recognises a marked film, and decodes the same frames and sound', async () => {
      const path = filmOf(`${layout}.mp4`, ...flags);
      expect(sideData(path)).toEqual([]);
      const before = frames(path);
      expect(before.match(/^0, /gm)).toHaveLength(24);
      for (const [picture, told] of CASES) {
        const marked = await mark(path, picture);
        expect(sideData(marked)).toEqual(told);
        expect(frames(marked)).toBe(before);
      }
    });
  });

  it.each([
    ['V2', 'uuid'],
    ['V1', 'sv3d'],
  ])('recognises a film by %s alone', async (_, other) => {
    const path = await mark(filmOf('both.mp4'), { projection: 'equirectangular', stereo: 'top-bottom' });
    const bytes = readFileSync(path);
    bytes.write('free', bytes.indexOf(other), 'latin1');
    writeFileSync(path, bytes);
    expect(sideData(path)).toEqual([TOP_BOTTOM, EQUIRECTANGULAR]);
  });

  it('and we agree on a film that shows the middle of the sphere', async () => {
    const crop = { left: 0.25, right: 0.25, top: 0.125, bottom: 0.125 };
    const picture: SphericalPicture = { projection: 'equirectangular', stereo: 'none', crop };
    const [mapping] = sideData(await mark(filmOf('part.mp4'), picture));
    expect(mapping.projection).toBe('tiled equirectangular');
    // In pixels of the full sphere, 256 × 85.33, rounded by it.
    const bounds = { bound_left: 64, bound_right: 64, bound_top: 32 / 3, bound_bottom: 32 / 3 };
    for (const [name, value] of Object.entries(bounds))
      expect(Math.abs(Number(mapping[name]) - value), name).toBeLessThan(1.5);
  });

  it('keeps marks that it copies, which we read', async () => {
    for (const [picture] of CASES) {
      const marked = await mark(filmOf('copied.mp4'), picture);
      const copy = join(folder, 'copy.mp4');
      run('ffmpeg', '-v', 'error', '-y', '-i', marked, '-c', 'copy', '-strict', 'unofficial', copy);
      expect(await sphericalOf(memoryFile(readFileSync(copy)), copy)).toEqual(picture);
    }
  });

  it('makes fragmented films, which are refused', async () => {
    const path = filmOf('fragments.mp4', '-movflags', '+frag_keyframe+empty_moov');
    await expect(mark(path, { projection: 'cubemap', stereo: 'none' })).rejects.toThrow('the film is fragmented');
  });
});

describe.skipIf(!hasOpenExr)('OpenEXR', () => {
  const size = { width: 8, height: 4 };
  const channels = [{ name: 'Y', type: 'float' as const, data: new Float32Array(32) }];
  const FULL: SphericalPicture = { projection: 'equirectangular', stereo: 'none' };

  it('reads our envmap and XMP', () => {
    const path = join(folder, 'ours.exr');
    const told = sphericalExr(FULL, size);
    writeFileSync(path, writeExr({ ...size, channels, ...told }));
    const script = `
import sys, json, OpenEXR
with OpenEXR.File(sys.argv[1]) as f:
    h = f.header()
    print(json.dumps([str(h['envmap']), h['xmp']]))
`;
    const [envmap, xmp] = JSON.parse(run(python, '-c', script, path));
    expect(envmap).toContain('LATLONG');
    expect(xmp).toBe(told.attributes.xmp);
  });

  it('makes environment maps, which we read', async () => {
    const script = `
import sys, numpy, OpenEXR
pixels = {'Y': numpy.zeros((4, 8), dtype='float32')}
header = {'compression': OpenEXR.ZIP_COMPRESSION, 'type': OpenEXR.scanlineimage, 'envmap': OpenEXR.ENVMAP_LATLONG}
OpenEXR.File(header, pixels).write(sys.argv[1])
`;
    const path = join(folder, 'theirs.exr');
    run(python, '-c', script, path);
    const bytes = readFileSync(path);
    expect(readExr(bytes, path).envmap).toBe('latlong');
    expect(await sphericalOf(memoryFile(bytes), path)).toEqual(FULL);
  });
});
