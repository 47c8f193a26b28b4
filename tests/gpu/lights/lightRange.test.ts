import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { addScaled, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { toLinearSrgb } from '../../../src/spectrum/color/observerColor.ts';
import { colorMatching } from '../../../src/spectrum/observer/standardObserver.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { openPictures } from '../support/openPictures.ts';
import { BRIGHT, EMBER_TEMPERATURE, middleLight, SIZE, STILL } from './lightRangeScenes.ts';

/*
 * Light far beyond 65,504 keeps its brightness and hue, in the light, through effects, as emission and as a still. Expected: Planck's law shifted by D is
 * Planck's law at T D, integrated here.
 */

/** Exact in the SI: h [J s], c [m/s], c₂ = hc/k_B [m K]. */
const [PLANCK, LIGHT, SECOND_RADIATION] = [6.626_070_15e-34, 299_792_458, 1.438_776_877_503_934e-2];

/** XYZ of a blackbody's spectral radiance 2hc²λ⁻⁵/(e^{c₂/λT} − 1), W/(m² sr). */
function planckXyz(T: number): Vec3 {
  let sum = ZERO;
  for (let nm = 360; nm <= 830; nm++) {
    const wavelength = nm * 1e-9;
    const radiance = (2 * PLANCK * LIGHT ** 2) / wavelength ** 5 / Math.expm1(SECOND_RADIATION / (wavelength * T));
    sum = addScaled(sum, colorMatching(wavelength), radiance * 1e-9);
  }
  return sum;
}

/** The light of an ember of luminance 1 at rest, or of luminances in cd/m², seen with D. */
const emberAt = (D: number): Vec3 =>
  scale(toLinearSrgb(planckXyz(EMBER_TEMPERATURE * D)), 1 / planckXyz(EMBER_TEMPERATURE)[1]);
const cosmosAt = (D: number): Vec3 => scale(toLinearSrgb(planckXyz(2.7255 * D)), 683);

/** Straight ahead, D = γ + u. */
const aheadOf = (u: number): number => Math.sqrt(1 + u * u) + u;

type Draw = (
  ...given: Parameters<typeof middleLight> extends [unknown, ...infer Rest, unknown] ? Rest : never
) => ReturnType<typeof middleLight>;

function expectLight(drawn: Awaited<ReturnType<Draw>>, expected: Vec3, bound: number): void {
  const most = Math.max(...expected.map(Math.abs));
  for (const k of [0, 1, 2]) expect(Math.abs(drawn.light[k] - expected[k]) / most).toBeLessThan(bound);
  const luminance = 0.2126 * expected[0] + 0.7152 * expected[1] + 0.0722 * expected[2];
  expect(Math.abs(drawn.metered / luminance - 1)).toBeLessThan(2 * bound);
}

function lightHasRange(draw: Draw): void {
  // Speeds 0.6 c and 0.9 c away and towards it, and γ = 1000.
  it.each([-0.75, 0.75, 2.0647, 1000])('an ember of 1000 K at γβ = %s', async (u) => {
    const expected = emberAt(aheadOf(u));
    if (u > 0) expect(Math.max(...expected)).toBeGreaterThan(1e5);
    expectLight(await draw('ember', u, 'none'), expected, 2e-3);
  });

  it('the same through bloom, and by blending', async () => {
    expectLight(await draw('ember', 0.75, 'blurred'), emberAt(2), 2e-3);
    expectLight(await draw('veil', 0.75, 'none'), scale(emberAt(2), 0.5), 2e-3);
  });

  it.each([500, 1000])('the cosmic background at γ = %s', async (gamma) => {
    const u = Math.sqrt(gamma * gamma - 1);
    const expected = cosmosAt(aheadOf(u));
    expect(Math.max(...expected)).toBeGreaterThan(3e5);
    expectLight(await draw('cosmos', u, 'none'), expected, 2e-3);
  });

  it('an emission and a still beyond halves', async () => {
    expectLight(await draw('bright', 0, 'none'), BRIGHT, 1e-3);
    expectLight(await draw('ember', 0, 'still'), STILL, 1e-6);
  });
}

describe('on WebGPU (Dawn)', () => {
  const opened = { promise: undefined as ReturnType<typeof openPictures> | undefined };
  beforeAll(async () => {
    opened.promise = openPictures(SIZE, SIZE);
    await opened.promise;
  });
  afterAll(async () => (await opened.promise)?.close());
  lightHasRange(async (...given) => middleLight((await opened.promise!).renderer, ...given, pumpFrame));
});

describe('on WebGL2 (Chromium)', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./lightRangePage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());
  lightHasRange(async (...given) => {
    const drawn = await chromium.page.evaluate((args) => window.middleLight(...args), given);
    chromium.assertHealthy();
    return drawn;
  });
});
