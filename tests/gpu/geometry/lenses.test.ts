import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { conjugate, rotate } from '../../../src/math/quat.ts';
import { addScaled, normalize, sub, type Vec3 } from '../../../src/math/vec3.ts';
import { apparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { observerDoppler } from '../../../src/physics/optics/doppler.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { visibleHit } from '../../../src/reference/camera/visibleHit.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { CUBE_FACES } from '../../../src/scene/view/lenses/cubeFaces.ts';
import { CUBE_GRIDS } from '../../../src/scene/view/lenses/cubeLens.ts';
import { domeLens } from '../../../src/scene/view/lenses/fisheyeLens.ts';
import { lensPixel, type PanoramicLens } from '../../../src/scene/view/lenses/lenses.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { relativeLuminance } from '../../../src/scene/view/metering.ts';
import type { PictureSize } from '../../../src/scene/view/pictureSize.ts';
import type { ViewPoint } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { C, eye, SETTINGS, thingsAround } from './thingsAround.ts';

/** Things on all sides, one of them in flight. */
const SCENE = thingsAround([
  ['/Right', [6, 1, 1], 2],
  ['/Left', [-5, 0, -2], 2],
  ['/Above', [0.5, 6, -0.5], 2],
]);
const LENSES: readonly { name: string; lens: PanoramicLens; width: number; height: number }[] = [
  { name: 'equirectangular', lens: { kind: 'equirectangular' }, width: 256, height: 128 },
  { name: 'dome', lens: domeLens(Math.PI, 0.3), width: 160, height: 160 },
  { name: 'fisheye of 250°', lens: { kind: 'fisheye', aperture: 4.36, elevation: 0 }, width: 200, height: 160 },
  { name: 'equirectangular with bars', lens: { kind: 'equirectangular' }, width: 160, height: 110 },
  { name: 'cube', lens: { kind: 'cube', layout: '3x2' }, width: 192, height: 128 },
  { name: 'row of faces', lens: { kind: 'cube', layout: '6x1' }, width: 384, height: 64 },
];

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(64, 64);
  await headless.renderer.setScene(SCENE);
});
afterAll(() => headless?.close());

describe.each(LENSES)('$name', ({ lens, width, height }) => {
  it('shows at every pixel what the reference finds along its ray, and within 0.9 pixels of where the closed form puts it', async () => {
    const { renderer } = headless;
    const size = { width, height };
    const view = eye(lens);
    renderer.setSize(width, height);
    pumpFrame();
    renderer.render([view], SETTINGS, 1);
    const [object, position, doppler] = [
      await renderer.readAov('object'),
      await renderer.readAov('position'),
      await renderer.readAov('doppler'),
    ];
    const traced = createTracedScene(SCENE, C);
    let [same, all, farthest] = [0, 0, 0];
    const seen = new Set<number>();
    for (let i = 0; i < width * height; i++) {
      const [x, y] = [(i % width) + 0.5, Math.floor(i / width) + 0.5];
      const ray = cameraRay(view, SETTINGS, x, y, width, height);
      if (!ray) {
        expect(object[i]).toBe(0);
        continue;
      }
      all++;
      const hit = visibleHit(traced, ray);
      if ((hit ? hit.object + 1 : 0) !== object[i]) continue;
      same++;
      if (!hit) continue;
      seen.add(object[i]!);
      const event = Array.from(position.subarray(3 * i, 3 * i + 3)) as unknown as Vec3;
      const apparent = apparentPosition(sub(event, view.position), view.u);
      const direction = normalize(rotate(conjugate(view.orientation), apparent));
      const [px, py] = lensPixel(lens, direction, size)!;
      const aside = Math.min(Math.abs(px - x), lens.kind === 'equirectangular' ? width - Math.abs(px - x) : width);
      if (isMeasured(lens, direction, [px, py], [x, y], size)) farthest = Math.max(farthest, Math.hypot(aside, py - y));
      if (SCENE.objects[hit.object]!.motion.kind === 'static')
        expect(Math.abs(doppler[i]! / observerDoppler(sub(event, view.position), view.u) - 1)).toBeLessThan(1e-3);
    }
    expect(seen.size).toBe(SCENE.objects.length);
    expect(same / all).toBeGreaterThan(0.99);
    expect(farthest).toBeLessThan(lens.kind === 'cube' ? 0.5 : 0.9);
  });
});

/**
 * Not in a picture of faces where a neighbouring direction is on another face; nor where directions are stretched, at poles and at more than a right angle from
 * the axis of a fisheye: more pixels than the faces have show the same there.
 */
function isMeasured(
  lens: PanoramicLens,
  [right, up, back]: Vec3,
  found: readonly [number, number],
  at: readonly [number, number],
  size: PictureSize,
): boolean {
  switch (lens.kind) {
    case 'equirectangular':
    case 'stereo':
      return Math.hypot(right, back) > 0.8;
    case 'fisheye':
      return Math.sin(lens.elevation) * up - Math.cos(lens.elevation) * back > 0;
    case 'cube': {
      const side = size.height / CUBE_GRIDS[lens.layout][1];
      return found.every((value, k) => Math.floor(value / side) === Math.floor(at[k]! / side));
    }
  }
}

it('has no seams: between faces, light changes from pixel to pixel as it does inside them', async () => {
  const { renderer } = headless;
  const [side, lens] = [96, { kind: 'cube', layout: '6x1' }] as const;
  const size = { width: 6 * side, height: side };
  renderer.setSize(size.width, size.height);
  pumpFrame();
  renderer.render([eye(lens)], SETTINGS, 1);
  const light = await renderer.readAov('beauty');
  const luminance = (x: number, y: number): number => relativeLuminance(...rgbAt(light, y * size.width + x));
  const step = (a: number, b: number): number => Math.abs(a - b) / ((a + b) / 2 + 1e-6);
  const [across, inside]: [number[], number[]] = [[], []];
  for (let face = 0; face < 6; face++)
    for (let i = 1; i < side - 1; i++)
      for (const [x, y, dx, dy] of [
        [0, i, -1, 0],
        [side - 1, i, 1, 0],
        [i, 0, 0, -1],
        [i, side - 1, 0, 1],
      ] as const) {
        const here = luminance(face * side + x, y);
        inside.push(step(here, luminance(face * side + x - dx, y - dy)));
        const { forward, right, up } = CUBE_FACES[face]!;
        const [tx, ty] = [(2 * (x + 0.5 + dx)) / side - 1, 1 - (2 * (y + 0.5 + dy)) / side];
        const there = lensPixel(lens, normalize(addScaled(addScaled(forward, right, tx), up, ty)), size)!;
        across.push(step(here, luminance(Math.floor(there[0]), Math.floor(there[1]))));
      }
  const mean = (values: readonly number[]): number => values.reduce((a, b) => a + b) / values.length;
  expect(mean(inside)).toBeGreaterThan(0.001);
  expect(mean(across)).toBeLessThan(1.1 * mean(inside));
});

it('averages samples as a perspective picture does: the mean over a cube’s face is that of the picture there', async () => {
  const { renderer } = headless;
  const lens = { kind: 'cube', layout: '6x1' } as const;
  const view = eye(lens);
  const settings = { ...SETTINGS, antialiasing: true, occlusionRadius: 0 };
  const [side, samples] = [64, 4];
  renderer.setSize(6 * side, side);
  pumpFrame();
  renderer.render([view], settings, samples);
  const faces = await renderer.readAov('beauty');
  const ahead: ViewPoint = { ...view, lens: perspective(Math.PI / 2) };
  renderer.setSize(side, side);
  pumpFrame();
  renderer.render([ahead], settings, samples);
  const alone = await renderer.readAov('beauty');
  for (let y = 0; y < side; y++)
    for (let x = 0; x < side; x++)
      for (let k = 0; k < 3; k++) {
        const expected = alone[3 * (y * side + x) + k]!;
        expect(Math.abs(faces[3 * (y * 6 * side + 4 * side + x) + k]! - expected)).toBeLessThan(
          0.002 + 0.01 * expected,
        );
      }
});

const rgbAt = (values: Float32Array, i: number): [number, number, number] => [
  values[3 * i]!,
  values[3 * i + 1]!,
  values[3 * i + 2]!,
];
