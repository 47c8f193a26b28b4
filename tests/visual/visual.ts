import { afterAll, beforeAll, expect } from 'vitest';
import { random } from '../../src/math/random.ts';
import { type TracedScene, traceable } from '../../src/reference/trace.ts';
import type { Scene } from '../../src/scene/types.ts';
import { speedOfLight } from '../examples/open.ts';
import type { Frame } from './frames.ts';
import { Judge } from './judge.ts';
import { openWebGl, openWebGpu, type Painter } from './painters.ts';
import { claimAt } from './pixels.ts';
import { Tally } from './tally.ts';

/*
 * What the pictures must reach. Goal of the renderer (issue 3): within half a pixel of the reference, but for a thousandth of the pixels; those
 * are where things meet at so flat an angle that f32 decides, or where something narrower than a pixel shows between its neighbours' centres.
 */
const WRONG = 1e-3;
/**
 * SwiftShader, the GPU of these tests on WebGPU, interpolates on a grid of 1/16 pixel: over large triangles up to 3e-3 in time and 4e-4 in D (what llvmpipe
 * draws is a hundred times nearer). f32 adds 1e-6 of the world's time. Between the corners of a piece D bends by as much as half a pixel allows.
 */
const TIME = { most: 3e-3, worst: 3e-2 };
const DOPPLER = { most: 2e-3, worst: 2e-2 };
/** Exact but for interpolation; where a sampled path has a corner, the pixel next to it is of the other piece. */
const VELOCITY = { most: 2e-3, worst: 5e-2 };
/** Mipmaps and anisotropic filters differ between GPUs: nearly all colours must lie between those around. */
const ALBEDO = { slack: 0.08, unfit: 0.02 };
/** Every so many pixels the base colour is asked for, which costs 49 rays. */
const ALBEDO_STEP = 61;

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

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Pictures of one frame by every painter, judged at the given pixels, or at all. */
export async function judgeFrame(
  { traced, painters }: Stage,
  { view, settings }: Frame,
  { width, height }: Size,
  pixels: readonly number[] = Array.from({ length: width * height }, (_, i) => i),
): Promise<ReadonlyMap<Painter['name'], Tally>> {
  const judge = new Judge({ scene: traced, view, settings, width, height });
  const tallies = new Map<Painter['name'], Tally>();
  for (const painter of painters) {
    const values = await painter.take({ view, settings, width, height, pixels });
    const tally = new Tally();
    pixels.forEach((pixel, k) => {
      const claim = claimAt(values, k);
      const verdict = judge.judge(pixel, claim);
      tally.add(pixel, verdict);
      if (verdict.right && claim.object > 0 && k % ALBEDO_STEP === 0)
        tally.addAlbedo(judge.albedoFits(pixel, claim, ALBEDO.slack));
    });
    tallies.set(painter.name, tally);
  }
  return tallies;
}

/** Different pixels of a picture, drawn evenly. */
export function somePixels({ width, height }: Size, count: number, seed: number): readonly number[] {
  const next = random(seed);
  const chosen = new Set<number>();
  while (chosen.size < count) chosen.add(Math.floor(next() * width * height));
  return [...chosen];
}

/** Fails with a line for everything that is not as near as it must be. */
export function expectRight(tallies: ReadonlyMap<string, Tally>): void {
  const complaints = [...tallies].flatMap(([name, tally]) => complaintsOf(tally).map((words) => `${name}: ${words}`));
  if (complaints.length > 0) expect.fail(complaints.join('\n'));
}

function complaintsOf(tally: Tally): string[] {
  const { time, doppler, velocity } = tally;
  const limits: readonly (readonly [what: string, value: number, limit: number])[] = [
    [`share of wrong pixels (places ${tally.wrongPlaces.join(', ')})`, tally.wrong, WRONG],
    ['time, of 99 %', time.most, TIME.most],
    ['time', time.worst, TIME.worst],
    ['D, of 99 %', doppler.most, DOPPLER.most],
    ['D', doppler.worst, DOPPLER.worst],
    ['velocity, of 99 %', velocity.most, VELOCITY.most],
    ['velocity', velocity.worst, VELOCITY.worst],
    ['share of base colours that are not there', tally.albedoUnfit, ALBEDO.unfit],
  ];
  return limits
    .filter(([, value, limit]) => !(value <= limit))
    .map(([what, value, limit]) => `${what}: ${value.toPrecision(3)} instead of at most ${limit}`);
}

/** A line for each picture, printed when a scene is done. */
export class Report {
  private readonly lines: string[] = [];

  add(frame: string, tallies: ReadonlyMap<Painter['name'], Tally>): void {
    for (const [name, tally] of tallies) this.lines.push(`${frame.padEnd(46)} ${name}: ${tally.line()}`);
  }

  print(): void {
    console.log(this.lines.join('\n'));
  }
}
