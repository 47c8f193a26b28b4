import { afterAll, beforeAll, describe, it } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { NAMES, openExample } from '../examples/open.ts';
import { BETAS, exampleFrame, VIEWS } from './frames.ts';
import { expectRight, judgeFrame, openStage, Report, type Stage, withPainters } from './visual.ts';

/** Every pixel of small frames; half a pixel here is eight times as wide as at full size, and the renderer cuts as coarsely. */
const SIZE = { width: 160, height: 90 };

const painters = withPainters();

describe.each(NAMES)('%s, every pixel against the reference', (name) => {
  let scene: Scene;
  let stage: Stage;
  const report = new Report();
  beforeAll(async () => {
    scene = await openExample(name);
    stage = await openStage(scene, painters);
  });
  afterAll(() => report.print());

  const cases = VIEWS.flatMap((view) => BETAS.map((beta) => [view, beta] as const));
  it.each(cases)('%s at %s c', async (view, beta) => {
    const tallies = await judgeFrame(stage, exampleFrame(name, scene, view, beta), SIZE);
    report.add(`${name}, ${view}, ${beta} c`, tallies);
    expectRight(tallies);
  });
});
