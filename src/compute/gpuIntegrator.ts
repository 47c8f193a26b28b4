import type { NeighborForceData } from '../dynamics/forces/force.ts';
import { maxDisplacement } from '../dynamics/forces/neighborPairs.ts';
import { tunnelingFailure } from '../dynamics/integrator.ts';
import { StepFailure } from '../dynamics/methods/method.ts';
import { pointAt, type State, type System } from '../dynamics/system.ts';
import { msg } from '../messages/message.ts';
import { joinState, splitState, WORDS } from './bufferLayout.ts';
import { type ForceRows, forceRowsOf, neighborRows } from './forceRows.ts';
import { IntegratorPasses } from './integratorPasses.ts';
import { type SplittingStages, splittingStagesOf } from './splittingStages.ts';

/** Passes per submission; after them positions and momenta are recombined in 64 bits and split anew. */
const MAX_PASSES = 512;
/**
 * Limit on points and links over all those passes: some hundredths of a second of a small GPU, which also has to
 * render.
 */
const MAX_WORK = 3e7;
/**
 * Points may travel by this fraction of the contact distance until the neighbour list is rebuilt; doubled up to this
 * many times if a point travels farther in a single step.
 */
const SKIN = 0.25;
const MAX_WIDENINGS = 8;

/** Advances a system's state by a splitting method on a GPU. */
export class GpuIntegrator {
  private readonly links: ForceRows;
  private readonly stages: SplittingStages;
  private readonly passes: IntegratorPasses;
  private readonly h: number;
  private readonly origins: Float32Array<ArrayBuffer>;
  private readonly changes: Float32Array<ArrayBuffer>;
  private readonly neighbors: NeighborList | undefined;

  /** `shares`: fractions of the method; `h`: step size [s]. Throws a SystemError for what a GPU cannot compute. */
  static async create(
    device: GPUDevice,
    system: System,
    fractions: readonly number[],
    h: number,
  ): Promise<GpuIntegrator> {
    const links = forceRowsOf(system);
    const stages = splittingStagesOf(fractions, h, system.drag);
    const { begin, within, between, end } = stages;
    const passes = await IntegratorPasses.create(device, system, links, [begin, ...within, between, end]);
    return new GpuIntegrator(system, links, stages, passes, h);
  }

  private constructor(system: System, links: ForceRows, stages: SplittingStages, passes: IntegratorPasses, h: number) {
    this.links = links;
    this.stages = stages;
    this.passes = passes;
    this.h = h;
    this.origins = new Float32Array(WORDS.origin * system.masses.length);
    this.changes = new Float32Array(WORDS.change * system.masses.length);
    this.neighbors = links.near && new NeighborList(links.near, links.rowOfPoint, passes);
  }

  /** Throws a StepFailure; the state is then invalid. Deterministic: no state is kept between calls. */
  async advance(state: State, steps: number): Promise<void> {
    this.neighbors?.reset();
    let most = this.stepsAtOnce();
    for (let left = steps; left > 0; ) {
      const leap = Math.min(most, left);
      if (await this.runSteps(state, leap)) left -= leap;
      else if (leap > 1) most = leap >> 1;
      else this.neighbors!.widen();
    }
  }

  release(): void {
    this.passes.release();
  }

  /** Runs several steps at once; returns false if a point travelled beyond the validity of the neighbour list. */
  private async runSteps(state: State, steps: number): Promise<boolean> {
    const { origins, changes, links, passes, neighbors } = this;
    neighbors?.update(state.x);
    splitState(state, links.pointOfRow, origins, changes);
    const passed = await passes.run(origins, changes, this.stageSequence(steps));
    if (passed.strayed) return false;
    if (passed.piercedAt !== undefined) {
      const point = links.pointOfRow[passed.piercedAt];
      throw tunnelingFailure(point, msg`soon after it was at`, pointAt(state.x, point));
    }
    joinState(origins, passed.changes, links.pointOfRow, state);
    state.t += steps * this.h;
    return true;
  }

  private stepsAtOnce(): number {
    const { pointOfRow, rowStarts } = this.links;
    const passes = Math.min(MAX_PASSES, MAX_WORK / (pointOfRow.length + rowStarts[pointOfRow.length]));
    return Math.max(1, Math.floor((passes - 1) / (this.stages.within.length + 1)));
  }

  /** Stage indices of that many steps. */
  private stageSequence(steps: number): number[] {
    const inner = this.stages.within.map((_, k) => 1 + k);
    const between = 1 + inner.length;
    const row = Array.from({ length: steps }, () => [...inner, between]).flat();
    return [0, ...row.slice(0, -1), between + 1];
  }
}

/** Neighbour list of points that can come into contact. */
class NeighborList {
  private readonly near: NeighborForceData;
  private readonly placeOf: Uint32Array;
  private readonly passes: IntegratorPasses;
  /** Positions at the last rebuild. */
  private builtAt: Float64Array | undefined;
  /** Maximum travel from there [m]. */
  private margin = 0;
  private widenings = 0;

  constructor(near: NeighborForceData, placeOf: Uint32Array, passes: IntegratorPasses) {
    this.near = near;
    this.placeOf = placeOf;
    this.passes = passes;
  }

  reset(): void {
    this.builtAt = undefined;
    this.margin = SKIN * this.near.cutoff;
    this.widenings = 0;
  }

  widen(): void {
    if (++this.widenings > MAX_WIDENINGS)
      throw new StepFailure('infinite', msg`points fly apart within one step; take a smaller one`);
    this.builtAt = undefined;
    this.margin *= 2;
  }

  /** For points that start at x. */
  update(x: Float64Array): void {
    const gone = this.builtAt ? maxDisplacement(this.builtAt, x) : Number.POSITIVE_INFINITY;
    if (gone <= this.margin / 2) {
      this.passes.setMaxTravel(this.margin - gone);
      return;
    }
    this.builtAt = x.slice();
    this.passes.setNeighbors(neighborRows(this.placeOf, this.near.candidates(x, this.margin)));
    this.passes.setMaxTravel(this.margin);
  }
}
