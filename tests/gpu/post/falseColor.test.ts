import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { createTracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { DEFAULT_LIGHT } from '../../../src/reference/lights/lightOptions.ts';
import {
  AOVS_OF_FALSE_COLOR,
  type FalseColorInput,
  falseColorPicture,
  falseColorValues,
} from '../../../src/reference/post/falseColor.ts';
import { renderTile } from '../../../src/reference/tile.ts';
import { makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { METER_CELLS, meterPixel, relativeLuminance } from '../../../src/scene/view/metering.ts';
import { type AovName, DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import type { View } from '../../../src/scene/views/views.ts';
import { FALSE_COLOR_QUANTITIES, type FalseColorQuantity } from '../../../src/spectrum/falseColor/falseColor.ts';
import { fitScale } from '../../../src/spectrum/falseColor/falseColorScale.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = { width: 96, height: 72 };
const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1, exposure: 0.5 };
/** A ball at rest, a floor and a ball moving to the right, in front of the sky; the observer moves ahead. */
const SCENE = makeScene({
  name: 'balls',
  objects: [
    makeObject({ path: '/floor', mesh: plane(30, 30), motion: restingAt([0, -1.2, -8]) }),
    makeObject({ path: '/still', mesh: sphere(1), motion: restingAt([-1.5, 0, -6]) }),
    makeObject({
      path: '/fast',
      mesh: sphere(0.8),
      authoredIn: 'rest',
      motion: {
        kind: 'uniform',
        pose: { position: [6, 0.5, -7], orientation: IDENTITY },
        velocity: [0.6, 0, 0],
      },
    }),
  ],
});
const VIEW: ViewPoint = {
  t: 3,
  position: [0, 0, 0],
  u: properVelocity([0, 0, -0.4]),
  orientation: IDENTITY,
  lens: perspective(1),
};

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE.width, SIZE.height);
  await headless.renderer.setScene(SCENE);
});
afterAll(() => headless?.close());

function render(settings: RenderSettings, samples = 1): void {
  pumpFrame();
  headless.renderer.render([VIEW], settings, samples);
}

async function rasterized(names: readonly AovName[], settings: RenderSettings, samples = 1): Promise<FalseColorInput> {
  render(settings, samples);
  const aovs = new Map<AovName, Float32Array>();
  for (const name of names) aovs.set(name, await headless.renderer.readAov(name));
  return { aovs, views: [VIEW], settings, ...SIZE };
}

function traced(kind: FalseColorQuantity, settings: RenderSettings): FalseColorInput {
  const layers = AOVS_OF_FALSE_COLOR[kind];
  const request = { view: VIEW, settings, ...SIZE, layers, samples: 1, seed: 0, light: DEFAULT_LIGHT };
  const data = renderTile(createTracedScene(SCENE, 1), request, { x0: 0, y0: 0, x1: SIZE.width, y1: SIZE.height });
  return { aovs: new Map(layers.map((name) => [name, data[name]!])), views: [VIEW], settings, ...SIZE };
}

/** Fraction of pixels with a channel error of more than `slack` of 255. */
async function shareOff(kind: FalseColorQuantity, taken: FalseColorInput, slack: number, samples = 1): Promise<number> {
  const values = falseColorValues(kind, taken);
  const colors = { kind, ...fitScale(kind, values) };
  const expected = falseColorPicture(colors, values, taken).pixels;
  render({ ...taken.settings, falseColors: colors }, samples);
  const drawn = await headless.renderer.readPixels();
  let differing = 0;
  for (let i = 0; i < drawn.length; i += 4)
    if ([0, 1, 2].some((k) => Math.abs(drawn[i + k]! - expected[i + k]!) > slack)) differing++;
  return (4 * differing) / drawn.length;
}

describe('false colours on the GPU', () => {
  it.each(['doppler', 'emission-time'] as const)('%s: colours of the reference renderer’s values', async (kind) => {
    for (const view of ['light-cone', 'simultaneity', 'galilean'] satisfies View[]) {
      const settings = { ...SETTINGS, view };
      // At edges rounding decides which object a ray hits.
      expect(await shareOff(kind, traced(kind, settings), 2)).toBeLessThan(0.01);
    }
  });

  it.each(FALSE_COLOR_QUANTITIES)('%s: colours of the data channels’ values, to one 8-bit step', async (kind) => {
    for (const samples of [1, 2])
      expect(
        await shareOff(kind, await rasterized(AOVS_OF_FALSE_COLOR[kind], SETTINGS, samples), 1, samples),
      ).toBeLessThan(0.001);
  });

  it('the picture without false colours is the same before and after', async () => {
    render(SETTINGS);
    const before = await headless.renderer.readPixels();
    render({ ...SETTINGS, falseColors: { kind: 'radiance', from: 0.1, to: 10 } });
    expect(await headless.renderer.readPixels()).not.toEqual(before);
    render(SETTINGS);
    expect(await headless.renderer.readPixels()).toEqual(before);
  });
});

describe('the light meter', () => {
  it.each([1, 2])(
    'reads the values of the data channels at its positions, with n = %s of n × n samples',
    async (samples) => {
      const { aovs } = await rasterized(['beauty', 'object', 'doppler', 'emission_time'], SETTINGS, samples);
      const readings = await headless.renderer.measureLight();
      const taken = { aovs, views: [VIEW], settings: SETTINGS, ...SIZE } as const;
      const [doppler, time] = [falseColorValues('doppler', taken), falseColorValues('emission-time', taken)];
      const beauty = aovs.get('beauty')!;
      for (let i = 0; i < METER_CELLS * METER_CELLS; i++) {
        const pixel =
          meterPixel(Math.floor(i / METER_CELLS), SIZE.height) * SIZE.width + meterPixel(i % METER_CELLS, SIZE.width);
        const [r, g, b] = beauty.subarray(3 * pixel, 3 * pixel + 3);
        expect(readings.luminance[i]! / relativeLuminance(r!, g!, b!)).toBeCloseTo(1, 3);
        if (aovs.get('object')![pixel]) expect(readings.doppler[i]).toBeCloseTo(doppler[pixel]!, 4);
        // The sky's reading is at the cell's centre, at most a pixel away.
        else expect(Math.abs(readings.doppler[i]! / doppler[pixel]! - 1)).toBeLessThan(0.02);
        if (Number.isNaN(time[pixel]!)) expect(readings.time[i]).toBeNaN();
        else expect(readings.time[i]).toBeCloseTo(time[pixel]!, 3);
      }
    },
  );
});
