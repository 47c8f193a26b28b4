import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { NAMES, openExample } from '../examples/open.ts';
import { BETAS, exampleFrame } from './frames.ts';
import type { Measure } from './tally.ts';
import { expectRight, judgeFrame, openStage, Report, type Stage, withPainters } from './visual.ts';

/** Every pixel of small frames; half a pixel here is eight times as wide as at full size, and the renderer cuts as coarsely. */
const SIZE = { width: 160, height: 90 };
const CASES = [
  ...(['light-cone', 'simultaneity'] as const).flatMap((view) => BETAS.map((beta) => [view, beta] as const)),
  ['galilean', 0] as const,
];
/** The doors of the barn start at once with 0.86 c: no speed in between is theirs, and all of them are between the vertices. */
const JUMPING: readonly string[] = ['ladder'];
const JUMPS: readonly Measure[] = ['changing doppler', 'changing velocity'];

const painters = withPainters();

describe.each(NAMES)('%s, every pixel against the reference', (name) => {
  let scene: Scene;
  let stage: Stage;
  const report = new Report();
  beforeAll(async () => {
    scene = await openExample(name);
    stage = await openStage(scene, painters);
  });
  afterAll(() => report.print(name));

  it.each(CASES)('%s at %s c', async (view, beta) => {
    const tallies = await judgeFrame(stage, exampleFrame(name, scene, view, beta), SIZE);
    report.add(`${view} ${beta} c`, tallies);
    expectRight(tallies, JUMPING.includes(name) ? JUMPS : []);
  });

  it('galilean: the same picture at any speed', async () => {
    for (const painter of painters) {
      const [atRest, ...fast] = BETAS.map((beta) => ({ ...exampleFrame(name, scene, 'galilean', beta), ...SIZE }));
      const expected = await painter.take(atRest);
      for (const order of fast) expect(await painter.take(order)).toEqual(expected);
    }
  });
});
