import { afterAll, beforeAll, expect } from 'vitest';
import { type TracedScene, traceable } from '../../src/reference/trace.ts';
import type { Scene } from '../../src/scene/types.ts';
import { speedOfLight } from '../examples/open.ts';
import type { Frame } from './frames.ts';
import { Judge } from './judge.ts';
import { openWebGl, openWebGpu, type Painter } from './painters.ts';
import { allPixels, type Size } from './pixels.ts';
import { MEASURES, type Measure, type Spread, type Tally, tallyOf } from './tally.ts';

/*
 * What the pictures must reach. Goal of the renderer (issue 3): within half a pixel of the reference, but for a thousandth of the pixels; those
 * are where things meet at so flat an angle that f32 decides, or where something narrower than a pixel shows between its neighbours' centres.
 */
const WRONG = 1e-3;
/**
 * Of 99 % of the right pixels, and of all. Time, D and velocity are worked out per pixel from an event that is interpolated between vertices,
 * in f32; SwiftShader, the GPU of these tests on WebGPU, interpolates on a grid of 1/16 pixel, which shows where a surface is seen nearly edge on.
 * The distance is that of the flat pieces, which are off by about as much along the line of sight as across it.
 */
const LIMITS: Record<Measure, Spread> = {
  time: { most: 1e-5, worst: 1e-3 },
  depth: { most: 1e-2, worst: 0.1 },
  doppler: { most: 1e-5, worst: 1e-3 },
  velocity: { most: 1e-5, worst: 1e-3 },
  // From sample to sample a velocity jumps; between vertices whose light left before and after the jump the rasterizer has all that is between.
  'changing doppler': { most: 0.1, worst: 0.25 },
  'changing velocity': { most: 0.12, worst: 0.25 },
};
/** Share of the base colours that may not be between those around: mipmaps and anisotropic filters differ between GPUs. */
const ALBEDO_UNFIT = 0.02;

/** Opens both backends for the tests of a file, and closes them. */
export function withPainters(): readonly Painter[] {
  const painters: Painter[] = [];
  beforeAll(async () => {
    painters.push(await openWebGpu(), await openWebGl());
  });
  afterAll(async () => {
    for (const painter of painters) await painter.close();
  });
  return painters;
}

/** A scene as the reference has it, and on every painter. */
export interface Stage {
  readonly traced: TracedScene;
  readonly painters: readonly Painter[];
}

export async function openStage(scene: Scene, painters: readonly Painter[]): Promise<Stage> {
  for (const painter of painters) await painter.open(scene);
  return { traced: traceable(scene, speedOfLight(scene)), painters };
}

/** Pictures of one frame by every painter, judged at the given pixels, or at all. */
export async function judgeFrame(
  { traced, painters }: Stage,
  { view, settings }: Frame,
  { width, height }: Size,
  pixels: readonly number[] = allPixels({ width, height }),
): Promise<ReadonlyMap<Painter['name'], Tally>> {
  const judge = new Judge({ scene: traced, view, settings, width, height });
  const pictures = await Promise.all(painters.map((p) => p.take({ view, settings, width, height, pixels })));
  return new Map(painters.map(({ name }, i) => [name, tallyOf(judge, pictures[i], pixels)]));
}

/** Fails with a line for everything that is not as near as it must be; `without`: what says nothing here. */
export function expectRight(tallies: ReadonlyMap<string, Tally>, without: readonly Measure[] = []): void {
  const complaints = [...tallies].flatMap(([name, tally]) =>
    complaintsOf(tally, without).map((words) => `${name}: ${words}`),
  );
  if (complaints.length > 0) expect.fail(complaints.join('\n'));
}

function complaintsOf(tally: Tally, without: readonly Measure[]): string[] {
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
 * What became of a scene's pictures, printed when it is done: for each backend a line with the worst of them. SHOW_ERRORS=1 prints a line for every picture.
 */
export class Report {
  private readonly entries: { readonly frame: string; readonly name: Painter['name']; readonly tally: Tally }[] = [];

  add(frame: string, tallies: ReadonlyMap<Painter['name'], Tally>): void {
    for (const [name, tally] of tallies) this.entries.push({ frame, name, tally });
  }

  print(title: string): void {
    const lines = process.env.SHOW_ERRORS
      ? this.entries.map(({ frame, name, tally }) => `${title}, ${frame} · ${name}: ${tally.line()}`)
      : [...new Set(this.entries.map(({ name }) => name))].map((name) => `${title} · ${name}: ${this.worstOf(name)}`);
    console.log(lines.join('\n'));
  }

  private worstOf(painter: Painter['name']): string {
    const own = this.entries.filter(({ name }) => name === painter);
    const most = (value: (tally: Tally) => number) =>
      own.reduce((worst, entry) => (value(entry.tally) > value(worst.tally) ? entry : worst));
    const [wrong, displaced] = [most((t) => t.wrong), most((t) => t.displacement.worst)];
    return [
      `${own.length} pictures`,
      `wrong ≤ ${(100 * wrong.tally.wrong).toFixed(3)} % (${wrong.frame})`,
      `displaced ≤ ${displaced.tally.displacement.worst.toFixed(2)} px (${displaced.frame})`,
    ].join(', ');
  }
}
