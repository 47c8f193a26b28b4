import type { TessellationView } from '../criterion/tessellationView.ts';
import type { PlannedBatch } from '../projection/projectBody.ts';
import { BatchPlanner, type PatchesByPattern, type TessellationPlan } from './tessellationPlan.ts';

/** A batch that is planned. */
export interface PlannedPart {
  readonly batch: PlannedBatch;
  /** The levels of its leaves are wanted too; else the GPU finds them. */
  readonly needsFactors: boolean;
}

export interface PlanRequest {
  /** Place of the view in its picture's views. */
  readonly viewIndex: number;
  readonly view: TessellationView;
  /** Whether anything of each batch may be in the picture. */
  readonly visible: readonly boolean[];
}

export interface BatchPlan extends TessellationPlan {
  /** Where they are wanted, and there are leaves. */
  readonly patchesByPattern?: PatchesByPattern;
}

/** undefined: of a batch that is not seen. */
export type FramePlans = readonly (BatchPlan | undefined)[];

/** Plans how the batches of a scene are drawn in one picture after another. */
export interface Planner {
  /** What it returns is valid until the next call. */
  plan(request: PlanRequest): FramePlans;
  /** First triangle of each cluster of a batch, and after the last one the number of triangles. */
  starts(batch: number): Uint32Array;
  dispose(): void;
}

/** Beyond this [px] a budget is not kept. */
const MAX_TOLERANCE = 1000;

/** Plans while it is asked to. */
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

  /** One tolerance for all batches, or there were cracks. */
  plan({ view: look, visible: seen }: PlanRequest): FramePlans {
    for (let tolerance = look.tolerance; ; tolerance *= 2) {
      const most = tolerance < MAX_TOLERANCE ? look.maxPatches : Number.POSITIVE_INFINITY;
      const plans = this.planners.map((r, i) => (seen[i] ? r.plan(look, tolerance, most) : undefined));
      const count = plans.reduce((n, plan) => n + (plan?.count ?? 0), 0);
      if (count <= most) return plans.map((plan, i) => plan && this.withFactors(plan, i, look));
    }
  }

  dispose(): void {}

  private withFactors(plan: TessellationPlan, i: number, look: TessellationView): BatchPlan {
    if (!this.parts[i].needsFactors || plan.count === 0) return plan;
    return { ...plan, patchesByPattern: this.planners[i].groupByPattern(plan, look) };
  }
}
