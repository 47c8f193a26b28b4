import { CUT, EdgeCriterion, WHOLE } from './criterion.ts';
import { type LeafList, MOST_HALVINGS, MOST_LEVEL } from './leaf.ts';
import type { Gauge } from './look.ts';
import { POINT, type Shown } from './shown.ts';

/** Of a leaf's edge. */
const MOST_PIECES = 1 << MOST_LEVEL;
/** Weights are multiples of this. */
const FINEST = 2 ** -MOST_HALVINGS;

/**
 * Cuts the triangles of one body until their edges can have the pieces they need. Only edges are decided on, each from itself alone and at its middle,
 * so the triangles on both its sides, of whatever mesh part, are cut at the same points.
 */
export class Coarse {
  private readonly shown: Shown;
  private readonly criterion: EdgeCriterion;
  private readonly out: LeafList;
  private readonly most: number;
  private readonly wearer: number;
  private points = new Float64Array(64 * POINT);
  private used = 0;
  private triangle = 0;
  private whole = true;

  /** It stops when `out` has more leaves than `most`; `wearer`: of all of them (leaf.ts). */
  constructor(shown: Shown, gauge: Gauge, out: LeafList, most: number, wearer = 0) {
    this.shown = shown;
    this.criterion = new EdgeCriterion(gauge);
    this.out = out;
    this.most = most;
    this.wearer = wearer;
  }

  /** Adds the leaves of one triangle, given by its place and its vertices. Tells whether it can as well be drawn as it is. */
  cut(triangle: number, a: number, b: number, c: number): boolean {
    this.shown.take(a, b, c);
    if (this.shown.turnedAway()) return true;
    this.triangle = triangle;
    this.used = 0;
    this.whole = true;
    this.divide(this.add(0, 0), this.add(1, 0), this.add(0, 1), 0);
    return this.whole;
  }

  /** `settled`: bits of the edges 0–1, 1–2, 2–0 that are known not to be cut. */
  private divide(a: number, b: number, c: number, settled: number): void {
    if (this.out.count > this.most || this.shown.surelyOutside(this.points, a, b, c)) return;
    const ab = (settled & 1) === 0 && this.mustCut(a, b);
    const bc = (settled & 2) === 0 && this.mustCut(b, c);
    const ca = (settled & 4) === 0 && this.mustCut(c, a);
    const before = this.used;
    if (ab && bc && ca) this.intoFour(a, b, c);
    else if (ab && ca) this.intoThree(a, b, c);
    else if (bc && ab) this.intoThree(b, c, a);
    else if (ca && bc) this.intoThree(c, a, b);
    else if (bc) this.intoTwo(a, b, c);
    else if (ca) this.intoTwo(b, c, a);
    else if (ab) this.intoTwo(c, a, b);
    else if (!this.shown.outside(this.points, a, b, c)) this.out.add(this.triangle, this.points, a, b, c, this.wearer);
    this.used = before;
  }

  private intoFour(a: number, b: number, c: number): void {
    const [ab, bc, ca] = [this.middle(a, b), this.middle(b, c), this.middle(c, a)];
    this.divide(a, ab, ca, 0);
    this.divide(ab, b, bc, 0);
    this.divide(ca, bc, c, 0);
    this.divide(ab, bc, ca, 0);
  }

  /** All edges but b–c; what is left of the corner at a is cut by its shorter diagonal. */
  private intoThree(a: number, b: number, c: number): void {
    const [ab, ca] = [this.middle(a, b), this.middle(c, a)];
    this.divide(a, ab, ca, 0);
    if (this.apart(b, ca) <= this.apart(c, ab)) {
      this.divide(ab, b, ca, 0);
      this.divide(b, c, ca, 1);
    } else {
      this.divide(ab, b, c, 2);
      this.divide(ab, c, ca, 0);
    }
  }

  /** The edge b–c alone. */
  private intoTwo(a: number, b: number, c: number): void {
    const bc = this.middle(b, c);
    this.divide(a, b, bc, 1);
    this.divide(a, bc, c, 4);
  }

  private mustCut(a: number, b: number): boolean {
    const p = this.points;
    const divisible = isWeight(0.5 * (p[a + 6] + p[b + 6])) && isWeight(0.5 * (p[a + 7] + p[b + 7]));
    const verdict = this.criterion.verdict(this.shown, p, a, b, MOST_PIECES);
    if (verdict !== WHOLE) this.whole = false;
    return divisible && verdict === CUT;
  }

  private middle(a: number, b: number): number {
    const p = this.points;
    return this.add(0.5 * (p[a + 6] + p[b + 6]), 0.5 * (p[a + 7] + p[b + 7]));
  }

  private add(w1: number, w2: number): number {
    const at = POINT * this.used++;
    if (at >= this.points.length) {
      const grown = new Float64Array(2 * this.points.length);
      grown.set(this.points);
      this.points = grown;
    }
    this.points[at + 6] = w1;
    this.points[at + 7] = w2;
    this.shown.point(this.points, at);
    return at;
  }

  private apart(a: number, b: number): number {
    const p = this.points;
    return Math.hypot(p[a] - p[b], p[a + 1] - p[b + 1], p[a + 2] - p[b + 2]);
  }
}

const isWeight = (w: number): boolean => Number.isInteger(w / FINEST);
