import { afterAll, beforeAll, expect } from 'vitest';
import { createTracedScene, type TracedScene } from '../../src/reference/intersection/tracedScene.ts';
import type { Scene } from '../../src/scene/types.ts';
import { speedOfLight } from '../examples/open.ts';
import { ALBEDO_UNFIT, type ErrorTally, MEASURES, type Measure, type Spread, tallyErrors } from './errorTally.ts';
import type { TestView } from './frames.ts';
import { PixelOracle } from './pixelOracle.ts';
import { allPixels, type Size } from './pixels.ts';
import { openWebGl, openWebGpu, type TestRasterizer } from './rasterizers.ts';

/*
 * Acceptance limits. The renderer's goal (issue 3): within half a pixel of the reference, except for a thousandth of the pixels, where surfaces
 * meet at so flat an angle that f32 decides, or where features narrower than a pixel fall between pixel centres.
 */
const WRONG = 1e-3;
/**
 * For 99 % of the right pixels, and for all. Time, distance, D and velocity are computed per pixel in f32 from an event interpolated between
 * vertices; SwiftShader, the GPU of these tests on WebGPU, interpolates on a grid of 1/16 pixel, which matters for surfaces seen nearly edge on.
 */
const LIMITS: Record<Measure, Spread> = {
  time: { most: 1e-5, worst: 1e-3 },
  depth: { most: 1e-5, worst: 1e-3 },
  doppler: { most: 1e-5, worst: 1e-3 },
  velocity: { most: 1e-5, worst: 1e-3 },
  // Velocities jump at samples; between vertices with emission before and after a jump the rasterizer interpolates.
  'changing doppler': { most: 0.1, worst: 0.25 },
  'changing velocity': { most: 0.12, worst: 0.25 },
};

/** Opens both backends for the tests of a file, and closes them. */
export function withRasterizers(): readonly TestRasterizer[] {
  const rasterizers: TestRasterizer[] = [];
  beforeAll(async () => {
    rasterizers.push(await openWebGpu(), await openWebGl());
  });
  afterAll(async () => {
    for (const rasterizer of rasterizers) await rasterizer.close();
  });
  return rasterizers;
}

/** A scene in the reference, and in every rasterizer. */
export interface ComparedScene {
  readonly traced: TracedScene;
  readonly rasterizers: readonly TestRasterizer[];
}

export async function openComparedScene(scene: Scene, rasterizers: readonly TestRasterizer[]): Promise<ComparedScene> {
  for (const rasterizer of rasterizers) await rasterizer.open(scene);
  return { traced: createTracedScene(scene, speedOfLight(scene)), rasterizers };
}

/** Renders one frame with every rasterizer, and judges the given pixels, or all. */
export async function judgeFrame(
  { traced, rasterizers }: ComparedScene,
  { view, settings }: TestView,
  { width, height }: Size,
  pixels: readonly number[] = allPixels({ width, height }),
): Promise<ReadonlyMap<TestRasterizer['name'], ErrorTally>> {
  const judge = new PixelOracle({ scene: traced, view, settings, width, height });
  const pictures = await Promise.all(rasterizers.map((p) => p.take({ view, settings, width, height, pixels })));
  return new Map(rasterizers.map(({ name }, i) => [name, tallyErrors(judge, pictures[i], pixels)]));
}

/** Fails with a line per exceeded limit; `without`: values that are not meaningful here. */
export function expectWithinTolerance(
  tallies: ReadonlyMap<string, ErrorTally>,
  without: readonly Measure[] = [],
): void {
  const complaints = [...tallies].flatMap(([name, tally]) =>
    complaintsOf(tally, without).map((words) => `${name}: ${words}`),
  );
  if (complaints.length > 0) expect.fail(complaints.join('\n'));
}

function complaintsOf(tally: ErrorTally, without: readonly Measure[]): string[] {
  const limits: (readonly [what: string, value: number, limit: number])[] = [
    [`share of wrong pixels (places ${tally.wrongPlaces.join(', ')})`, tally.wrong, WRONG],
    ['share of base colours that are not there', tally.albedoUnfit, ALBEDO_UNFIT],
  ];
  for (const name of MEASURES.filter((measure) => !without.includes(measure))) {
    const { most, worst } = tally.error(name);
    limits.push([`${name} of 99 %`, most, LIMITS[name].most], [name, worst, LIMITS[name].worst]);
  }
  return limits
    .filter(([, value, limit]) => !(value <= limit))
    .map(([what, value, limit]) => `${what}: ${value.toPrecision(3)} instead of at most ${limit}`);
}

/**
 * Results of a scene's pictures, printed at the end: per backend a line with the worst values. SHOW_ERRORS=1 prints a line per picture.
 */
export class Report {
  private readonly entries: {
    readonly frame: string;
    readonly name: TestRasterizer['name'];
    readonly tally: ErrorTally;
  }[] = [];

  add(frame: string, tallies: ReadonlyMap<TestRasterizer['name'], ErrorTally>): void {
    for (const [name, tally] of tallies) this.entries.push({ frame, name, tally });
  }

  print(title: string): void {
    const lines = process.env.SHOW_ERRORS
      ? this.entries.map(({ frame, name, tally }) => `${title}, ${frame} · ${name}: ${tally.line()}`)
      : [...new Set(this.entries.map(({ name }) => name))].map((name) => `${title} · ${name}: ${this.worstOf(name)}`);
    console.log(lines.join('\n'));
  }

  private worstOf(rasterizer: TestRasterizer['name']): string {
    const own = this.entries.filter(({ name }) => name === rasterizer);
    const most = (value: (tally: ErrorTally) => number) =>
      own.reduce((worst, entry) => (value(entry.tally) > value(worst.tally) ? entry : worst));
    const [wrong, displaced] = [most((t) => t.wrong), most((t) => t.displacement.worst)];
    return [
      `${own.length} pictures`,
      `wrong ≤ ${(100 * wrong.tally.wrong).toFixed(3)} % (${wrong.frame})`,
      `displaced ≤ ${displaced.tally.displacement.worst.toFixed(2)} px (${displaced.frame})`,
    ].join(', ');
  }
}
