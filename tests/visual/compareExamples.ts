import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { type ExampleName, openExample } from '../examples/open.ts';
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

/** All pixels of small frames; half a pixel is eight times as wide as at full size, and the tessellation as coarse. */
const SIZE = { width: 160, height: 90 };
/** The size for which the renderer's goal is stated. */
const FULL_SIZE = { width: 1280, height: 720 };
/** Enough to measure a fraction of a thousandth; all pixels would take minutes. */
const SAMPLE = somePixels(FULL_SIZE, 4000, 20_260_727);
const CASES = [
  ...(['light-cone', 'simultaneity'] as const).flatMap((view) => BETAS.map((beta) => [view, beta] as const)),
  ['galilean', 0] as const,
];
/** The barn's doors start instantly at 0.86 c: interpolation between vertices yields all speeds in between, which are wrong. */
const JUMPING: readonly string[] = ['ladder'];
const JUMPS: readonly Measure[] = ['changing doppler', 'changing velocity'];

/** Compares scenes of the gallery with the reference. They are divided among files, which run at the same time. */
export function compareExamples(names: readonly ExampleName[]): void {
  const rasterizers = withRasterizers();
  describe.each(names)('%s against the reference', (name) => {
    let scene: Scene;
    let stage: ComparedScene;
    const report = new Report();
    beforeAll(async () => {
      scene = await openExample(name);
      stage = await openComparedScene(scene, rasterizers);
    });
    afterAll(() => report.print(name));

    it.each(CASES)('every pixel, %s at %s c', async (view, beta) => {
      const tallies = await judgeFrame(stage, exampleFrame(name, scene, view, beta), SIZE);
      report.add(`${view} ${beta} c`, tallies);
      expectWithinTolerance(tallies, JUMPING.includes(name) ? JUMPS : []);
    });

    it('galilean view: the same picture at any speed', async () => {
      for (const rasterizer of rasterizers) {
        const [atRest, fast] = [0, 0.99].map((beta) => ({ ...exampleFrame(name, scene, 'galilean', beta), ...SIZE }));
        expect(isSame(await rasterizer.take(fast!), await rasterizer.take(atRest!))).toBe(true);
      }
    });

    // Each backend once: what they share is compared in the small frames.
    it.each([
      [0.9, 'WebGL2'],
      [0.99, 'WebGPU'],
    ] as const)('at full size, at %s c on %s', async (beta, backend) => {
      const only = { ...stage, rasterizers: rasterizers.filter((each) => each.name === backend) };
      const tallies = await judgeFrame(only, exampleFrame(name, scene, 'light-cone', beta), FULL_SIZE, SAMPLE);
      expect([...tallies.keys()]).toEqual([backend]);
      report.add(`light-cone ${beta} c, 1280×720`, tallies);
      expectWithinTolerance(tallies);
    });
  });
}

/** `toEqual` takes seconds for so many values. */
const isSame = (a: Float32Array, b: Float32Array): boolean =>
  a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
