import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY, rotate } from '../../../src/math/quat.ts';
import { add, dot, negate, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { aberrate } from '../../../src/physics/optics/aberration.ts';
import { observerDoppler } from '../../../src/physics/optics/doppler.ts';
import { brdfOf, evaluateBrdf } from '../../../src/reference/materials/brdf.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import { blackbody } from '../../../src/scene/stars/blackbody.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { filterFromRgb } from '../../../src/spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../../../src/spectrum/sources/lightSpectrum.ts';
import { dome, GREY, lambert, lit } from '../../support/lightKit.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { MATERIALS, NIGHT, radianceOf, type SeenPoint, SIZE, type SkyFlight, seenPoints } from './movingSkyScenes.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

/** Directions of the world of equal solid angle. */
const ROWS = 48;
const DIRECTIONS = Array.from({ length: 2 * ROWS * ROWS }, (_, k): Vec3 => {
  const h = 1 - (2 * (Math.floor(k / (2 * ROWS)) + 0.5)) / ROWS;
  const phi = (Math.PI * ((k % (2 * ROWS)) + 0.5)) / ROWS;
  const level = Math.sqrt(1 - h * h);
  return [level * Math.cos(phi), h, level * Math.sin(phi)];
});

/** What is seen with D of a blackbody of T [K], of luminance 1 at rest. */
function lightSeen(T: number, D: number): Vec3 {
  const { color, luminance } = blackbody(T * D);
  return scale(color, luminance / blackbody(T).luminance);
}

/** Light of a sky, as parallel beams: the irradiance of what faces them. */
function beams(sky: SkyFlight['sky']): { n: Vec3; E: Vec3; T: number }[] {
  if (sky !== 'stars') {
    const radiance = radianceOf(sky);
    const area = (4 * Math.PI) / DIRECTIONS.length;
    return DIRECTIONS.map((n) => ({ n, E: scale(radiance(n), area), T: DAYLIGHT.temperature }));
  }
  const { directions, illuminances, temperatures } = NIGHT.stars;
  return Array.from(illuminances, (E, i) => ({
    n: rotate(NIGHT.orientation, [directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]]),
    E: scale([1, 1, 1], E * NIGHT.gain),
    T: temperatures[i],
  }));
}

/** What the observer sees of surface points, by the sum over beams: ∫ f cos θ′ L′ dΩ′ with L′ dΩ′ = D⁴ L dΩ/D², then D_out⁴. */
function integrals({ sky, material, velocity, spectral }: SkyFlight, points: readonly SeenPoint[]): Vec3[] {
  const { baseColor, metallic, roughness, ior = 1.5 } = MATERIALS[material];
  const u = properVelocity(velocity);
  const cells = beams(sky).map(({ n, E, T }) => ({ D: observerDoppler(n, u), E, T, n: aberrate(n, u) }));
  return points.map(({ normal, toward, D: seen }) => {
    const brdf = brdfOf(
      {
        filter: filterFromRgb(baseColor),
        metallic,
        roughness,
        ior,
        normal,
        albedo: baseColor,
        opacity: 1,
        occlusion: 1,
        emissive: ZERO,
        uv: [0, 0],
      },
      negate(aberrate(toward, u)),
    );
    let sum: Vec3 = ZERO;
    for (const { D, E, T, n } of cells) {
      if (dot(normal, n) <= 0) continue;
      const weight = (evaluateBrdf(brdf, n)?.rgb[0] ?? 0) / D ** 2;
      const color = spectral ? lightSeen(T, D * seen) : scale([1, 1, 1], (D * seen) ** 4);
      sum = add(sum, [weight * E[0] * color[0], weight * E[1] * color[1], weight * E[2] * color[2]]);
    }
    return sum;
  });
}

/** Mean difference, relative to the brightest point. */
function difference(flight: SkyFlight, points: readonly SeenPoint[]): number {
  expect(points.length).toBeGreaterThan(40);
  const expected = integrals(flight, points);
  const brightest = Math.max(...expected.flat());
  const far = expected.flatMap((color, k) => color.map((value, i) => Math.abs(value - points[k].light[i]) / brightest));
  const mean = far.reduce((a, b) => a + b) / far.length;
  if (process.env.REPORT) console.log(JSON.stringify(flight), mean.toFixed(4), Math.max(...far).toFixed(3));
  return mean;
}

const compare = async (flight: SkyFlight): Promise<number> => {
  pumpFrame();
  return difference(flight, await seenPoints(headless.renderer, flight));
};

/** Irradiance under a uniform sky of radiance 1, for a normal along (1), against (−1) or across (0) the velocity, over π: closed forms (docs/physics.md §6.8). */
const furnace = (beta: number, way: -1 | 0 | 1): number => {
  const gamma = 1 / Math.sqrt(1 - beta * beta);
  const along = way * beta;
  return way === 0 ? gamma : (3 - along) / (3 * gamma ** 4 * (1 - along) ** 3);
};

describe('a matt plate in a uniform dome', () => {
  it.each(
    [0.3, 0.6, 0.9].flatMap((beta) => [
      { name: 'across', beta, way: 0 as const, velocity: [beta, 0, 0] as Vec3 },
      { name: 'along', beta, way: 1 as const, velocity: [0, 0, beta] as Vec3 },
      { name: 'against', beta, way: -1 as const, velocity: [0, 0, -beta] as Vec3 },
    ]),
  )('its normal $name its velocity, at $beta c', async ({ beta, way, velocity }) => {
    pumpFrame();
    const points = await seenPoints(headless.renderer, { sky: 'white', material: 'matt', velocity, plate: true });
    expect(points.length).toBeGreaterThan(20);
    for (const { light, D } of points)
      expect(Math.abs(light[1] / (0.8 * furnace(beta, way) * D ** 4) - 1)).toBeLessThan(0.01);
  });
});

const ACROSS: Vec3 = [-0.48, 0.36, 0];
const AWAY: Vec3 = [0, -0.5, -0.75];
const FAST: Vec3 = [0.9, 0, 0];

describe('a ball that flies under a sky', () => {
  it.each<SkyFlight & { bound: number }>([
    { sky: 'uniform', material: 'matt', velocity: FAST, bound: 0.005 },
    { sky: 'day', material: 'matt', velocity: ACROSS, bound: 0.01 },
    { sky: 'dark ground', material: 'matt', velocity: AWAY, bound: 0.02 },
    { sky: 'clouds', material: 'matt', velocity: FAST, bound: 0.01 },
    { sky: 'spot', material: 'matt', velocity: ACROSS, bound: 0.02 },
    { sky: 'sun', material: 'matt', velocity: ACROSS, bound: 0.02 },
    { sky: 'white', material: 'matt', velocity: FAST, spectral: true, bound: 0.005 },
    { sky: 'spot', material: 'matt', velocity: ACROSS, spectral: true, bound: 0.02 },
    { sky: 'stars', material: 'matt', velocity: [0, 0, 0], spectral: true, bound: 0.01 },
    { sky: 'stars', material: 'matt', velocity: ACROSS, spectral: true, bound: 0.02 },
    { sky: 'uniform', material: 'rough metal', velocity: ACROSS, bound: 0.02 },
    { sky: 'white', material: 'rough metal', velocity: FAST, spectral: true, bound: 0.01 },
    { sky: 'spot', material: 'rough metal', velocity: ACROSS, bound: 0.02 },
    { sky: 'day', material: 'metal', velocity: ACROSS, bound: 0.02 },
    { sky: 'clouds', material: 'glossy metal', velocity: ACROSS, bound: 0.02 },
    { sky: 'uniform', material: 'glossy metal', velocity: FAST, bound: 0.02 },
    { sky: 'day', material: 'metal', velocity: FAST, bound: 0.02 },
    { sky: 'white', material: 'metal', velocity: FAST, spectral: true, bound: 0.035 },
    { sky: 'white', material: 'metal', velocity: ACROSS, spectral: true, bound: 0.02 },
    { sky: 'uniform', material: 'metal', velocity: [0, 0, 0], bound: 0.005 },
    { sky: 'uniform', material: 'rough metal', velocity: [0, 0, 0], bound: 0.005 },
  ])('$material, $sky, $velocity', async ({ bound, ...flight }) => {
    expect(await compare(flight)).toBeLessThan(bound);
  });
});

describe('what hides the sky hides it from moving surfaces, too', () => {
  it('the light of a matt corner is multiplied by the unoccluded fraction', async () => {
    const motion = {
      kind: 'uniform',
      pose: { position: [1.8, 0, 0], orientation: IDENTITY },
      velocity: [0.6, 0, 0],
    } as const;
    const back = { mesh: plane(4, 4), material: lambert(0.8), motion };
    const floor = { ...back, mesh: plane(4, 4, 'Y') };
    const view = { t: 0, position: [0, 1, 3], u: ZERO, orientation: IDENTITY, lens: perspective(0.8) } as const;
    await headless.renderer.setScene(lit([back, floor], [dome([1, 1, 1])]).scene);
    const lights: Float32Array[] = [];
    for (const occlusionRadius of [0, 1]) {
      pumpFrame();
      headless.renderer.render([view], { ...GREY, grid: false, occlusionRadius }, 1);
      lights.push(await headless.renderer.readAov('beauty'));
    }
    const open = await headless.renderer.readAov('occlusion');
    const seen = [...open.keys()].filter((i) => open[i] > 0.05 && open[i] < 0.9);
    expect(seen.length).toBeGreaterThan(20);
    for (const i of seen) expect(Math.abs(lights[1][3 * i] / lights[0][3 * i] - open[i])).toBeLessThan(0.01);
  });
});

describe('on WebGL2', () => {
  let page: ModulePage | undefined;
  afterAll(() => page?.close());

  it('matt and rough surfaces are lit as by the sum over all directions', async () => {
    page = await openModulePage(fileURLToPath(new URL('./movingSkyPage.ts', import.meta.url)));
    for (const flight of [
      { sky: 'day', material: 'matt', velocity: ACROSS },
      { sky: 'spot', material: 'metal', velocity: ACROSS, spectral: true },
    ] as const) {
      const points = await page.page.evaluate((given) => window.seenPoints(given), flight);
      expect(difference(flight, points)).toBeLessThan(flight.sky === 'day' ? 0.01 : 0.03);
    }
    for (const way of [-1, 1] as const) {
      const plate = { sky: 'white', material: 'matt', velocity: [0, 0, 0.9 * way] as Vec3, plate: true } as const;
      const points = await page.page.evaluate((given) => window.seenPoints(given), plate);
      expect(points.length).toBeGreaterThan(20);
      for (const { light, D } of points)
        expect(Math.abs(light[1] / (0.8 * furnace(0.9, way) * D ** 4) - 1)).toBeLessThan(0.01);
    }
    page.assertHealthy();
  });
});
