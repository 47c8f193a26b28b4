import '../../../src/cli/gpu/nodeShim.ts';
import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { openScene } from '../../../src/formats/open.ts';
import { rotate } from '../../../src/math/quat.ts';
import { scale } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { framingCamera, observerFromCamera } from '../../../src/scene/view/camera.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { files } from '../../examples/open.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { compareShadings, type ShadingComparison, SIZE } from './forwardPictures.ts';

const EXAMPLES = readdirSync(fileURLToPath(new URL('../../../examples/', import.meta.url))).filter((name) =>
  name.endsWith('.usdc'),
);
/** Stars are displayed by the G-buffer. */
const WITH_STARS = ['starfield.usdc', 'saturn.usdc'];
/** The barn's doors start instantly at 0.86 c: what is interpolated between those vertices is wrong in both ways. */
const JUMPING = 'ladder.usdc';

interface Shot {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
}

/** From the first camera, at rest and at 0.9 c. */
function shotsOf(scene: Scene): Shot[] {
  const c = scene.hints.speedOfLight ?? 10;
  const t = scene.hints.openAt ?? scene.startTime;
  const observer = observerFromCamera(scene.cameras[0] ?? framingCamera(scene), t, c);
  const settings = { ...DEFAULT_SETTINGS, speedOfLight: c, occlusionRadius: 0, antialiasing: false };
  return [0, 0.9].map((beta) => {
    const u = properVelocity(rotate(observer.orientation, scale([0, 0, -1], beta)));
    return { view: { ...observer, t, u }, settings };
  });
}

function expectSame(name: string, compared: readonly ShadingComparison[]): void {
  for (const { shading, largest, wrong, deviation } of compared) {
    expect(shading).toBe(WITH_STARS.includes(name) ? 'deferred' : 'forward');
    // The G-buffer holds colours and roughness as halves: one channel in ten thousand is rounded to the number after the next.
    expect(largest).toBeLessThanOrEqual(name === JUMPING ? 20 : 2);
    expect(wrong).toBeLessThan(name === JUMPING ? 5e-3 : 1e-4);
    expect(deviation).toBeGreaterThan(3);
  }
}

describe('a picture without a G-buffer is that with one, to 1/255', () => {
  let headless: HeadlessPictures;
  let chromium: ModulePage;
  beforeAll(async () => {
    headless = await openPictures(SIZE.width, SIZE.height);
    chromium = await openModulePage(fileURLToPath(new URL('./forwardPage.ts', import.meta.url)));
    await chromium.page.exposeFunction('readExample', async (path: string) =>
      Buffer.from((await files.read(path))!).toString('base64'),
    );
  });
  afterAll(async () => {
    await headless?.close();
    await chromium?.close();
  });

  it.each(EXAMPLES)('%s', async (name) => {
    const scene = await openScene(files, name);
    const shots = shotsOf(scene);
    await headless.renderer.setScene(scene);
    const compared: ShadingComparison[] = [];
    for (const { view, settings } of shots)
      compared.push(await compareShadings(headless.renderer, view, settings, pumpFrame));
    const onWebGl = await chromium.page.evaluate(([example, cases]) => window.compareShadings(example, cases), [
      name,
      shots,
    ] as const);
    expectSame(name, compared);
    expectSame(name, onWebGl);
    chromium.assertHealthy();
  });

  it('its shaders are compiled ahead while other pictures divide more and more triangles', async () => {
    const scene = await openScene(files, 'dice.usdc');
    const [{ view, settings }] = shotsOf(scene) as [Shot];
    const ahead = rotate(view.orientation, [0, 0, -1]);
    const shots = [0, 0.3, 0.6, 0.9, 0.95, 0.98].map((beta) => ({
      view: { ...view, u: properVelocity(scale(ahead, beta)) },
      settings,
    }));
    const linked = await chromium.page.evaluate((cases) => window.linkLate('dice.usdc', cases), shots);
    expect(linked.ahead).toBeGreaterThan(2);
    expect(linked.late).toBe(0);
    chromium.assertHealthy();
  });
});
