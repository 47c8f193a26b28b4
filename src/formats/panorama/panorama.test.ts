import { describe, expect, it } from 'vitest';
import { degrees } from '../../math/angle.ts';
import { fromHalf } from '../../math/half.ts';
import { dot, normalize, type Vec3 } from '../../math/vec3.ts';
import { domeAxes, latLongFromDirection } from '../../scene/lights/latLong.ts';
import { isDomeLight } from '../../scene/lights/lightKinds.ts';
import { sampleTexture } from '../../scene/materials/sampleTexture.ts';
import type { Scene } from '../../scene/types.ts';
import { domeLens } from '../../scene/view/lenses/fisheyeLens.ts';
import { lensDirection } from '../../scene/view/lenses/lenses.ts';
import { entryOf } from '../entry.ts';
import { memorySource } from '../files/fileSource.ts';
import { decodeImage } from '../image/decodeImage.ts';
import { encodePng } from '../image/encodePng.ts';
import { writeExr } from '../image/exr.ts';
import { withPngText } from '../image/pngText.ts';
import { openScene } from '../open.ts';
import { withSphericalPng } from '../spherical/sphericalPictures.ts';
import { faceFiles } from './faceFiles.ts';

/** Linear light 0 … 1 that is different in every direction of the world: a camera looks at it towards −Z at first. */
const light = ([x, y, z]: Vec3): Vec3 => [0.5 + 0.4 * x, 0.5 + 0.4 * y, 0.5 + 0.4 * z];

const encoded = (linear: number): number =>
  Math.round(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055));

/** A picture by a function of its pixels; those without a direction are black. */
function png(width: number, height: number, at: (x: number, y: number) => Vec3 | undefined): Uint8Array {
  const data = new Uint8Array(4 * width * height).fill(255);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const n = at(x + 0.5, y + 0.5);
      data.set(n ? light(normalize(n)).map(encoded) : [0, 0, 0], 4 * (y * width + x));
    }
  return encodePng(width, height, data);
}

const N = 32;

// Faces as one sees them who turns from ahead (−Z), with +X to the right and +Y up; s to the right and t up, −1 … 1.
const FACES: readonly ((s: number, t: number) => Vec3)[] = [
  (s, t) => [1, t, s],
  (s, t) => [-1, t, -s],
  (s, t) => [s, 1, t],
  (s, t) => [s, -1, -t],
  (s, t) => [s, t, -1],
  (s, t) => [-s, t, 1],
];
const face = (k: number): Uint8Array => png(N, N, (x, y) => FACES[k]((2 * x) / N - 1, 1 - (2 * y) / N));

/** Cells are numbers of faces; `turned`: the last row's face is upside down. */
const cells = (rows: readonly (readonly (number | undefined)[])[], turned = false): Uint8Array =>
  png(N * rows[0].length, N * rows.length, (x, y) => {
    const [column, row] = [Math.floor(x / N), Math.floor(y / N)];
    const k = rows[row][column];
    if (k === undefined) return undefined;
    const way = turned && row === 3 ? -1 : 1;
    return FACES[k](way * ((2 * (x - column * N)) / N - 1), way * (1 - (2 * (y - row * N)) / N));
  });

const [RIGHT, LEFT, UP, DOWN, AHEAD, BEHIND] = [0, 1, 2, 3, 4, 5];
const NONE = undefined;

/** Of a scene's dome: what is seen in a direction of the world. */
function seen({ lights }: Scene): (n: Vec3) => readonly number[] {
  const dome = lights.find(isDomeLight)!;
  const [x, y, z] = domeAxes(dome);
  return (n) => sampleTexture(dome.texture!, ...latLongFromDirection([dot(n, x), dot(n, y), dot(n, z)])).slice(0, 3);
}

const open = (files: Readonly<Record<string, Uint8Array>>): Promise<Scene> =>
  openScene(memorySource(files), entryOf(Object.keys(files))!);

const DIRECTIONS: readonly Vec3[] = Array.from({ length: 200 }, (_, i) => {
  const h = 1 - (2 * (i + 0.5)) / 200;
  const [level, turn] = [Math.sqrt(1 - h * h), i * 2.399963];
  return [level * Math.cos(turn), h, level * Math.sin(turn)];
});

const off = (scene: Scene): number =>
  Math.max(...DIRECTIONS.flatMap((n) => seen(scene)(n).map((value, k) => Math.abs(value - light(n)[k]))));

const equirect = png(128, 64, (x, y) => {
  const [longitude, down] = [2 * Math.PI * (x / 128 - 0.5), (Math.PI * y) / 64];
  return [Math.sin(down) * Math.sin(longitude), Math.cos(down), -Math.sin(down) * Math.cos(longitude)];
});

describe('a panorama shows in every direction what it shows there', () => {
  it.each([
    ['by latitude and longitude', equirect],
    ['a strip', cells([[RIGHT, LEFT, UP, DOWN, AHEAD, BEHIND]])],
    ['a standing strip', cells([[RIGHT], [LEFT], [UP], [DOWN], [AHEAD], [BEHIND]])],
    [
      'a grid',
      cells([
        [RIGHT, LEFT, UP],
        [DOWN, AHEAD, BEHIND],
      ]),
    ],
    [
      'a cross',
      cells([
        [NONE, UP, NONE, NONE],
        [LEFT, AHEAD, RIGHT, BEHIND],
        [NONE, DOWN, NONE, NONE],
      ]),
    ],
    [
      'a standing cross, with the back upside down',
      cells(
        [
          [NONE, UP, NONE],
          [LEFT, AHEAD, RIGHT],
          [NONE, DOWN, NONE],
          [NONE, BEHIND, NONE],
        ],
        true,
      ),
    ],
  ])('%s', async (_, bytes) => {
    const scene = await open({ 'sky.png': bytes });
    expect(scene.diagnostics).toEqual([]);
    expect(off(scene)).toBeLessThan(0.025);
  });

  it.each([
    ['px.png', ['px', 'nx', 'py', 'ny', 'pz', 'nz']],
    ['Sky_Right.png', ['Sky_Right', 'Sky_Left', 'Sky_Top', 'Sky_Bottom', 'Sky_Front', 'Sky_Back']],
    ['cube/BK.png', ['cube/RT', 'cube/LF', 'cube/UP', 'cube/DN', 'cube/FT', 'cube/BK']],
  ])('six files, opened as %s', async (entry, names) => {
    const files = Object.fromEntries(names.map((name, k) => [`${name}.png`, face(k)]));
    expect(off(await openScene(memorySource(files), entry))).toBeLessThan(0.025);
  });

  it('radiance stays radiance', async () => {
    const channel = (name: string, value: number) => ({
      name,
      type: 'float' as const,
      data: new Float32Array(6 * 4 * 4).fill(value),
    });
    const exr = writeExr({ width: 24, height: 4, channels: [channel('R', 300), channel('G', 2), channel('B', 0.25)] });
    const { lights } = await open({ 'sky.exr': exr });
    const { texture } = lights.find(isDomeLight)!;
    expect(texture).toMatchObject({ width: 16, height: 8, colorSpace: 'linear' });
    const data = texture!.data as Uint16Array;
    for (let i = 0; i < data.length; i += 4)
      expect([...data.subarray(i, i + 4)].map(fromHalf)).toEqual([300, 2, 0.25, 1].map((v) => expect.closeTo(v, 2)));
  });
});

it('its camera looks at the middle of the picture', async () => {
  const { cameras, lights, objects } = await open({ 'sky.png': equirect });
  expect([objects.length, lights.length, cameras.length]).toEqual([0, 1, 1]);
  expect(seen({ lights } as Scene)([0, 0, -1])).toEqual(light([0, 0, -1]).map((v) => expect.closeTo(v, 1)));
});

describe('what a file says of itself', () => {
  /** An equirectangular picture; of `n` it has only what is above the horizon. */
  const around = (width: number, height: number, whole = height) =>
    png(width, height, (x, y) => {
      const [longitude, latitude] = [2 * Math.PI * (x / width - 0.5), Math.PI * (0.5 - y / whole)];
      const level = Math.cos(latitude);
      return [level * Math.sin(longitude), Math.sin(latitude), -level * Math.cos(longitude)];
    });
  const domeOf = async (bytes: Uint8Array) => {
    const scene = await openScene(memorySource({ 'a.png': bytes }), 'a.png');
    return { dome: scene.lights.find(isDomeLight)!.texture!, scene };
  };

  it('of pictures of two eyes the left one is shown: the upper, or the left one', async () => {
    const left = (await domeOf(around(32, 16))).dome;
    for (const [stereo, width, height] of [
      ['top-bottom', 32, 32],
      ['left-right', 64, 16],
    ] as const) {
      const other = png(width, height, () => undefined);
      const both = decodeImage(other, 'both.png');
      const eye = left.data as Uint8Array;
      for (let row = 0; row < 16; row++) both.data.set(eye.subarray(4 * 32 * row, 4 * 32 * (row + 1)), 4 * width * row);
      const bytes = withSphericalPng(encodePng(width, height, both.data), { projection: 'equirectangular', stereo });
      const { dome, scene } = await domeOf(bytes);
      expect(dome.data).toEqual(left.data);
      expect(scene.diagnostics).toMatchObject([{ code: 'panorama.stereo' }]);
    }
  });

  it('a part of the sphere is where it belongs', async () => {
    const whole = (await domeOf(around(32, 16))).dome;
    const crop = { left: 0, right: 0, top: 0, bottom: 0.5 };
    const upper = withSphericalPng(around(32, 8, 16), { projection: 'equirectangular', stereo: 'none', crop });
    const { dome, scene } = await domeOf(upper);
    expect([dome.width, dome.height]).toEqual([32, 16]);
    expect(dome.data.subarray(0, 4 * 32 * 8)).toEqual(whole.data.subarray(0, 4 * 32 * 8));
    expect(Math.max(...dome.data.subarray(4 * 32 * 8).filter((_, i) => i % 4 < 3))).toBe(0);
    expect(scene.diagnostics).toMatchObject([{ code: 'panorama.part' }]);
  });

  it('a dome master of this program is unfolded, as PNG and as EXR', async () => {
    const lens = domeLens(1.5 * Math.PI, 0.4);
    const size = { width: 80, height: 64 };
    const text = { lens: `fisheye of 270 degrees, its axis ${degrees(lens.elevation)} degrees up` };
    const directionAt = (x: number, y: number) => lensDirection(lens, x, y, size);
    const channels = ['R', 'G', 'B'].map((name, k) => ({
      name,
      type: 'float' as const,
      data: Float32Array.from({ length: 80 * 64 }, (_, i) => {
        const n = directionAt((i % 80) + 0.5, Math.floor(i / 80) + 0.5);
        return n ? light(n)[k]! : 0;
      }),
    }));
    const written: readonly Readonly<Record<string, Uint8Array>>[] = [
      { 'a.png': withPngText(png(80, 64, directionAt), text) },
      { 'a.exr': writeExr({ ...size, channels, attributes: text }) },
    ];
    for (const files of written) {
      const scene = await open(files);
      const axis: Vec3 = [0, Math.sin(lens.elevation), -Math.cos(lens.elevation)];
      let shown = 0;
      for (const n of DIRECTIONS) {
        const beyond = Math.acos(dot(n, axis)) - lens.aperture / 2;
        const rgb = seen(scene)(n);
        if (beyond > 0.15) expect(Math.max(...rgb)).toBe(0);
        if (beyond > -0.15) continue;
        shown++;
        rgb.forEach((value, k) => {
          expect(Math.abs(value - light(n)[k]!)).toBeLessThan(0.02);
        });
      }
      expect(shown).toBeGreaterThan(100);
    }
  });

  it('a part of a sphere that is too large is refused with its size', async () => {
    const crop = { left: 0, right: 0.9999, top: 0, bottom: 0.9995 };
    const tiny = withSphericalPng(
      png(4, 4, () => [0, 0, 1]),
      { projection: 'equirectangular', stereo: 'none', crop },
    );
    await expect(domeOf(tiny)).rejects.toThrow(/a\.png: it is a part of .* of 40000 × 8000 pixels/);
  });
});

describe('no panorama', () => {
  it.each([
    [
      'a photograph',
      'photo.png',
      40,
      30,
      'panorama.size',
      /photo\.png: the picture is 40 × 30 pixels, and no panorama; one is twice as wide/,
    ],
    ['a square', 'square.png', 30, 30, 'panorama.size', /30 × 30/],
    [
      'one face',
      'sky_ny.png',
      8,
      8,
      'panorama.faces',
      /there is no sky_px\.png, sky_nx\.png, sky_py\.png, sky_pz\.png, sky_nz\.png/,
    ],
  ])('%s', async (_, name, width, height, code, text) => {
    const bytes = png(width, height, (x, y) => [Math.sin(5 * x), Math.cos(3 * y), 1]);
    const refusal = openScene(memorySource({ [name]: bytes }), name);
    await expect(refusal).rejects.toThrow(text);
    await expect(refusal).rejects.toMatchObject({ diagnostic: { code } });
  });

  it('faces of several sizes', async () => {
    const files = Object.fromEntries(['px', 'nx', 'py', 'ny', 'pz', 'nz'].map((name, k) => [`${name}.png`, face(k)]));
    const small = png(8, 8, () => [0, 0, 1]);
    await expect(open({ ...files, 'py.png': small })).rejects.toThrow(
      /py\.png has 8 × 8 pixels and px\.png has 32 × 32/,
    );
  });

  it('a photograph of 3:2 is shown, and told of', async () => {
    const photo = png(96, 64, (x, y) => [Math.sin(x / 9 + y / 17), Math.cos(y / 13), Math.sin(x / 40)]);
    const { diagnostics } = await open({ 'photo.png': photo });
    expect(diagnostics).toMatchObject([{ code: 'panorama.edges', severity: 'warning' }]);
  });
});

describe('among files', () => {
  it('pictures are textures of a scene beside them', () => {
    expect(entryOf(['sky.hdr', 'set/cart.usda', 'wood.png'])).toBe('set/cart.usda');
  });
  it('without a scene the picture of radiance is taken', () => {
    expect(entryOf(['a.png', 'readme.txt', 'z.hdr'])).toBe('z.hdr');
    expect(entryOf(['readme.txt', 'notes.md'])).toBeUndefined();
  });
  it('a file that has no name of a face is none', () => {
    expect(faceFiles('desktop.png')).toEqual([]);
    expect(faceFiles('desk/top.png')[0]).toContain('desk/bottom.png');
  });
});
