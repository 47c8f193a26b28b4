import { EdgeCriterion } from '../criterion/edgeCriterion.ts';
import { POINT_FLOATS, type ProjectedBody } from '../criterion/projectedBody.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';
import { MAX_LOG2_FACTOR, PATCH_FLOATS, packFactors } from './patch.ts';
import { baseFactorOf, patternIndexOf } from './pattern.ts';

/** Finds the levels of leaves' edges, each from the edge alone. */
export class EdgeFactors {
  private readonly body: ProjectedBody;
  private readonly criterion: EdgeCriterion;
  private readonly points = new Float64Array(3 * POINT_FLOATS);
  private triangle = -1;
  /** Of the last leaf: those of its edges, packed, and its pattern. */
  factors = 0;
  pattern = 0;

  constructor(shown: ProjectedBody, gauge: ScreenMetric) {
    this.body = shown;
    this.criterion = new EdgeCriterion(gauge);
  }

  /** Levels of leaf i of a list; `corners`: the batch's indices. */
  compute(leaves: Float32Array, i: number, corners: Uint32Array): void {
    const at = PATCH_FLOATS * i;
    const triangle = leaves[at];
    if (triangle !== this.triangle)
      this.body.setTriangle(corners[3 * triangle], corners[3 * triangle + 1], corners[3 * triangle + 2]);
    this.triangle = triangle;
    const p = this.points;
    for (let k = 0; k < 3; k++) {
      p[POINT_FLOATS * k + 6] = leaves[at + 1 + 2 * k];
      p[POINT_FLOATS * k + 7] = leaves[at + 2 + 2 * k];
      this.body.projectPoint(p, POINT_FLOATS * k);
    }
    const l01 = this.factorOf(0, POINT_FLOATS);
    const l12 = this.factorOf(POINT_FLOATS, 2 * POINT_FLOATS);
    const l20 = this.factorOf(2 * POINT_FLOATS, 0);
    this.factors = packFactors(l01, l12, l20);
    this.pattern = patternIndexOf(Math.max(l01, l12, l20), baseFactorOf([l01, l12, l20]));
  }

  private factorOf(a: number, b: number): number {
    const pieces = this.criterion.segments(this.body, this.points, a, b);
    let level = 0;
    while (level < MAX_LOG2_FACTOR && pieces > 1 << level) level++;
    return level;
  }
}
