import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { create } from 'webgpu';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { length, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { apparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { box, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 120;
const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1 };

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const viewAt = (beta: Vec3, more: Partial<ViewPoint> = {}): ViewPoint => ({
  t: 0,
  position: ZERO,
  u: properVelocity(beta),
  orientation: IDENTITY,
  lens: perspective(1),
  ...more,
});
const withMaterial = (mesh: Mesh, material: number): Mesh => ({
  ...mesh,
  groups: mesh.groups.map((g) => ({ ...g, material })),
});
const ballAt = (position: Vec3, radius = 1): Scene =>
  makeScene({
    name: 'ball',
    objects: [makeObject({ path: '/ball', mesh: sphere(radius), motion: restingAt(position) })],
  });

async function render(scene: Scene, view: ViewPoint, settings = SETTINGS, samples = 1): Promise<void> {
  await headless.renderer.setScene(scene);
  pumpFrame();
  headless.renderer.render([view], settings, samples);
}

describe('closed forms', () => {
  it('a sphere has a circular outline at any speed (Penrose 1959)', async () => {
    const at: Vec3 = [1.5, 0.5, -6];
    for (const beta of [0.5, 0.95]) {
      const u = properVelocity([0.2 * beta, 0, -0.9 * beta]);
      const orientation = lookAtOrientation(apparentPosition(at, u), [0, 1, 0]);
      await render(ballAt(at), { ...viewAt(ZERO), u, orientation, lens: perspective(0.9 * (1 - 0.8 * beta)) });
      const ids = await headless.renderer.readAov('object');
      const { radii } = outline(ids);
      expect(radii.length).toBeGreaterThan(60);
      expect(Math.max(...radii) - Math.min(...radii)).toBeLessThan(1.8);
    }
  });

  it('D on the axis: √((1 + β)/(1 − β)) ahead, its reciprocal behind', async () => {
    const beta = 0.8;
    const middle = (SIZE / 2) * SIZE + SIZE / 2;
    await render(ballAt([0, 0, -5]), viewAt([0, 0, -beta]));
    expect((await headless.renderer.readAov('doppler'))[middle]).toBeCloseTo(3, 3);
    await render(ballAt([0, 0, -5]), viewAt([0, 0, beta]));
    expect((await headless.renderer.readAov('doppler'))[middle]).toBeCloseTo(1 / 3, 4);
  });

  it('rows run from the top, columns from the left', async () => {
    await render(ballAt([-1.2, 1.5, -6], 0.6), viewAt(ZERO));
    const ids = await headless.renderer.readAov('object');
    const where = (x: number, y: number) => ids[Math.floor(y) * SIZE + Math.floor(x)];
    expect(where(SIZE * 0.32, SIZE * 0.27)).toBe(1);
    expect(where(SIZE * 0.32, SIZE * 0.73)).toBe(0);
    expect(where(SIZE * 0.68, SIZE * 0.27)).toBe(0);
  });

  it('the background is 0 in every data AOV, and the sky in the picture', async () => {
    await render(makeScene({ name: 'empty', objects: [] }), viewAt(ZERO));
    for (const name of ['depth', 'emission_time', 'doppler', 'position', 'normal', 'velocity', 'object'] as const)
      expect(Math.max(...(await headless.renderer.readAov(name)).map(Math.abs))).toBe(0);
    expect(Math.min(...(await headless.renderer.readAov('beauty')))).toBeGreaterThan(0.05);
    const pixels = await headless.renderer.readPixels();
    expect(pixels.length).toBe(SIZE * SIZE * 4);
    expect(pixels.every((value, i) => (i % 4 === 3 ? value === 255 : value > 40))).toBe(true);
  });
});

/** Distances of outline pixels from the outline's centre [px]. */
function outline(ids: Float32Array): { radii: number[] } {
  const edge: [number, number][] = [];
  const on = (x: number, y: number) => ids[y * SIZE + x] > 0;
  for (let y = 1; y < SIZE - 1; y++)
    for (let x = 1; x < SIZE - 1; x++)
      if (on(x, y) && !(on(x - 1, y) && on(x + 1, y) && on(x, y - 1) && on(x, y + 1))) edge.push([x, y]);
  const middle = [0, 1].map((k) => {
    const values = edge.map((p) => p[k]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  });
  return { radii: edge.map(([x, y]) => Math.hypot(x - middle[0], y - middle[1])) };
}

describe('the renderer', () => {
  it('picks visible objects, and nothing in the sky', async () => {
    await render(ballAt([0, 0, -5]), viewAt([0, 0, -0.6]));
    const found = await headless.renderer.pick(SIZE / 2, SIZE / 2);
    expect(found?.surface).toMatchObject({ objectId: 1, path: '/ball' });
    expect(found?.surface?.emissionTime).toBeCloseTo(-4, 2);
    expect(found?.surface?.position[2]).toBeCloseTo(-4, 2);
    expect(found?.surface?.doppler).toBeCloseTo(2, 3);
    expect(found?.surface?.depth).toBeCloseTo(8, 1);
    const beauty = await headless.renderer.readAov('beauty');
    const middle = 3 * ((SIZE / 2) * SIZE + SIZE / 2);
    expect(found?.light).toEqual([...beauty.subarray(middle, middle + 3)]);
    const sky = await headless.renderer.pick(1, 1);
    expect(sky?.surface).toBeUndefined();
    expect(sky?.light[2]).toBeGreaterThan(0);
    expect(await headless.renderer.pick(-5, 900)).toBeUndefined();
  });

  it('the Newton solver with enough steps equals the exact one; with one step it does not', async () => {
    const scene = makeScene({
      name: 'mover',
      objects: [
        makeObject({
          path: '/ball',
          mesh: sphere(1),
          motion: { kind: 'uniform', pose: { position: [4, 0, -5], orientation: IDENTITY }, velocity: [0.7, 0, 0.2] },
        }),
      ],
    });
    const positions = async (change: Partial<RenderSettings>) => {
      await render(scene, viewAt(ZERO), { ...SETTINGS, ...change });
      return headless.renderer.readAov('position');
    };
    const exact = await positions({});
    const worst = (other: Float32Array) => other.reduce((most, x, i) => Math.max(most, Math.abs(x - exact[i])), 0);
    expect(worst(await positions({ solver: 'newton', iterations: 8 }))).toBeLessThan(1e-3);
    expect(worst(await positions({ solver: 'newton', iterations: 1, damping: 0.5 }))).toBeGreaterThan(0.1);
  });

  it('blends transparent surfaces over opaque ones, and hides them behind', async () => {
    const glass = (z: number) =>
      makeScene({
        name: 'glass',
        materials: [
          makeMaterial({ name: 'wall', baseColor: [0, 0, 0], roughness: 1 }),
          makeMaterial({ name: 'glass', baseColor: [1, 0, 0], emissive: [1, 0, 0], opacity: 0.5 }),
        ],
        objects: [
          makeObject({ path: '/wall', mesh: box([9, 9, 1]), motion: restingAt([0, 0, -8]) }),
          makeObject({ path: '/glass', mesh: withMaterial(box([2, 2, 1]), 1), motion: restingAt([0, 0, z]) }),
        ],
      });
    const red = async () => (await headless.renderer.readAov('beauty'))[3 * ((SIZE / 2) * SIZE + SIZE / 2)];
    await render(glass(-5), viewAt(ZERO));
    expect(await red()).toBeGreaterThan(0.45);
    expect((await headless.renderer.pick(SIZE / 2, SIZE / 2))?.surface?.path).toBe('/wall');
    await render(glass(-12), viewAt(ZERO));
    expect(await red()).toBeLessThan(0.2);
  });

  it('averages n × n samples of light; data are those of the pixel centre', async () => {
    const view = viewAt(ZERO);
    await render(ballAt([0, 0, -5]), view);
    const [data, one] = [await headless.renderer.readAov('position'), await headless.renderer.readAov('beauty')];
    await render(ballAt([0, 0, -5]), view, SETTINGS, 3);
    expect(await headless.renderer.readAov('position')).toEqual(data);
    const nine = await headless.renderer.readAov('beauty');
    const middle = 3 * ((SIZE / 2) * SIZE + SIZE / 2);
    expect(nine[middle]).toBeCloseTo(one[middle], 1);
    expect(nine.every(Number.isFinite)).toBe(true);
  });

  it('has complete light in the first picture of a size', async () => {
    const { renderer } = headless;
    for (const size of [SIZE + 24, SIZE]) {
      renderer.setSize(size, size);
      await render(ballAt([0, 0, -5]), viewAt(ZERO));
      const first = await renderer.readAov('beauty');
      renderer.render([viewAt(ZERO)], SETTINGS);
      expect(await renderer.readAov('beauty')).toEqual(first);
    }
  });

  it('culls invisible objects, and keeps those that aberration brings into view', async () => {
    await render(ballAt([0, 0, 6]), viewAt(ZERO));
    expect(headless.renderer.info.objectsDrawn).toBe(0);
    await render(ballAt([2, 0, 6]), viewAt([0, 0, -0.999]));
    expect(headless.renderer.info.objectsDrawn).toBe(1);
    expect(Math.max(...(await headless.renderer.readAov('object')))).toBe(1);
  });

  it('follows a changed speed of light for samples authored at rest', async () => {
    const times = Float64Array.of(-10, 10);
    const poses = Float64Array.of(...[-5, 0, -6, 0, 0, 0, 1], ...[5, 0, -6, 0, 0, 0, 1]);
    const moving = makeObject({
      path: '/cube',
      mesh: box([2, 1, 1]),
      motion: { kind: 'sampled', times, poses },
      authoredIn: 'rest',
    });
    const scene = makeScene({ name: 'rest', objects: [moving] });
    const width = async (speedOfLight: number) => {
      headless.renderer.render([viewAt(ZERO)], { ...SETTINGS, view: 'galilean', speedOfLight });
      const ids = await headless.renderer.readAov('object');
      return ids.slice((SIZE / 2) * SIZE, (SIZE / 2 + 1) * SIZE).filter((id) => id > 0).length;
    };
    await headless.renderer.setScene(scene);
    const wide = await width(1e6);
    expect((await width(0.625)) / wide).toBeCloseTo(0.6, 1);
  });
});

describe('a device with WebGPU’s minimum limits', () => {
  it('draws the G-buffer in two passes, with the same values', async () => {
    const scene = ballAt([0.3, 0.2, -5]);
    const view = viewAt([0.1, 0.2, -0.6]);
    await render(scene, view);
    const names = ['object', 'position', 'normal', 'doppler'] as const;
    const usual = await Promise.all(names.map((name) => headless.renderer.readAov(name)));
    const { SceneRenderer } = await import('../../../src/render/renderer.ts');
    const gpu = create([]);
    const device = await (await gpu.requestAdapter())?.requestDevice();
    if (!device) throw new Error('no device');
    expect(device.limits.maxColorAttachmentBytesPerSample).toBe(32);
    const errors: string[] = [];
    device.addEventListener('uncapturederror', (event) =>
      errors.push((event as GPUUncapturedErrorEvent).error.message),
    );
    const modest = await SceneRenderer.create({ device });
    modest.setSize(SIZE, SIZE);
    await modest.setScene(scene);
    modest.render([view], SETTINGS);
    const values = await Promise.all(names.map((name) => modest.readAov(name)));
    expect(values).toEqual(usual);
    expect(errors).toEqual([]);
    modest.dispose();
    device.destroy();
    expect(length(view.u)).toBeGreaterThan(0);
    expect(gpu).toBeDefined();
  });
});
