import { afterAll, beforeAll, describe, it } from 'vitest';
import { EXTRA_SCENES } from './extraScenes.ts';
import { BETAS, extraFrame } from './frames.ts';
import {
  type ComparedScene,
  expectWithinTolerance,
  judgeFrame,
  openComparedScene,
  Report,
  withRasterizers,
} from './visual.ts';

const SIZE = { width: 160, height: 90 };

const rasterizers = withRasterizers();

/** λ of the view from slice to cone, in turn. */
const CONE_SLOPES = [0.5, 0.1, 0.8, 0.95, 0.3, 0.99];

describe.each(EXTRA_SCENES.map((extra, i) => [extra.scene.name, extra, i] as const))('%s', (name, extra, index) => {
  let stage: ComparedScene;
  const report = new Report();
  beforeAll(async () => {
    stage = await openComparedScene(extra.scene, rasterizers);
  });
  afterAll(() => report.print(name));

  const cases = [
    ...BETAS.map((beta) => ['light-cone', beta] as const),
    ['simultaneity', 0.9] as const,
    ['slice-to-cone', 0.9] as const,
  ];
  it.each(cases)('%s at %s c', async (view, beta) => {
    const tallies = await judgeFrame(
      stage,
      extraFrame(extra, view, beta, CONE_SLOPES[index % CONE_SLOPES.length]),
      SIZE,
    );
    report.add(`${view} ${beta} c`, tallies);
    expectWithinTolerance(tallies);
  });
});
