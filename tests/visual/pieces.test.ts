import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { IDENTITY } from '../../src/math/quat.ts';
import { length, type Vec3 } from '../../src/math/vec3.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings } from '../../src/scene/view/view.ts';
import { DATA_SETTINGS } from '../gpu/support/dataSettings.ts';
import type { TestView } from './frames.ts';
import { C, EYE, NOW, PIECE_STARTS, PIECES, WALL_DISTANCE, WALL_LIVES } from './pieceScenes.ts';
import { allPixels, pixelSampleAt } from './pixels.ts';
import {
  type ComparedScene,
  expectWithinTolerance,
  judgeFrame,
  openComparedScene,
  Report,
  withRasterizers,
} from './visual.ts';

const SIZE = { width: 96, height: 64 };
const TAN_Y = 0.8;

const frame = (change: Partial<RenderSettings>, beta: Vec3, t: number): TestView => ({
  view: {
    t,
    position: EYE,
    u: properVelocity(beta),
    orientation: IDENTITY,
    lens: perspective(2 * Math.atan(TAN_Y)),
  },
  settings: { ...DATA_SETTINGS, ...change, speedOfLight: C },
});

/** Of each view, in which a boundary between pieces lies in the picture, or everywhere at once. */
const LOOKS: readonly (readonly [string, Partial<RenderSettings>, beta: Vec3, t: number])[] = [
  ['light-cone', {}, [0, 0, 0], NOW],
  ['light-cone at 0.6 c', {}, [0.3, 0.1, 0.5], NOW],
  ['simultaneity at 0.6 c', { view: 'simultaneity' }, [0.6, 0, 0], PIECE_STARTS[2]],
  ['galilean, between two pieces', { view: 'galilean' }, [0, 0, 0], PIECE_STARTS[2]],
];

const rasterizers = withRasterizers();

describe(PIECES.name, () => {
  let stage: ComparedScene;
  const report = new Report();
  beforeAll(async () => {
    stage = await openComparedScene(PIECES, rasterizers);
  });
  afterAll(() => report.print(PIECES.name));

  it.each(LOOKS)('%s', async (look, change, beta, t) => {
    const tallies = await judgeFrame(stage, frame(change, beta, t), SIZE);
    report.add(look, tallies);
    expectWithinTolerance(tallies);
  });

  it('pieces that were released, because pictures did not show them, are drawn as before', async () => {
    const size = { width: 24, height: 16 };
    for (const rasterizer of stage.rasterizers) {
      const look = (t: number) => rasterizer.take({ ...frame({}, [0, 0, 0], t), ...size });
      const before = await look(NOW);
      for (let i = 0; i < 20; i++) await look(NOW + 9);
      expect(await look(NOW)).toEqual(before);
    }
  });

  it('of a wall that blinks there are the rings whose light has come: birth ≤ t − r/c < death', async () => {
    const wall = new Map(PIECES.objects.map(({ pieceOf }, i) => [i + 1, pieceOf === '/Wall'] as const));
    const isBehind = (object: number): boolean => PIECES.objects[object - 1]?.path === '/Behind';
    for (const rasterizer of stage.rasterizers) {
      const pixels = allPixels(SIZE);
      const values = await rasterizer.take({ ...frame({}, [0, 0, 0], NOW), ...SIZE });
      let [rings, gaps] = [0, 0];
      for (const pixel of pixels) {
        const { object } = pixelSampleAt(values, pixel);
        if (!wall.get(object) && !isBehind(object)) continue;
        const aspect = SIZE.width / SIZE.height;
        const x = ((pixel % SIZE.width) + 0.5) / SIZE.width;
        const y = (Math.floor(pixel / SIZE.width) + 0.5) / SIZE.height;
        const direction: Vec3 = [TAN_Y * aspect * (2 * x - 1), TAN_Y * (1 - 2 * y), -1];
        const emitted = NOW - (WALL_DISTANCE * length(direction)) / C;
        // A pixel is at most so wide in time.
        const margin = 0.03;
        if (
          WALL_LIVES.some(({ birth, death }) => Math.min(Math.abs(emitted - birth), Math.abs(emitted - death)) < margin)
        )
          continue;
        const isThere = WALL_LIVES.some(({ birth, death }) => emitted >= birth && emitted < death);
        expect(wall.get(object), `pixel ${pixel}`).toBe(isThere);
        if (isThere) rings++;
        else gaps++;
      }
      expect(Math.min(rings, gaps)).toBeGreaterThan(200);
    }
  });
});
