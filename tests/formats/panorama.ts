import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect } from 'vitest';
import { openFfmpegFrames } from '../../src/cli/files/ffmpegFrames.ts';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import { writeExr } from '../../src/formats/image/exr.ts';
import { withPngText } from '../../src/formats/image/pngText.ts';
import { panoramaXmp } from '../../src/formats/spherical/panorama.ts';
import { withSphericalMp4 } from '../../src/formats/spherical/sphericalMp4.ts';
import { withSphericalPng } from '../../src/formats/spherical/sphericalPictures.ts';
import { withPngXmp } from '../../src/formats/spherical/xmpPackets.ts';
import { isDomeLight } from '../../src/scene/lights/lightKinds.ts';
import type { Scene } from '../../src/scene/types.ts';
import type { SphericalPicture } from '../../src/scene/view/sphericalPicture.ts';
import { type ColorFilm, makeTestFilm } from '../support/testFilm.ts';
import { approximated, type ClaimGroup, type Files, read, refused } from './claim.ts';

/** Of one grey, or with `noise` of another one at every pixel. */
const picture = (width: number, height: number, noise = false): Uint8Array =>
  encodePng(
    width,
    height,
    Uint8Array.from({ length: 4 * width * height }, (_, i) => {
      if (i % 4 === 3) return 255;
      return noise ? ((i >> 2) * 7919) % 251 : 128;
    }),
  );
const png = (width: number, height: number): Files => ({ 'a.png': picture(width, height) });
const EXR = writeExr({
  width: 4,
  height: 2,
  channels: ['R', 'G', 'B'].map((name) => ({ name, type: 'half', data: new Float32Array(8).fill(500) })),
});
const HDR = Uint8Array.from([
  ...new TextEncoder().encode('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n'),
  ...[128, 64, 0, 129, 128, 64, 0, 129],
]);
const faces = (names: readonly string[]): Files =>
  Object.fromEntries(names.map((name) => [`${name}.png`, picture(4, 4)]));

const AROUND: SphericalPicture = { projection: 'equirectangular', stereo: 'none' };
const marked = (width: number, height: number, coverage: SphericalPicture): Files => ({
  'a.png': withSphericalPng(picture(width, height), coverage),
});

const size = (width: number, height: number) => (scene: Scene) =>
  expect(scene.lights.find(isDomeLight)?.texture).toMatchObject({ width, height });

const pictures: ClaimGroup = {
  title: 'Pictures of all directions',
  rows: [
    read(
      'twice as wide as high (to 1 %), as PNG, JPEG, WebP or AVIF',
      'surroundings at infinity by latitude and longitude: its middle is ahead of the camera (−Z), its upper edge the zenith',
      png(8, 4),
      size(8, 4),
    ),
    read(
      'the same as Radiance (`.hdr`) or OpenEXR',
      'radiance with the values of the file',
      [{ 'a.exr': EXR }, { 'a.hdr': HDR }],
      (scene) => expect(scene.lights.find(isDomeLight)?.texture?.data).toBeInstanceOf(Uint16Array),
    ),
    read(
      'six faces of a cube in a strip, 6:1 or 1:6, or in a grid, 3:2: right, left, up, down, front, back',
      'the same, resampled: four times as wide as a face, 8192 at most',
      [png(24, 4), png(4, 24), png(12, 8)],
      size(16, 8),
    ),
    read(
      'a cube unfolded to a cross, 4:3, or 3:4 with the back upside down at its foot; corners of one colour',
      'the same',
      [png(16, 12), png(12, 16)],
      size(16, 8),
    ),
    read(
      'six files named `px nx py ny pz nz`, `posx negx …`, `+x -x …`, `right left top bottom front back`, `right left up down front back` or `rt lf up dn ft bk`, behind anything that ends with `_`, `-`, `.` or a space; one of them is opened',
      'the same',
      [
        faces(['px', 'nx', 'py', 'ny', 'pz', 'nz']),
        faces(['a_back', 'a_front', 'a_left', 'a_right', 'a_top', 'a_bottom']),
      ],
      size(16, 8),
    ),
    approximated(
      'a picture for each eye, above each other or beside, by its mark (`GSpherical:StereoMode`, as of `--lens stereo`)',
      'the left eye’s',
      'panorama.stereo',
      [marked(8, 8, { ...AROUND, stereo: 'top-bottom' }), marked(16, 4, { ...AROUND, stereo: 'left-right' })],
      size(8, 4),
    ),
    read(
      'a dome master or fisheye of this program, PNG or EXR, by its header',
      'the directions around its axis, black beyond its circle; 8192 wide at most',
      { 'a.png': withPngText(picture(8, 8), { lens: 'fisheye of 180 degrees, its axis 90 degrees up' }) },
      size(16, 8),
    ),
    read(
      'a circle in the middle of a picture of any shape, where the node *Panorama* says that it is a fisheye or a dome master',
      'the same',
      { 'a.png': picture(12, 8) },
      size(16, 8),
      { options: { fisheye: { kind: 'fisheye', aperture: Math.PI, elevation: 0 } } },
    ),
    approximated(
      'a part of the sphere, by its mark (GPano), as of telephones',
      'the whole, black where nothing is known',
      'panorama.part',
      marked(8, 3, { ...AROUND, crop: { left: 0.25, right: 0.25, top: 0.125, bottom: 0.5 } }),
      size(16, 8),
    ),
    approximated(
      'a mark that is not read',
      'the picture by its shape',
      'panorama.mark',
      {
        'a.png': withPngXmp(
          picture(8, 4),
          panoramaXmp(AROUND, { width: 8, height: 4 }).replace('equirectangular', 'cylindrical'),
        ),
      },
      size(8, 4),
    ),
    approximated(
      'a picture of 3:2 whose parts do not fit together at the edges of a cube',
      'taken for a grid of faces all the same',
      'panorama.edges',
      { 'a.png': picture(96, 64, true) },
    ),
    refused(
      'a picture of another aspect ratio, such as a photograph',
      'with the sizes that are read',
      'panorama.size',
      {
        'a.png': picture(32, 24, true),
      },
    ),
    refused(
      'one face whose others are missing or of another size',
      'with their names',
      'panorama.faces',
      faces(['px', 'nx']),
    ),
  ],
};

const FILM = { colors: ['red', 'lime'], seconds: 0.4, rate: 5, width: 64, height: 32 } as const;
const DECODED = { options: { openFilm: openFfmpegFrames } };

/** A film of ffmpeg's. */
const film =
  (name: string, change: Partial<ColorFilm> = {}): (() => Promise<Files>) =>
  async () => {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-claim-'));
    try {
      return { [name]: Uint8Array.from(makeTestFilm(folder, name, { ...FILM, ...change })) };
    } finally {
      rmSync(folder, { recursive: true });
    }
  };

const BOTH_EYES: SphericalPicture = { projection: 'equirectangular', stereo: 'top-bottom' };
const stereoFilm = async (): Promise<Files> => {
  const files = await film('a.mp4', { height: 64 })();
  return { 'a.mp4': await withSphericalMp4(files['a.mp4'] as Uint8Array, 'a.mp4', BOTH_EYES) };
};

const HDR_COLORS = ['-color_primaries', 'bt2020', '-color_trc', 'smpte2084', '-colorspace', 'bt2020nc'];

const isFilm = (frames: number) => (scene: Scene) => {
  expect(scene.lights.find(isDomeLight)?.film?.track.times).toHaveLength(frames);
  expect([scene.startTime, scene.endTime]).toEqual([0, expect.closeTo(frames / 5, 3)]);
};

const films: ClaimGroup = {
  title: 'Films of all directions',
  rows: [
    read(
      'MP4 and QuickTime (`.mp4`, `.m4v`, `.mov`), WebM and Matroska (`.webm`, `.mkv`), in the forms of pictures above; any rate, also an uneven one; edit lists',
      'surroundings at infinity whose first picture is in the origin at 0 s; world time ends with it',
      [film('a.mp4'), film('a.mov'), film('a.mkv'), film('a.webm', { how: ['-c:v', 'libvpx-vp9', '-b:v', '200k'] })],
      isFilm(4),
      DECODED,
    ),
    approximated(
      'a film for two eyes, by its mark (Spherical Video V1 and V2, in MP4 and QuickTime)',
      'the left one’s',
      'panorama.stereo',
      stereoFilm,
      isFilm(4),
      DECODED.options,
    ),
    refused(
      'another aspect ratio, such as 16:9',
      'with the sizes that are read',
      'panorama.size',
      film('a.mp4', { width: 64, height: 36 }),
      DECODED.options,
    ),
    refused(
      'high dynamic range (PQ, HLG)',
      'to be converted to BT.709',
      'film.hdr',
      film('a.mp4', { how: HDR_COLORS }),
      DECODED.options,
    ),
    refused('another container', 'to be converted', 'film.unreadable', { 'a.mp4': 'no film' }, DECODED.options),
    refused('sound without pictures', 'as it is', 'film.empty', film('a.mp4', { colors: [] }), DECODED.options),
    refused(
      'a codec that is not decoded: the page has its browser’s, the command line ffmpeg’s. Code gives a decoder (`openFilm`)',
      'with the decoder’s words',
      'film.undecodable',
      film('a.mp4'),
    ),
  ],
};

export const panoramaGroups: readonly ClaimGroup[] = [pictures, films];
