import { EdgeCriterion, KEEP, SPLIT } from '../criterion/edgeCriterion.ts';
import { POINT_FLOATS, type ProjectedBody } from '../criterion/projectedBody.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';
import { MAX_LOG2_FACTOR, MAX_SUBDIVISIONS, type PatchList } from './patch.ts';

/** Largest number of segments of a patch's edge. */
const MAX_FACTOR = 1 << MAX_LOG2_FACTOR;
/** Weights are multiples of this. */
const WEIGHT_STEP = 2 ** -MAX_SUBDIVISIONS;

/**
 * Splits the triangles of one body into patches until tessellation factors can do the rest. Each edge is decided on by itself and split at its middle, so the
 * triangles on both sides, of any mesh, are split at the same points.
 */
export class Subdivider {
  private readonly body: ProjectedBody;
  private readonly criterion: EdgeCriterion;
  private readonly out: PatchList;
  private readonly maxPatches: number;
  private readonly instance: number;
  private points = new Float64Array(64 * POINT_FLOATS);
  private used = 0;
  private triangle = 0;
  private whole = true;

  /** Stops when `out` has more than `maxPatches` patches; `instance` is stored in all of them (patch.ts). */
  constructor(body: ProjectedBody, metric: ScreenMetric, out: PatchList, maxPatches: number, instance = 0) {
    this.body = body;
    this.criterion = new EdgeCriterion(metric);
    this.out = out;
    this.maxPatches = maxPatches;
    this.instance = instance;
  }

  /** Adds the patches of one triangle, given by its index and its vertices. Returns whether the triangle may as well be drawn as it is. */
  subdivide(triangle: number, a: number, b: number, c: number): boolean {
    this.body.setTriangle(a, b, c);
    if (this.body.isBackFacing()) return true;
    this.triangle = triangle;
    this.used = 0;
    this.whole = true;
    this.split(this.add(0, 0), this.add(1, 0), this.add(0, 1), 0);
    return this.whole;
  }

  /** `settled`: bits of the edges 0–1, 1–2, 2–0 that are already known not to be split. */
  private split(a: number, b: number, c: number, settled: number): void {
    if (this.out.count > this.maxPatches || this.body.isOutsideUncut(this.points, a, b, c)) return;
    const ab = (settled & 1) === 0 && this.mustSplit(a, b);
    const bc = (settled & 2) === 0 && this.mustSplit(b, c);
    const ca = (settled & 4) === 0 && this.mustSplit(c, a);
    const before = this.used;
    if (ab && bc && ca) this.splitInFour(a, b, c);
    else if (ab && ca) this.splitInThree(a, b, c);
    else if (bc && ab) this.splitInThree(b, c, a);
    else if (ca && bc) this.splitInThree(c, a, b);
    else if (bc) this.splitInTwo(a, b, c);
    else if (ca) this.splitInTwo(b, c, a);
    else if (ab) this.splitInTwo(c, a, b);
    else if (!this.body.isOutside(this.points, a, b, c))
      this.out.add(this.triangle, this.points, a, b, c, this.instance);
    this.used = before;
  }

  private splitInFour(a: number, b: number, c: number): void {
    const [ab, bc, ca] = [this.midpoint(a, b), this.midpoint(b, c), this.midpoint(c, a)];
    this.split(a, ab, ca, 0);
    this.split(ab, b, bc, 0);
    this.split(ca, bc, c, 0);
    this.split(ab, bc, ca, 0);
  }

  /** Splits all edges but b–c; the remaining quadrilateral is split along its shorter diagonal. */
  private splitInThree(a: number, b: number, c: number): void {
    const [ab, ca] = [this.midpoint(a, b), this.midpoint(c, a)];
    this.split(a, ab, ca, 0);
    if (this.distance(b, ca) <= this.distance(c, ab)) {
      this.split(ab, b, ca, 0);
      this.split(b, c, ca, 1);
    } else {
      this.split(ab, b, c, 2);
      this.split(ab, c, ca, 0);
    }
  }

  /** Splits the edge b–c only. */
  private splitInTwo(a: number, b: number, c: number): void {
    const bc = this.midpoint(b, c);
    this.split(a, b, bc, 1);
    this.split(a, bc, c, 4);
  }

  private mustSplit(a: number, b: number): boolean {
    const p = this.points;
    const divisible = isWeight(0.5 * (p[a + 6] + p[b + 6])) && isWeight(0.5 * (p[a + 7] + p[b + 7]));
    const decision = this.criterion.decide(this.body, p, a, b, MAX_FACTOR);
    if (decision !== KEEP) this.whole = false;
    return divisible && decision === SPLIT;
  }

  private midpoint(a: number, b: number): number {
    const p = this.points;
    return this.add(0.5 * (p[a + 6] + p[b + 6]), 0.5 * (p[a + 7] + p[b + 7]));
  }

  private add(w1: number, w2: number): number {
    const at = POINT_FLOATS * this.used++;
    if (at >= this.points.length) {
      const grown = new Float64Array(2 * this.points.length);
      grown.set(this.points);
      this.points = grown;
    }
    this.points[at + 6] = w1;
    this.points[at + 7] = w2;
    this.body.projectPoint(this.points, at);
    return at;
  }

  private distance(a: number, b: number): number {
    const p = this.points;
    return Math.hypot(p[a] - p[b], p[a + 1] - p[b + 1], p[a + 2] - p[b + 2]);
  }
}

const isWeight = (w: number): boolean => Number.isInteger(w / WEIGHT_STEP);
