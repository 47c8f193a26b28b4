import type { TessellationView } from '../criterion/tessellationView.ts';
import type { PlannedBatch } from '../projection/projectBody.ts';
import { BatchPlanner, type PatchesByPattern, type TessellationPlan } from './tessellationPlan.ts';

/** A batch to plan. */
export interface PlannedPart {
  readonly batch: PlannedBatch;
  /** Whether the plan includes tessellation factors; otherwise the GPU computes them. */
  readonly needsFactors: boolean;
}

export interface PlanRequest {
  /** Index of the view in its picture; undefined for one of many parts of it, of which no plans are kept. */
  readonly viewIndex: number | undefined;
  readonly view: TessellationView;
  /** By batch: whether any of it may be in the picture. */
  readonly visible: readonly boolean[];
}

export interface BatchPlan extends TessellationPlan {
  /** Present if factors are needed and there are patches. */
  readonly patchesByPattern?: PatchesByPattern;
}

/** By batch; undefined if the batch is not visible. */
export type FramePlans = readonly (BatchPlan | undefined)[];

/** Plans how the batches of a scene are drawn in one picture after another. */
export interface Planner {
  /** The result is valid until the next call. */
  plan(request: PlanRequest): FramePlans;
  /** Whether a plan that fits the view better than its last one is being made. */
  awaitsBetter(viewIndex: number): boolean;
  /** First triangle of each cluster of a batch, and after the last one the number of triangles. */
  starts(batch: number): Uint32Array;
  dispose(): void;
}

/** The patch budget is ignored once the tolerance reaches this [px]. */
const MAX_TOLERANCE = 1000;

/** Plans synchronously on the calling thread. */
export class LocalPlanner implements Planner {
  private readonly parts: readonly PlannedPart[];
  private readonly planners: readonly BatchPlanner[];

  constructor(parts: readonly PlannedPart[]) {
    this.parts = parts;
    this.planners = parts.map(({ batch }) => new BatchPlanner(batch));
  }

  starts(batch: number): Uint32Array {
    return this.planners[batch].starts;
  }

  awaitsBetter(): boolean {
    return false;
  }

  /** Uses one tolerance for all batches, because different ones would leave cracks. */
  plan({ view, visible }: PlanRequest): FramePlans {
    for (let tolerance = view.tolerance; ; tolerance *= 2) {
      const maxPatches = tolerance < MAX_TOLERANCE ? view.maxPatches : Number.POSITIVE_INFINITY;
      const plans = this.planners.map((r, i) => (visible[i] ? r.plan(view, tolerance, maxPatches) : undefined));
      const count = plans.reduce((n, plan) => n + (plan?.count ?? 0), 0);
      if (count <= maxPatches) return plans.map((plan, i) => plan && this.withFactors(plan, i, view));
    }
  }

  dispose(): void {}

  private withFactors(plan: TessellationPlan, i: number, view: TessellationView): BatchPlan {
    if (!this.parts[i].needsFactors || plan.count === 0) return plan;
    return { ...plan, patchesByPattern: this.planners[i].groupByPattern(plan, view) };
  }
}
