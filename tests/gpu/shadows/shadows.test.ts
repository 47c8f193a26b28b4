import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { openSceneFile } from '../../../src/cli/files/sceneFiles.ts';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { rotate } from '../../../src/math/quat.ts';
import { dot, length, normalize, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { visibleHit } from '../../../src/reference/camera/visibleHit.ts';
import { createTracedScene, type TracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { createLightingContext } from '../../../src/reference/lights/createLightingContext.ts';
import { rayBack } from '../../../src/reference/lights/lightingContext.ts';
import { DEFAULT_LIGHT } from '../../../src/reference/lights/lightOptions.ts';
import { reflectionOrigin } from '../../../src/reference/transport/rayOrigin.ts';
import { visibility } from '../../../src/reference/transport/transmittance.ts';
import { FOREVER, restingAt } from '../../../src/scene/defaults.ts';
import type { Light, Scene } from '../../../src/scene/types.ts';
import { observerFromCamera } from '../../../src/scene/view/camera.ts';
import { DEFAULT_SETTINGS, type RenderSettings } from '../../../src/scene/view/view.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import {
  PROJECTILE_SCENES,
  penumbraScene,
  renderSunVisibility,
  SHADOW_SCENES,
  type ShadowScene,
  SIZE,
} from './shadowsScenes.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

/** Whether the reference has the light of all suns at a point of the picture; undefined for the background. */
function litAt(traced: TracedScene, { view, settings, scene }: ShadowScene, x: number, y: number): boolean | undefined {
  const hit = visibleHit(traced, cameraRay(view, settings, x, y, SIZE, SIZE)!);
  if (!hit) return undefined;
  const lighting = createLightingContext(traced, settings, DEFAULT_LIGHT, view.u, () => 0.5);
  const start = reflectionOrigin(traced, hit);
  return scene.lights.every((light) => {
    if (light.kind !== 'distant') return true;
    const toSun: Vec3 = scale(normalize(light.direction), -1e3);
    if (length(hit.velocity) === 0 && dot(start.geometricNormal, toSun) <= 0) return true;
    const ray = rayBack(lighting, start, toSun);
    return visibility(traced, { ray, begin: start.clearance / 1e3, from: hit }, 1).fraction > 0.5;
  });
}

type Lit = (x: number, y: number) => boolean | undefined;
const JUDGES = new WeakMap<ShadowScene, Lit>();
const TRACED = new WeakMap<Scene, TracedScene>();

/** `litAt` of a picture; remembered, since both backends are compared with it. */
function judgeOf(of: ShadowScene): Lit {
  const traced = TRACED.get(of.scene) ?? createTracedScene(of.scene, of.settings.speedOfLight);
  TRACED.set(of.scene, traced);
  const known = new Map<string, boolean | undefined>();
  const made: Lit = (x, y) => {
    const key = `${x} ${y}`;
    if (!known.has(key)) known.set(key, litAt(traced, of, x, y));
    return known.get(key);
  };
  const judge = JUDGES.get(of) ?? made;
  JUDGES.set(of, judge);
  return judge;
}

/** Colour of a sun that outshines all other light. */
const BRIGHT: Vec3 = [3e3, 3e3, 3e3];

/** Fraction of the light at the edge of a shadow: half the loss in the shadow of the weaker sun. */
const full = ({ scene }: ShadowScene): number => (scene.lights.length > 2 ? 0.82 : 0.5);

/** Fraction of pixels whose shadow differs from the reference's, also within one pixel: of all compared pixels, and of those along edges. */
function differences(scene: ShadowScene, shares: ArrayLike<number>, counted: (pixel: number) => boolean = () => true) {
  const lit = judgeOf(scene);
  const counts = { all: 0, shadow: 0, otherwise: 0, wrong: 0 };
  for (let y = 1; y < SIZE; y += 2)
    for (let x = 1; x < SIZE; x += 2) {
      const share = shares[y * SIZE + x];
      const isLit = share < 0 || !counted(y * SIZE + x) ? undefined : lit(x + 0.5, y + 0.5);
      if (isLit === undefined) continue;
      counts.all++;
      if (!isLit) counts.shadow++;
      const drawn = share > full(scene);
      if (drawn === isLit) continue;
      counts.otherwise++;
      const around = [-1.5, 0, 1.5].flatMap((dx) => [-1.5, 0, 1.5].map((dy) => lit(x + 0.5 + dx, y + 0.5 + dy)));
      if (!around.includes(drawn)) counts.wrong++;
    }
  return counts;
}

function expectSame(scene: ShadowScene, shares: ArrayLike<number>): void {
  const { all, shadow, otherwise, wrong } = differences(scene, shares);
  if (process.env.REPORT) console.log(scene.name, { all, shadow, otherwise, wrong });
  expect(shadow / all).toBeGreaterThan(0.02);
  expect(otherwise / all).toBeLessThan(0.01);
  expect(wrong / all).toBeLessThan(1e-3);
}

/** An example with sunlight only, and as it is. */
async function sunlitExample(name: string): Promise<{ readonly opened: Scene; readonly scene: Scene }> {
  const file = fileURLToPath(new URL(`../../../examples/${name}.usdc`, import.meta.url));
  const opened = await openSceneFile(file);
  const lights = opened.lights.flatMap((light) => (light.kind === 'distant' ? [{ ...light, color: BRIGHT }] : []));
  const materials = opened.materials.map((material) => ({ ...material, emissive: ZERO }));
  return { opened, scene: { ...opened, materials, lights: [...lights, { kind: 'dome', path: '/Dark', color: ZERO }] } };
}

/** The same from its camera, with a given velocity of the observer. */
function exampleScene({ opened, scene }: Awaited<ReturnType<typeof sunlitExample>>, beta: number): ShadowScene {
  const { name } = opened;
  const c = opened.hints.speedOfLight ?? 1;
  const t = opened.hints.openAt ?? opened.startTime;
  const view = { t, ...observerFromCamera(opened.cameras[0], t, c) };
  const u = properVelocity(scale(rotate(view.orientation, [0, 0, -1]), beta));
  const settings: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: c, colors: 'approximate' };
  return { name, scene, view: { ...view, u }, settings };
}

const EXAMPLES = ['street', 'dice', 'sunset'];

describe('shadows of suns agree with the reference, on WebGPU', () => {
  describe.each(EXAMPLES)('in the example %s', (name) => {
    let example: Awaited<ReturnType<typeof sunlitExample>>;
    beforeAll(async () => {
      example = await sunlitExample(name);
    });
    it.each([0, 0.5, 0.9])('at %s c', async (beta) => {
      pumpFrame();
      const scene = exampleScene(example, beta);
      const { all, shadow, otherwise, wrong } = differences(scene, await renderSunVisibility(headless.renderer, scene));
      if (process.env.REPORT) console.log(name, beta, { all, shadow, otherwise, wrong });
      expect(shadow / all).toBeGreaterThan(0.02);
      expect(otherwise / all).toBeLessThan(0.03);
      expect(wrong / all).toBeLessThan(0.005);
    });
  });
  it.each(SHADOW_SCENES)('$name', async (scene) => {
    pumpFrame();
    expectSame(scene, await renderSunVisibility(headless.renderer, scene));
  });
  it.each(PROJECTILE_SCENES)('on $name itself', async (scene) => {
    pumpFrame();
    const shares = await renderSunVisibility(headless.renderer, scene);
    const place = await headless.renderer.readAov('position');
    const { all, otherwise, wrong } = differences(scene, shares, (pixel) => place[3 * pixel + 1] > 0.2);
    if (process.env.REPORT) console.log(scene.name, { all, otherwise, wrong });
    expect(all).toBeGreaterThan(500);
    expect(otherwise / all).toBeLessThan(0.02);
    expect(wrong / all).toBeLessThan(0.005);
  });
});

/** Above the thrown object. */
const LAMP: Light = {
  kind: 'sphere',
  path: '/Lamp',
  motion: restingAt([2, 9, 2]),
  lifetime: FOREVER,
  radius: 0.1,
  color: [3e3, 3e3, 3e3],
};

describe('under a local light', () => {
  // Both are convex: surfaces that face the light are lit.
  it.each(PROJECTILE_SCENES)('$name does not shadow itself', async ({ scene, ...seen }) => {
    pumpFrame();
    const lights = [LAMP, ...scene.lights.filter(({ kind }) => kind === 'dome')];
    const shares = await renderSunVisibility(headless.renderer, { ...seen, scene: { ...scene, lights } });
    const place = await headless.renderer.readAov('position');
    const own = shares.filter((share, pixel) => share >= 0 && place[3 * pixel + 1] > 0.2);
    const shaded = own.filter((share) => share < 0.5).length;
    if (process.env.REPORT) console.log('under a lamp', seen.name, { all: own.length, shaded });
    expect(own.length).toBeGreaterThan(2000);
    expect(shaded / own.length).toBeLessThan(0.02);
  });
});

describe('edges of shadows', () => {
  /** Fraction of a disc of radius 1 on one side of a line at distance d from its centre. */
  const segment = (d: number): number =>
    Math.abs(d) >= 1 ? Number(d > 0) : 0.5 + (d * Math.sqrt(1 - d * d) + Math.asin(d)) / Math.PI;
  it.each([
    [0.02, 1],
    [0.05, 1.5],
    [0.08, 3],
  ])('have the sun’s penumbra: %d m wide, under an edge at %d m', async (radius, height) => {
    pumpFrame();
    const shares = await renderSunVisibility(headless.renderer, penumbraScene(radius, height));
    const place = await headless.renderer.readAov('position');
    const { sum, most, count } = shares.reduce(
      (all, share, i) => {
        const x = place[3 * i];
        if (Math.abs(x) > 2 * radius) return all;
        const off = share - segment(-x / radius);
        return { sum: all.sum + off, most: Math.max(all.most, Math.abs(off)), count: all.count + 1 };
      },
      { sum: 0, most: 0, count: 0 },
    );
    if (process.env.REPORT) console.log('penumbra', radius, height, { mean: sum / count, most, count });
    expect(count).toBeGreaterThan(1000);
    expect(Math.abs(sum / count)).toBeLessThan(0.01);
    expect(most).toBeLessThan(0.1);
  });
});

describe('on WebGL2', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./shadowsPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());
  it.each(SHADOW_SCENES)('$name', async (scene) => {
    const shares = await chromium.page.evaluate((name) => window.captureSunVisibility(name), scene.name);
    chromium.assertHealthy();
    expectSame(scene, shares);
  });
});
