import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { NAMES, openExample } from '../examples/open.ts';
import type { Measure } from './errorTally.ts';
import { BETAS, exampleFrame } from './frames.ts';
import { somePixels } from './pixels.ts';
import {
  type ComparedScene,
  expectWithinTolerance,
  judgeFrame,
  openComparedScene,
  Report,
  withRasterizers,
} from './visual.ts';

/** Every pixel of small frames; half a pixel here is eight times as wide as at full size, and the renderer cuts as coarsely. */
const SIZE = { width: 160, height: 90 };
/** The renderer's goal is told for this size. */
const FULL_SIZE = { width: 1280, height: 720 };
/** Enough to tell a share of a thousandth; all of them would take minutes. */
const SAMPLE = somePixels(FULL_SIZE, 4000, 20_260_727);
const CASES = [
  ...(['light-cone', 'simultaneity'] as const).flatMap((view) => BETAS.map((beta) => [view, beta] as const)),
  ['galilean', 0] as const,
];
/** The doors of the barn start at once with 0.86 c: no speed in between is theirs, and all of them are between the vertices. */
const JUMPING: readonly string[] = ['ladder'];
const JUMPS: readonly Measure[] = ['changing doppler', 'changing velocity'];

const painters = withRasterizers();

describe.each(NAMES)('%s against the reference', (name) => {
  let scene: Scene;
  let stage: ComparedScene;
  const report = new Report();
  beforeAll(async () => {
    scene = await openExample(name);
    stage = await openComparedScene(scene, painters);
  });
  afterAll(() => report.print(name));

  it.each(CASES)('every pixel, %s at %s c', async (view, beta) => {
    const tallies = await judgeFrame(stage, exampleFrame(name, scene, view, beta), SIZE);
    report.add(`${view} ${beta} c`, tallies);
    expectWithinTolerance(tallies, JUMPING.includes(name) ? JUMPS : []);
  });

  it('galilean: the same picture at any speed', async () => {
    for (const painter of painters) {
      const [atRest, ...fast] = BETAS.map((beta) => ({ ...exampleFrame(name, scene, 'galilean', beta), ...SIZE }));
      const expected = await painter.take(atRest);
      for (const order of fast) expect(isSame(await painter.take(order), expected)).toBe(true);
    }
  });

  it.each([0.9, 0.99])('at full size, at %s c', async (beta) => {
    const tallies = await judgeFrame(stage, exampleFrame(name, scene, 'light-cone', beta), FULL_SIZE, SAMPLE);
    report.add(`light-cone ${beta} c, 1280×720`, tallies);
    expectWithinTolerance(tallies);
  });
});

/** `toEqual` takes seconds over so many. */
const isSame = (a: Float32Array, b: Float32Array): boolean =>
  a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
