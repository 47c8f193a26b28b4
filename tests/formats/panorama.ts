import { expect } from 'vitest';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import { writeExr } from '../../src/formats/image/exr.ts';
import { withPngText } from '../../src/formats/image/pngText.ts';
import { panoramaXmp } from '../../src/formats/spherical/panorama.ts';
import { withSphericalPng } from '../../src/formats/spherical/sphericalPictures.ts';
import { withPngXmp } from '../../src/formats/spherical/xmpPackets.ts';
import { isDomeLight } from '../../src/scene/lights/lightKinds.ts';
import type { Scene } from '../../src/scene/types.ts';
import type { SphericalPicture } from '../../src/scene/view/sphericalPicture.ts';
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

export const panoramaGroups: readonly ClaimGroup[] = [pictures];
