import { EdgeCriterion } from '../criterion/edgeCriterion.ts';
import { POINT_FLOATS, type ProjectedBody } from '../criterion/projectedBody.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';
import { MAX_LOG2_FACTOR, PATCH_FLOATS, packFactors } from './patch.ts';
import { baseFactorOf, patternIndexOf } from './pattern.ts';

/** Computes the tessellation factors of patches' edges, each from the edge alone. */
export class EdgeFactors {
  private readonly body: ProjectedBody;
  private readonly criterion: EdgeCriterion;
  private readonly points = new Float64Array(3 * POINT_FLOATS);
  private triangle = -1;
  /** Of the last patch: the packed factors of its edges, and its pattern. */
  factors = 0;
  pattern = 0;

  constructor(body: ProjectedBody, metric: ScreenMetric) {
    this.body = body;
    this.criterion = new EdgeCriterion(metric);
  }

  /** Computes the factors of patch i of a list; `corners`: the batch's indices. */
  compute(patches: Float32Array, i: number, indices: Uint32Array): void {
    const at = PATCH_FLOATS * i;
    const triangle = patches[at];
    if (triangle !== this.triangle)
      this.body.setTriangle(indices[3 * triangle], indices[3 * triangle + 1], indices[3 * triangle + 2]);
    this.triangle = triangle;
    const p = this.points;
    for (let k = 0; k < 3; k++) {
      p[POINT_FLOATS * k + 6] = patches[at + 1 + 2 * k];
      p[POINT_FLOATS * k + 7] = patches[at + 2 + 2 * k];
      this.body.projectPoint(p, POINT_FLOATS * k);
    }
    const l01 = this.factorOf(0, POINT_FLOATS);
    const l12 = this.factorOf(POINT_FLOATS, 2 * POINT_FLOATS);
    const l20 = this.factorOf(2 * POINT_FLOATS, 0);
    this.factors = packFactors(l01, l12, l20);
    this.pattern = patternIndexOf(Math.max(l01, l12, l20), baseFactorOf([l01, l12, l20]));
  }

  private factorOf(a: number, b: number): number {
    const segments = this.criterion.segments(this.body, this.points, a, b);
    let log2Factor = 0;
    while (log2Factor < MAX_LOG2_FACTOR && segments > 1 << log2Factor) log2Factor++;
    return log2Factor;
  }
}
