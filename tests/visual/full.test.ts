import { afterAll, beforeAll, describe, it } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { NAMES, openExample } from '../examples/open.ts';
import { exampleFrame } from './frames.ts';
import { somePixels } from './pixels.ts';
import { expectRight, judgeFrame, openStage, Report, type Stage, withPainters } from './visual.ts';

/** The renderer's goal is told for this size. */
const SIZE = { width: 1280, height: 720 };
/** Enough to tell a share of a thousandth; all of them would take minutes. */
const SAMPLE = somePixels(SIZE, 4000, 20_260_727);

const painters = withPainters();

describe.each(NAMES)('%s at full size', (name) => {
  let scene: Scene;
  let stage: Stage;
  const report = new Report();
  beforeAll(async () => {
    scene = await openExample(name);
    stage = await openStage(scene, painters);
  });
  afterAll(() => report.print(`${name}, 1280×720`));

  it.each([0.9, 0.99])('at %s c', async (beta) => {
    const tallies = await judgeFrame(stage, exampleFrame(name, scene, 'light-cone', beta), SIZE, SAMPLE);
    report.add(`light-cone ${beta} c`, tallies);
    expectRight(tallies);
  });
});
