import type { Look } from './look.ts';
import { type Levelled, type Plan, Refinement } from './plan.ts';
import type { PlannedBatch } from './showing.ts';

/** A batch that is planned. */
export interface PlannedPart {
  readonly batch: PlannedBatch;
  /** The levels of its leaves are wanted too; else the GPU finds them. */
  readonly levelled: boolean;
}

export interface PlanOrder {
  readonly look: Look;
  /** Whether anything of each batch may be in the picture. */
  readonly seen: readonly boolean[];
}

export interface LevelledPlan extends Plan {
  /** Where they are wanted, and there are leaves. */
  readonly levels?: Levelled;
}

/** undefined: of a batch that is not seen. */
export type PicturePlans = readonly (LevelledPlan | undefined)[];

/** Plans how the batches of a scene are drawn in one picture after another. */
export interface Planner {
  /** What it returns is valid until the next call. */
  plan(order: PlanOrder): PicturePlans;
  /** First triangle of each cluster of a batch, and after the last one the number of triangles. */
  starts(batch: number): Uint32Array;
  dispose(): void;
}

/** Beyond this [px] a budget is not kept. */
const LARGEST_TOLERANCE = 1000;

/** Plans while it is asked to. */
export class LocalPlanner implements Planner {
  private readonly parts: readonly PlannedPart[];
  private readonly refinements: readonly Refinement[];

  constructor(parts: readonly PlannedPart[]) {
    this.parts = parts;
    this.refinements = parts.map(({ batch }) => new Refinement(batch));
  }

  starts(batch: number): Uint32Array {
    return this.refinements[batch].starts;
  }

  /** One tolerance for all batches, or there were cracks. */
  plan({ look, seen }: PlanOrder): PicturePlans {
    for (let tolerance = look.tolerance; ; tolerance *= 2) {
      const most = tolerance < LARGEST_TOLERANCE ? look.budget : Number.POSITIVE_INFINITY;
      const plans = this.refinements.map((r, i) => (seen[i] ? r.plan(look, tolerance, most) : undefined));
      const count = plans.reduce((n, plan) => n + (plan?.count ?? 0), 0);
      if (count <= most) return plans.map((plan, i) => plan && this.levelled(plan, i, look));
    }
  }

  dispose(): void {}

  private levelled(plan: Plan, i: number, look: Look): LevelledPlan {
    if (!this.parts[i].levelled || plan.count === 0) return plan;
    return { ...plan, levels: this.refinements[i].levelled(plan, look) };
  }
}
