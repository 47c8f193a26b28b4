import type { Quat } from '../../math/quat.ts';
import type { Batch } from '../batches.ts';
import type { Sight } from '../sight.ts';
import type { Projection } from '../vertexStage.ts';
import { LEAF_FLOATS, LeafList, MOST_LEVEL } from './leaf.ts';

/** How a picture is looked at, as far as its edges' cutting goes. */
export interface Look {
  readonly sight: Sight;
  readonly projection: Projection;
  /** Camera axes (−Z forward, +Y up) against the world axes carried by the pure boost. */
  readonly orientation: Quat;
  /** Tangents of half the angles of view. */
  readonly tanX: number;
  readonly tanY: number;
  /** Pixels per unit tangent: height / (2 tanY). */
  readonly focal: number;
  /** How far a straight edge may be from the curve that is seen [px]. */
  readonly tolerance: number;
  /** Most leaves of a picture; where more were needed, the tolerance is doubled until there are not. */
  readonly budget: number;
}

/** What becomes of a cluster in a picture. */
export const DRAWN = 0;
/** Its triangles are among the leaves. */
export const REFINED = 1;
/** It is surely outside the picture. */
export const OUTSIDE = 2;

/** How one batch is drawn in one picture. */
export interface Plan {
  /** Nothing needs cutting and nothing is outside: draw the batch as it is. */
  readonly whole: boolean;
  /** Per cluster DRAWN, REFINED or OUTSIDE. */
  readonly clusters: Uint8Array;
  /** 8 floats each (leaf.ts), in the order of their triangles; valid until the next plan. */
  readonly leaves: Float32Array;
  readonly count: number;
  /** The tolerance that the budget allowed [px]; the levels are found for it. */
  readonly tolerance: number;
}

/** Leaves by the level of their interiors, 0 … MOST_LEVEL, the levels of their edges filled in; valid until the next call. */
export type Levelled = readonly LeafList[];

/** Most triangles of a cluster. */
const CLUSTER = 128;

/** One batch: its clusters, and what they need in a picture. */
export class Refinement {
  /** First triangle of each cluster, and after the last one the number of triangles. A cluster has triangles of one body. */
  readonly starts: Uint32Array;
  private readonly leaves = new LeafList();
  private readonly levels: Levelled = Array.from({ length: MOST_LEVEL + 1 }, () => new LeafList());

  constructor({ arrays }: Batch) {
    const triangles = arrays.indices.length / 3;
    const starts: number[] = [];
    for (let t = 0; t < triangles; t++) {
      const body = arrays.ids[2 * arrays.indices[3 * t]];
      const before = t > 0 ? arrays.ids[2 * arrays.indices[3 * t - 3]] : -1;
      if (body !== before || t - starts[starts.length - 1] >= CLUSTER) starts.push(t);
    }
    this.starts = Uint32Array.from([...starts, triangles]);
  }

  /** `tolerance` [px]: that of the look, or more where the budget asks for it. */
  plan(look: Look, tolerance = look.tolerance): Plan {
    this.leaves.clear();
    for (let t = 0; t < this.starts[this.starts.length - 1]; t++) this.leaves.addWhole(t);
    const clusters = new Uint8Array(this.starts.length - 1).fill(REFINED);
    return { whole: false, clusters, leaves: this.leaves.leaves, count: this.leaves.count, tolerance };
  }

  /** The levels of a plan's leaves, for the same look. */
  levelled(plan: Plan, _look: Look): Levelled {
    for (const list of this.levels) list.clear();
    for (let i = 0; i < plan.count; i++) this.levels[0].copy(plan.leaves, i, plan.leaves[LEAF_FLOATS * i + 7]);
    return this.levels;
  }
}

/** The plans of all batches of a picture that may be seen (undefined: a batch that is not). One tolerance for all, or there were cracks. */
export function planPicture(refinements: readonly (Refinement | undefined)[], look: Look): (Plan | undefined)[] {
  for (let tolerance = look.tolerance; ; tolerance *= 2) {
    const plans = refinements.map((r) => r?.plan(look, tolerance));
    const count = plans.reduce((n, plan) => n + (plan?.count ?? 0), 0);
    if (count <= look.budget || tolerance > 1e3) return plans;
  }
}
