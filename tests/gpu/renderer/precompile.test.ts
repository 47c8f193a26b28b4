import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, expect, it, vi } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { Sampling } from '../../../src/render/settings.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { withMaterial } from '../../../src/scene/mesh/meshOps.ts';
import { sphere } from '../../../src/scene/mesh/primitives.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(64, 48);
});
afterAll(() => headless?.close());

const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1 };
const VIEW: ViewPoint = {
  t: 0,
  position: [0, 0, 6],
  u: properVelocity([0, 0, -0.5]),
  orientation: IDENTITY,
  lens: perspective(1),
};
/** A ball at rest, a moving one, and a transparent one. */
const SCENE = makeScene({
  name: 'balls',
  objects: [
    makeObject({ path: '/still', mesh: sphere(1), motion: restingAt([-1.5, 0, 0]) }),
    makeObject({
      path: '/fast',
      mesh: sphere(0.8),
      motion: { kind: 'uniform', pose: { position: [1.5, 0, 0], orientation: IDENTITY }, velocity: [0.6, 0, 0] },
    }),
    makeObject({ path: '/glass', mesh: withMaterial(sphere(0.5), 1), motion: restingAt([0, 0, 2]) }),
  ],
  materials: [makeMaterial({ name: 'matt' }), makeMaterial({ name: 'glass', opacity: 0.4 })],
});

function picture(settings: RenderSettings): Promise<Uint8Array> {
  pumpFrame();
  headless.renderer.render([VIEW], settings);
  return headless.renderer.readPixels();
}

/** Polls until the picture can be drawn without compiling, as the page does per frame. */
async function prepared(settings: RenderSettings, sampling: Sampling = 1): Promise<void> {
  const ask = () => headless.renderer.precompile([VIEW], settings, sampling);
  for (let asked = ask(); asked; asked = ask()) await asked;
}

const OTHERS: readonly (readonly [string, Partial<RenderSettings>])[] = [
  ['approximate colours', { colors: 'approximate' }],
  ['another tone curve', { tone: 'agx' }],
  ['false colours', { falseColors: { kind: 'doppler', from: 0.5, to: 2 } }],
  ['the slice of simultaneity', { view: 'simultaneity' }],
  ['another solver', { solver: 'newton', iterations: 1, damping: 0.5 }],
];

it('compiles all shaders of a picture before it is drawn, while other pictures are drawn, and does not change it', async () => {
  const { renderer, gpu } = headless;
  await renderer.setScene(SCENE);
  await prepared(SETTINGS);
  const first = await picture(SETTINGS);
  const precompiled = new Map<string, Uint8Array>();
  for (const [name, change] of OTHERS) {
    const settings = { ...SETTINGS, ...change };
    const coming = renderer.precompile([VIEW], settings);
    expect(coming, name).toBeDefined();
    // Pictures drawn meanwhile are unchanged.
    expect(await picture(SETTINGS), name).toEqual(first);
    await prepared(settings);
    expect(await picture(SETTINGS), name).toEqual(first);
    pumpFrame();
    const compiled = vi.spyOn(gpu.device, 'createRenderPipeline');
    renderer.render([VIEW], settings);
    expect(compiled, name).not.toHaveBeenCalled();
    compiled.mockRestore();
    const pixels = await renderer.readPixels();
    expect(pixels, name).not.toEqual(first);
    expect(renderer.precompile([VIEW], settings), name).toBeUndefined();
    precompiled.set(name, pixels);
  }
  for (const [name, change] of OTHERS) {
    await renderer.setScene(SCENE);
    expect(await picture({ ...SETTINGS, ...change }), name).toEqual(precompiled.get(name));
  }
});

it('compiles for moving and still pictures, without changing the last picture', async () => {
  const { renderer, gpu } = headless;
  for (const [name, sampling, change] of [
    ['edges', 1, {}],
    ['blended', 'temporal', {}],
    ['as it is', 1, { antialiasing: false }],
  ] as const) {
    const settings = { ...SETTINGS, ...change };
    await renderer.setScene(SCENE);
    await prepared(settings, sampling);
    const finer = (meanwhile: () => void): Promise<Uint8Array> => {
      pumpFrame();
      renderer.render([VIEW], settings, sampling);
      for (let i = 0; i < 4; i++) renderer.accumulate(4);
      meanwhile();
      for (let i = 0; i < 4; i++) renderer.accumulate(4);
      return renderer.readPixels();
    };
    const compiled = vi.spyOn(gpu.device, 'createRenderPipeline');
    const undisturbed = await finer(() => {});
    expect(compiled, name).not.toHaveBeenCalled();
    compiled.mockRestore();
    const other: RenderSettings = { ...settings, falseColors: { kind: 'band', from: 0.5, to: 2 }, exposure: 2 };
    let coming: Promise<void> | undefined;
    expect(
      await finer(() => {
        coming = renderer.precompile([{ ...VIEW, lens: perspective(0.5) }], other, sampling);
      }),
      name,
    ).toEqual(undisturbed);
    expect(coming, name).toBeDefined();
    await coming;
    expect(await renderer.readPixels(), name).toEqual(undisturbed);
  }
});
