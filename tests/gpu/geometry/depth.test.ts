import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { IDENTITY } from '../../../src/math/quat.ts';
import { addScaled, cross, dot, length, normalize, scale, type Vec3, ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { unaberrate } from '../../../src/physics/optics/aberration.ts';
import { apparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { ViewPoint } from '../../../src/scene/view/view.ts';
import { DATA_SETTINGS } from '../support/dataSettings.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { type Data, readData } from '../support/readData.ts';
import { BALLS, type Ball, BEHIND, DEPTH_SCENES, DISTANCES, FLOOR, HEIGHT } from './depthScenes.ts';

const SIZE = 96;
const SETTINGS = { ...DATA_SETTINGS, speedOfLight: 1 };
const FOV = 1;
/** Angle of a pixel in the middle of the picture [rad]. */
const PIXEL = (2 * Math.tan(FOV / 2)) / SIZE;

type Paint = (name: string, view: ViewPoint) => Promise<Data>;

/** At the origin, looking along −Z, moving forward at β. */
const ahead = (beta: number): ViewPoint => ({
  t: 0,
  position: ZERO,
  u: properVelocity([0, 0, -beta]),
  orientation: IDENTITY,
  lens: perspective(FOV),
});
const direction = (x: number, y: number): Vec3 =>
  normalize([(x + 0.5 - SIZE / 2) * PIXEL, (SIZE / 2 - y - 0.5) * PIXEL, -1]);
const vector = (of: ArrayLike<number>, i: number): Vec3 => [of[3 * i], of[3 * i + 1], of[3 * i + 2]];
/** Angle between two directions [rad]. */
const angle = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));
const middle = (SIZE / 2) * SIZE + SIZE / 2;

/** Where the observer's ray meets the floor, and the distance from its outline relative to the distance of the point. */
function onFloor(nPrime: Vec3, u: Vec3): { readonly place: Vec3; readonly inside: number } | undefined {
  const n = unaberrate(nPrime, u);
  if (n[1] >= 0) return undefined;
  const place = scale(n, -HEIGHT / n[1]);
  const margins = FLOOR.map(([x0, z0], i) => {
    const [x1, z1] = FLOOR[(i + 1) % 3];
    return ((z1 - z0) * (place[0] - x0) - (x1 - x0) * (place[2] - z0)) / Math.hypot(x1 - x0, z1 - z0);
  });
  return { place, inside: Math.min(...margins) / length(place) };
}

/**
 * How far a place of the picture is outside of a ball's outline [px], for an observer at rest at the origin at t = 0: a cone of directions in the ball's rest
 * frame, where the light that arrives along n comes from along n′ = unaberrate(n).
 */
function pixelsOutside({ center, radius, velocity }: Ball, x: number, y: number): number {
  const u = properVelocity(velocity);
  const resting = addScaled(center, u, dot(center, u) / (1 + Math.hypot(1, length(u))));
  const open = Math.asin(radius / length(resting));
  const beyond = (i: number, j: number): number => angle(unaberrate(direction(i, j), scale(u, -1)), resting) - open;
  const slope = [beyond(x + 0.01, y) - beyond(x - 0.01, y), beyond(x, y + 0.01) - beyond(x, y - 0.01)];
  return (0.02 * beyond(x, y)) / Math.hypot(...slope);
}

function checks(paint: Paint): void {
  it.each(BALLS.map((ball) => [ball.name, ball] as const))(
    'the outline of a %s is right to ¼ pixel',
    async (name, ball) => {
      const { object } = await paint(name, ahead(0));
      const wrong: string[] = [];
      let [inside, outside] = [0, 0];
      for (let i = 0; i < SIZE * SIZE; i++) {
        const pixels = pixelsOutside(ball, i % SIZE, Math.floor(i / SIZE));
        if (pixels < 0) inside++;
        else outside++;
        if (object[i] !== (pixels < 0 ? 1 : 0) && Math.abs(pixels) > 0.25)
          wrong.push(`${i}: ${object[i]} at ${pixels} px`);
      }
      expect(wrong).toEqual([]);
      expect(Math.min(inside, outside)).toBeGreaterThan(SIZE);
    },
  );

  it('a speck is drawn 2 mm in front of the observer, but not 2 mm behind', async () => {
    expect((await paint('speck in front', ahead(0))).object[middle]).toBe(1);
    expect(Math.max(...Array.from((await paint('speck behind', ahead(0))).object))).toBe(0);
  });

  it('the speck hides a wall 10⁹ times as far away, which is visible around it', async () => {
    const { object, depth } = await paint('speck before a wall', ahead(0));
    expect([object[middle], object[0]]).toEqual([1, 2]);
    expect(depth[middle]).toBeCloseTo(2e-3, 5);
    // The wall's corners are hundreds of pixels outside the picture, where SwiftShader rounds to 1/16 pixel.
    expect((-depth[0] * direction(0, 0)[2]) / 1e6).toBeCloseTo(1, 3);
  });

  it.each(DISTANCES)('the nearer of two sheets is visible in every pixel, at %d m', async (distance) => {
    const { object } = await paint(`sheets at ${distance} m`, ahead(0));
    expect(Array.from(object).filter((id) => id !== 1).length).toBe(0);
  });

  it.each([0, 0.5, 0.9, 0.99])('a triangle through the camera plane is complete, at %d c', async (beta) => {
    const view = ahead(beta);
    const { object, position } = await paint('floor', view);
    const wrong: string[] = [];
    let compared = 0;
    for (let y = 0; y < SIZE; y++)
      for (let x = 0; x < SIZE; x++) {
        const i = y * SIZE + x;
        const should = onFloor(direction(x, y), view.u);
        // On its outline a pixel may show either.
        if (should && Math.abs(should.inside) < 0.02 * (1 + Math.abs(view.u[2]))) continue;
        const id = should && should.inside > 0 ? 1 : 0;
        if (object[i] !== id) wrong.push(`${x} ${y}: object ${object[i]}`);
        if (id === 0 || object[i] !== 1) continue;
        compared++;
        const distance = angle(apparentPosition(vector(position, i), view.u), direction(x, y)) / PIXEL;
        if (!(distance < 0.5) || Math.abs(position[3 * i + 1] + HEIGHT) > 1e-3)
          wrong.push(`${x} ${y}: ${distance} pixels`);
      }
    expect(wrong).toEqual([]);
    expect(compared).toBeGreaterThan(SIZE * SIZE * 0.1);
  });

  it('at 0.99 c objects behind come into view, at their aberrated directions', async () => {
    expect(Math.max(...Array.from((await paint('behind', ahead(0))).object))).toBe(0);
    const { object, depth } = await paint('behind', ahead(0.99));
    const ball = Array.from(object).flatMap((id, i) => (id === 1 ? [i] : []));
    expect(ball.length).toBeGreaterThan(4);
    // cos θ′ = (cos θ + β)/(1 + β cos θ); r′ = D r.
    const cosine = (-0.5 + 0.99) / (1 - 0.99 * 0.5);
    const seen = SIZE / 2 + Math.tan(Math.acos(cosine)) / PIXEL;
    const mean = ball.reduce((sum, i) => sum + (i % SIZE) + 0.5, 0) / ball.length;
    expect(Math.abs(mean - seen)).toBeLessThan(1);
    const factor = (1 - 0.99 * 0.5) / Math.sqrt(1 - 0.99 ** 2);
    const nearest = Math.min(...ball.map((i) => depth[i]));
    expect(nearest / (factor * length(BEHIND))).toBeGreaterThan(0.8);
    expect(nearest / (factor * length(BEHIND))).toBeLessThan(1);
  });
}

describe('depth: WebGPU (Dawn)', () => {
  let headless: HeadlessPictures;
  beforeAll(async () => {
    headless = await openPictures(SIZE, SIZE);
  });
  afterAll(() => headless?.close());

  checks(async (name, view) => {
    const scene = DEPTH_SCENES.find((candidate) => candidate.name === name);
    if (!scene) throw new Error(`no scene is called ${name}`);
    await headless.renderer.setScene(scene);
    return readData(headless.renderer, view, SETTINGS);
  });
});

describe('depth: WebGL2 (Chromium)', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./depthPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());

  const inPage =
    (clipControl: boolean): Paint =>
    async (name, view) => {
      const data = await chromium.page.evaluate(
        ([of, at, how, size, control]) => window.renderDepth(of, at, how, size, control),
        [name, view, SETTINGS, SIZE, clipControl] as const,
      );
      chromium.assertHealthy();
      return data;
    };

  describe('reversed', () => checks(inPage(true)));
  describe('without EXT_clip_control', () => checks(inPage(false)));
});
