import type { PlainNear } from '../dynamics/forces/force.ts';
import { largestWay } from '../dynamics/forces/near.ts';
import { StepFailure } from '../dynamics/methods/method.ts';
import { piercing } from '../dynamics/mover.ts';
import { pointAt, type State, type System } from '../dynamics/system.ts';
import { joined, split, WORDS } from './layout.ts';
import { type Links, linksOf, nearRows } from './links.ts';
import { Passes } from './passes.ts';
import { type Stages, stagesOf } from './stages.ts';

/** Passes that a GPU is given at a time. After them places and momenta are put together in 64 bits, and split anew. */
const MOST_PASSES = 512;
/** Points and links, over all those passes: some hundredths of a second of a small GPU, which has pictures to draw too. */
const MOST_WORK = 3e7;
/** Points may go this share of the reach at which they touch until those that are near are looked for again; and twice as far, so often, where one goes farther in a single step. */
const SKIN = 0.25;
const MOST_WIDENINGS = 8;

/** Takes a system's state from step to step by a splitting, on a GPU. */
export class Machine {
  private readonly links: Links;
  private readonly stages: Stages;
  private readonly passes: Passes;
  private readonly h: number;
  private readonly origins: Float32Array<ArrayBuffer>;
  private readonly changes: Float32Array<ArrayBuffer>;
  private readonly neighbours: Neighbours | undefined;

  /** `shares`: of the method; `h`: of all steps [s]. Throws a SystemError for what a GPU cannot compute. */
  static async on(device: GPUDevice, system: System, shares: readonly number[], h: number): Promise<Machine> {
    const links = linksOf(system);
    const stages = stagesOf(shares, h, system.drag);
    const { begin, within, between, end } = stages;
    const passes = await Passes.on(device, system, links, [begin, ...within, between, end]);
    return new Machine(system, links, stages, passes, h);
  }

  private constructor(system: System, links: Links, stages: Stages, passes: Passes, h: number) {
    this.links = links;
    this.stages = stages;
    this.passes = passes;
    this.h = h;
    this.origins = new Float32Array(WORDS.origin * system.masses.length);
    this.changes = new Float32Array(WORDS.change * system.masses.length);
    this.neighbours = links.near && new Neighbours(links.near, links.placeOf, passes);
  }

  /** Throws a StepFailure where it cannot; the state is then worth nothing. The same to the bit from the same state: nothing is kept from before. */
  async advance(state: State, steps: number): Promise<void> {
    this.neighbours?.forget();
    let most = this.stepsAtOnce();
    for (let left = steps; left > 0; ) {
      const leap = Math.min(most, left);
      if (await this.leap(state, leap)) left -= leap;
      else if (leap > 1) most = leap >> 1;
      else this.neighbours!.widen();
    }
  }

  release(): void {
    this.passes.release();
  }

  /** Some steps at once. Not, where a point went farther than those near it are known for. */
  private async leap(state: State, steps: number): Promise<boolean> {
    const { origins, changes, links, passes, neighbours } = this;
    neighbours?.look(state.x);
    split(state, links.pointAt, origins, changes);
    const passed = await passes.run(origins, changes, this.sequence(steps));
    if (passed.strayed) return false;
    if (passed.pierced !== undefined) {
      const point = links.pointAt[passed.pierced];
      throw piercing(point, 'soon after it was at', pointAt(state.x, point));
    }
    joined(origins, passed.changes, links.pointAt, state);
    state.t += steps * this.h;
    return true;
  }

  private stepsAtOnce(): number {
    const { pointAt, from } = this.links;
    const passes = Math.min(MOST_PASSES, MOST_WORK / (pointAt.length + from[pointAt.length]));
    return Math.max(1, Math.floor((passes - 1) / (this.stages.within.length + 1)));
  }

  /** Which stages so many steps are. */
  private sequence(steps: number): number[] {
    const inner = this.stages.within.map((_, k) => 1 + k);
    const between = 1 + inner.length;
    const row = Array.from({ length: steps }, () => [...inner, between]).flat();
    return [0, ...row.slice(0, -1), between + 1];
  }
}

/** Tells the GPU which points can touch. */
class Neighbours {
  private readonly near: PlainNear;
  private readonly placeOf: Uint32Array;
  private readonly passes: Passes;
  /** Where they were looked for. */
  private at: Float64Array | undefined;
  /** How far points may go from there [m]. */
  private way = 0;
  private widenings = 0;

  constructor(near: PlainNear, placeOf: Uint32Array, passes: Passes) {
    this.near = near;
    this.placeOf = placeOf;
    this.passes = passes;
  }

  forget(): void {
    this.at = undefined;
    this.way = SKIN * this.near.reach;
    this.widenings = 0;
  }

  widen(): void {
    if (++this.widenings > MOST_WIDENINGS)
      throw new StepFailure('infinite', 'points fly apart within one step; take a smaller one');
    this.at = undefined;
    this.way *= 2;
  }

  /** For points that set out from x. */
  look(x: Float64Array): void {
    const gone = this.at ? largestWay(this.at, x) : Number.POSITIVE_INFINITY;
    if (gone <= this.way / 2) {
      this.passes.reach(this.way - gone);
      return;
    }
    this.at = x.slice();
    this.passes.meet(nearRows(this.placeOf, this.near.candidates(x, this.way)));
    this.passes.reach(this.way);
  }
}
