import { expect, it } from 'vitest';
import { fromAxisAngle, IDENTITY } from '../math/quat.ts';
import { properVelocity } from '../physics/lorentz/boost.ts';
import { createTracedScene } from '../reference/intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from '../reference/lights/lightOptions.ts';
import { encodeDisplay } from '../reference/post/encodeDisplay.ts';
import { renderTile } from '../reference/tile.ts';
import { makeObject, makeScene, restingAt } from '../scene/defaults.ts';
import { sphere } from '../scene/mesh/primitives.ts';
import { offAxisLens, perspective } from '../scene/view/lenses/perspectiveLens.ts';
import { composeViews } from '../scene/view/pictureViews.ts';
import { DEFAULT_SETTINGS } from '../scene/view/view.ts';
import { renderOneViewAtATime, type SingleViewRequest } from './oneViewAtATime.ts';
import type { PictureRequest, RenderedPicture } from './pictureRenderer.ts';

const SIZE = { width: 40, height: 24 };
const scene = createTracedScene(
  makeScene({ name: 'ball', objects: [makeObject({ path: '/Ball', mesh: sphere(1), motion: restingAt([0, 0, -4]) })] }),
  1,
);
const EYES = [
  {
    t: 0,
    position: [-0.2, 0, 0],
    u: properVelocity([0, 0, -0.5]),
    orientation: IDENTITY,
    lens: offAxisLens({ left: -0.3, right: 0.5, bottom: -0.4, top: 0.4 }),
    viewport: { x: 1, y: 2, width: 18, height: 20 },
  },
  {
    t: 1,
    position: [0.2, 0, 0],
    u: properVelocity([0.3, 0, 0]),
    orientation: fromAxisAngle([0, 1, 0], 0.1),
    lens: perspective(0.8),
    viewport: { x: 20, y: 0, width: 20, height: 24 },
  },
] as const;
const request: PictureRequest = {
  views: EYES,
  settings: { ...DEFAULT_SETTINGS, speedOfLight: 1 },
  samples: 2,
  pixels: true,
  aovs: ['depth', 'beauty'],
};

/** The reference renderer, in this thread. */
async function render({ view, width, height, settings, samples, aovs }: SingleViewRequest): Promise<RenderedPicture> {
  const layers = [...aovs, 'picture'] as const;
  const tile = { x0: 0, y0: 0, x1: width, y1: height };
  const data = renderTile(
    scene,
    { view, settings, width, height, layers, samples, seed: 0, light: DEFAULT_LIGHT },
    tile,
  );
  return {
    pixels: encodeDisplay(data.picture!, width, height),
    aovs: new Map(aovs.map((name) => [name, data[name]!])),
  };
}

it('views in one picture are, to the bit, the pictures of each, and the rest is black', async () => {
  const together = await renderOneViewAtATime(request, SIZE, render);
  const parts: { rect: (typeof EYES)[number]['viewport']; picture: RenderedPicture }[] = [];
  for (const { viewport, ...view } of EYES) {
    const { width, height } = viewport;
    parts.push({
      rect: viewport,
      picture: await renderOneViewAtATime({ ...request, views: [view] }, { width, height }, render),
    });
  }
  const depth = parts.map(({ rect, picture }) => ({ rect, values: picture.aovs.get('depth')! }));
  expect(together.aovs.get('depth')).toEqual(composeViews(depth, SIZE, 1, new Float32Array(40 * 24)));
  const black = new Uint8Array(4 * 40 * 24).map((_, i) => (i % 4 === 3 ? 255 : 0));
  const pixels = parts.map(({ rect, picture }) => ({ rect, values: picture.pixels }));
  expect(together.pixels).toEqual(composeViews(pixels, SIZE, 4, black));
  for (const { values } of depth) expect(new Set(values).size).toBeGreaterThan(20);
  expect([...together.pixels.subarray(0, 4)]).toEqual([0, 0, 0, 255]);
});

it('progress goes from 0 to 1 over all views, by their area', async () => {
  const parts: number[] = [];
  const slowly = async (of: SingleViewRequest, onPart: (part: number) => void = () => {}): Promise<RenderedPicture> => {
    for (const part of [0, 0.5, 1]) onPart(part);
    return render({ ...of, samples: 1 });
  };
  await renderOneViewAtATime(request, SIZE, slowly, (part) => parts.push(part));
  const first = (18 * 20) / (18 * 20 + 20 * 24);
  expect(parts).toEqual([0, first / 2, first, first, (first + 1) / 2, 1].map((part) => expect.closeTo(part, 12)));
});

it('an off-axis lens traces the rays of the same part of a larger picture', async () => {
  const { viewport: _, ...view } = EYES[0];
  const [tanX, tanY] = [0.8, 0.48];
  const lens = offAxisLens({ left: -tanX, right: tanX, bottom: -tanY, top: tanY });
  const rect = { x: 12, y: 4, width: 16, height: 10 };
  const crop = offAxisLens({
    left: tanX * ((2 * rect.x) / SIZE.width - 1),
    right: tanX * ((2 * (rect.x + rect.width)) / SIZE.width - 1),
    bottom: tanY * (1 - (2 * (rect.y + rect.height)) / SIZE.height),
    top: tanY * (1 - (2 * rect.y) / SIZE.height),
  });
  const drawn = async (of: typeof lens, { width, height }: typeof SIZE): Promise<Float32Array> =>
    (await render({ ...request, view: { ...view, lens: of }, width, height, samples: 1 })).aovs.get('depth')!;
  const [whole, part] = [await drawn(lens, SIZE), await drawn(crop, rect)];
  let seen = 0;
  for (let y = 0; y < rect.height; y++)
    for (let x = 0; x < rect.width; x++) {
      const expected = whole[(y + rect.y) * SIZE.width + x + rect.x]!;
      expect(part[y * rect.width + x]).toBeCloseTo(expected, 5);
      if (expected > 0) seen++;
    }
  expect(seen).toBeGreaterThan(30);
});

it('views that leave the picture are refused before anything is drawn', async () => {
  let drawn = 0;
  const counted = (of: SingleViewRequest) => {
    drawn++;
    return render(of);
  };
  await expect(renderOneViewAtATime(request, { width: 39, height: 24 }, counted)).rejects.toThrow('view 2');
  expect(drawn).toBe(0);
});
