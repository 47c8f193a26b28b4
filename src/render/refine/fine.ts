import { EdgeCriterion } from './criterion.ts';
import { LEAF_FLOATS, MOST_LEVEL, packLevels } from './leaf.ts';
import type { Gauge } from './look.ts';
import { baseOf, patternOf } from './pattern.ts';
import { POINT, type Shown } from './shown.ts';

/** Finds the levels of leaves' edges, each from the edge alone. */
export class Fine {
  private readonly shown: Shown;
  private readonly criterion: EdgeCriterion;
  private readonly points = new Float64Array(3 * POINT);
  private triangle = -1;
  /** Of the last leaf: those of its edges, packed, and its pattern. */
  levels = 0;
  pattern = 0;

  constructor(shown: Shown, gauge: Gauge) {
    this.shown = shown;
    this.criterion = new EdgeCriterion(gauge);
  }

  /** Levels of leaf i of a list; `corners`: the batch's indices. */
  measure(leaves: Float32Array, i: number, corners: Uint32Array): void {
    const at = LEAF_FLOATS * i;
    const triangle = leaves[at];
    if (triangle !== this.triangle)
      this.shown.take(corners[3 * triangle], corners[3 * triangle + 1], corners[3 * triangle + 2]);
    this.triangle = triangle;
    const p = this.points;
    for (let k = 0; k < 3; k++) {
      p[POINT * k + 6] = leaves[at + 1 + 2 * k];
      p[POINT * k + 7] = leaves[at + 2 + 2 * k];
      this.shown.point(p, POINT * k);
    }
    const l01 = this.level(0, POINT);
    const l12 = this.level(POINT, 2 * POINT);
    const l20 = this.level(2 * POINT, 0);
    this.levels = packLevels(l01, l12, l20);
    this.pattern = patternOf(Math.max(l01, l12, l20), baseOf([l01, l12, l20]));
  }

  private level(a: number, b: number): number {
    const pieces = this.criterion.pieces(this.shown, this.points, a, b);
    let level = 0;
    while (level < MOST_LEVEL && pieces > 1 << level) level++;
    return level;
  }
}
