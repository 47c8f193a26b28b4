import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { dot, length, normalize, type Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { inverseApparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { OVERLAY_COLORS } from '../../../src/spectrum/display/overlayColors.ts';
import { encodeSrgb } from '../../../src/spectrum/display/srgb.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 96;
const FOV = 1.2;
const RADIUS = 1.2;
const CENTER: Vec3 = [-1.2, 0.3, -5];
/** Of a ball that both parts of the slice have a share of. */
const DIVIDED: Vec3 = [0.1, 0.3, -5];
const SETTINGS: RenderSettings = {
  ...DEFAULT_SETTINGS,
  speedOfLight: 1,
  shadows: false,
  occlusionRadius: 0,
  antialiasing: false,
};
const ballAt = (center: Vec3): Scene =>
  makeScene({
    name: 'ball',
    objects: [makeObject({ path: '/ball', mesh: sphere(RADIUS), motion: restingAt(center) })],
  });
const BALL = ballAt(CENTER);
const WALL = makeScene({
  name: 'wall',
  objects: [makeObject({ path: '/wall', mesh: plane(400, 400), motion: restingAt([0, 0, -5]) })],
});

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const viewAt = (beta: Vec3): ViewPoint => ({
  t: 3,
  position: [0, 0, 0],
  u: properVelocity(beta),
  orientation: IDENTITY,
  lens: perspective(FOV),
});

/** Draws as soon as the code of the overlay is there. */
async function draw(scene: Scene, beta: Vec3, settings: Partial<RenderSettings>): Promise<Uint8Array> {
  const { renderer } = headless;
  await renderer.setScene(scene);
  return redraw(beta, settings);
}

async function redraw(beta: Vec3, settings: Partial<RenderSettings>): Promise<Uint8Array> {
  const { renderer } = headless;
  do {
    await new Promise(setImmediate);
    pumpFrame();
    renderer.render([viewAt(beta)], { ...SETTINGS, ...settings });
  } while (renderer.info.waiting);
  return renderer.readPixels();
}

/** Unit direction n′ of a pixel's centre. */
function directionOf(x: number, y: number): Vec3 {
  const tangent = Math.tan(FOV / 2);
  return normalize([tangent * ((2 * x + 1) / SIZE - 1), tangent * (1 - (2 * y + 1) / SIZE), -1]);
}

type Pixels = (x: number, y: number) => boolean;

const colored =
  (pixels: Uint8Array, color: Vec3): Pixels =>
  (x, y) =>
    color.every((linear, k) => Math.abs(pixels[4 * (y * SIZE + x) + k]! - 255 * encodeSrgb(linear)) <= 2);

function near(at: Pixels, x: number, y: number, reach: number): boolean {
  for (let i = -reach; i <= reach; i++)
    for (let j = -reach; j <= reach; j++) {
      const [px, py] = [x + i, y + j];
      if (px >= 0 && py >= 0 && px < SIZE && py < SIZE && at(px, py)) return true;
    }
  return false;
}

/** Pixels beside the border of a region. */
const borderOf =
  (inside: Pixels): Pixels =>
  (x, y) =>
    [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ].some(([i, j]) => inside(x + i!, y + j!) !== inside(x, y));

/** That contours are on the border and all along it, to a pixel. */
function expectContours(drawn: Pixels, border: Pixels): void {
  let found = 0;
  for (let y = 1; y < SIZE - 1; y++)
    for (let x = 1; x < SIZE - 1; x++) {
      if (drawn(x, y)) {
        found++;
        expect([x, y, near(border, x, y, 1)]).toEqual([x, y, true]);
      }
      if (border(x, y)) expect([x, y, near(drawn, x, y, 1)]).toEqual([x, y, true]);
    }
  expect(found).toBeGreaterThan(100);
}

/** The outline of the ball in the slice of simultaneity: an ellipsoid, contracted by γ along x, whose tangent cone from the origin is (n·Ac)² = (n·An)(c·Ac − 1). */
function insideSlice(beta: number, [cx, cy, cz] = CENTER): Pixels {
  const g = 1 / Math.sqrt(1 - beta ** 2);
  const c: Vec3 = [cx / g, cy, cz];
  const map = ([x, y, z]: Vec3): Vec3 => [(x * g ** 2) / RADIUS ** 2, y / RADIUS ** 2, z / RADIUS ** 2];
  return (x, y) => {
    const n = directionOf(x, y);
    return dot(n, map(c)) ** 2 > dot(n, map(n)) * (dot(c, map(c)) - 1);
  };
}

/** The outline of the ball as it is seen: the cone around its centre in the world, aberrated. */
function insideSeen(beta: number): Pixels {
  const cosine = Math.sqrt(1 - (RADIUS / length(CENTER)) ** 2);
  const toCenter = normalize(CENTER);
  const u = properVelocity([beta, 0, 0]);
  return (x, y) => dot(normalize(inverseApparentPosition(directionOf(x, y), u)), toCenter) > cosine;
}

describe('a ghost', () => {
  it('lies on the edges of the picture where all is at rest', async () => {
    const pixels = await draw(BALL, [0, 0, 0], { ghost: 'simultaneity' });
    const object = await headless.renderer.readAov('object');
    expectContours(
      colored(pixels, OVERLAY_COLORS.contour),
      borderOf((x, y) => object[y * SIZE + x]! > 0),
    );
  });

  it('of the slice is the contracted ellipsoid over the ball that is seen', async () => {
    const pixels = await draw(BALL, [0.5, 0, 0], { ghost: 'simultaneity' });
    expectContours(colored(pixels, OVERLAY_COLORS.contour), borderOf(insideSlice(0.5)));
    const object = await headless.renderer.readAov('object');
    const shown = borderOf((x, y) => object[y * SIZE + x]! > 0);
    expectContours(shown, borderOf(insideSeen(0.5)));
  });

  it('of what is seen is an aberrated circle over the slice, without any effect left out', async () => {
    const settings = { view: 'simultaneity', lightDelay: false, aberration: false, ghost: 'light-cone' } as const;
    const pixels = await draw(BALL, [0.5, 0, 0], settings);
    expectContours(colored(pixels, OVERLAY_COLORS.contour), borderOf(insideSeen(0.5)));
  });

  it('costs nothing when it is off, and lies over frame graphs, false colours and every mode of antialiasing', async () => {
    const beta: Vec3 = [0.5, 0, 0];
    const plain = await draw(BALL, beta, {});
    const ghosted = await redraw(beta, { ghost: 'simultaneity' });
    expect(ghosted).not.toEqual(plain);
    const { view, coneSlope, lightDelay, aberration, ...rest } = SETTINGS;
    const other = { ...rest, scene: 0, view: 'galilean', coneSlope, lightDelay, aberration } as const;
    const passes = [{ kind: 'light', buffer: 0, shadows: false, occlusion: false }] as const;
    const frameGraph = { extraBuffers: [other], passes };
    expect(await redraw(beta, { ghost: 'simultaneity', view, frameGraph })).toEqual(ghosted);
    const falseColors = { kind: 'doppler', from: 0.5, to: 2 } as const;
    const colors = await redraw(beta, { ghost: 'simultaneity', falseColors });
    expectContours(colored(colors, OVERLAY_COLORS.contour), borderOf(insideSlice(0.5)));
    expect(await redraw(beta, { ghost: 'simultaneity', antialiasing: true })).not.toEqual(ghosted);
    expect(await redraw(beta, {})).toEqual(plain);
  });
});

describe('past and future', () => {
  it.each([[[0.5, 0, 0]], [[-0.3, 0.4, 0]], [[0.4, 0.3, -0.1]]] as const)(
    'are divided in the slice by the plane through the observer across his velocity %s',
    async (beta) => {
      const plain = await draw(WALL, beta, { view: 'simultaneity' });
      const pixels = await redraw(beta, { view: 'simultaneity', pastFuture: true });
      const ahead: Pixels = (x, y) => dot(directionOf(x, y), beta) > 0;
      const object = await headless.renderer.readAov('object');
      const time = await headless.renderer.readAov('emission_time_relative');
      let [past, future] = [0, 0];
      for (let y = 1; y < SIZE - 1; y++)
        for (let x = 1; x < SIZE - 1; x++) {
          const i = y * SIZE + x;
          if (!object[i] || borderOf(ahead)(x, y)) continue;
          const warmer = (k: number) => pixels[4 * i + k]! - plain[4 * i + k]!;
          expect([x, y, warmer(0) > warmer(2)]).toEqual([x, y, ahead(x, y)]);
          expect(time[i]! > 0).toBe(ahead(x, y));
          if (ahead(x, y)) future++;
          else past++;
        }
      expect(future).toBeGreaterThan(500);
      expect(past).toBeGreaterThan(500);
    },
  );

  it('are not told apart in what is seen, which is all past, but in its ghost', async () => {
    const beta: Vec3 = [0.5, 0, 0];
    const plain = await draw(ballAt(DIVIDED), beta, {});
    expect(await redraw(beta, { pastFuture: true })).toEqual(plain);
    const ghosted = await redraw(beta, { pastFuture: true, ghost: 'simultaneity' });
    const [past, future] = [colored(ghosted, OVERLAY_COLORS.past), colored(ghosted, OVERLAY_COLORS.future)];
    expectContours((x, y) => past(x, y) || future(x, y), borderOf(insideSlice(0.5, DIVIDED)));
    let [left, right] = [0, 0];
    for (let y = 0; y < SIZE; y++)
      for (let x = 0; x < SIZE; x++) {
        if (past(x, y)) left++;
        if (future(x, y)) right++;
        if (past(x, y)) expect(x).toBeLessThanOrEqual(SIZE / 2);
        if (future(x, y)) expect(x).toBeGreaterThanOrEqual(SIZE / 2 - 1);
      }
    expect(Math.min(left, right)).toBeGreaterThan(20);
  });

  it('have no parts for an observer at rest', async () => {
    const plain = await draw(WALL, [0, 0, 0], { view: 'simultaneity' });
    expect(await redraw([0, 0, 0], { view: 'simultaneity', pastFuture: true })).toEqual(plain);
  });
});
