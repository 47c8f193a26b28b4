import type { MovingBody } from '../bodies.ts';
import { Clusters, lumpsOf, type Run, together } from './clusters.ts';
import { Coarse } from './coarse.ts';
import { DeformingLumps } from './deformingLumps.ts';
import { Fine } from './fine.ts';
import { LEAF_FLOATS, LeafList, WEARER_AT } from './leaf.ts';
import { type Gauge, gaugeOf, type Look } from './look.ts';
import { PATTERNS } from './pattern.ts';
import { type PlannedBatch, showing, windowOf } from './showing.ts';
import { DRAWN, type Lump, OUTSIDE, REFINED, type Shown } from './shown.ts';

/** How one batch is drawn in one picture. */
export interface Plan {
  /** Every cluster is DRAWN. */
  readonly whole: boolean;
  /** The Fate of each cluster; where many wear the mesh, of all clusters of the first body, then of the second … */
  readonly clusters: Uint8Array;
  /** As in leaf.ts, in the order of their bodies and triangles; valid until the next plan. */
  readonly leaves: Float32Array;
  readonly count: number;
  /** The tolerance that the budget allowed [px]; the levels are found for it. */
  readonly tolerance: number;
}

/** Leaves by their patterns (pattern.ts), the levels of their edges filled in; valid until the next call. */
export type Levelled = readonly Leaves[];
/** As in leaf.ts. */
export interface Leaves {
  readonly leaves: Float32Array;
  readonly count: number;
}

/** One batch: its clusters, and what they need in a picture. */
export class Refinement {
  private readonly batch: PlannedBatch;
  private readonly bodies: ReadonlyMap<number, MovingBody>;
  private readonly clusters: Clusters;
  /** Of each cluster, where the mesh does not deform, and of each run. */
  private readonly lumps: readonly Lump[];
  private readonly whole: readonly Lump[];
  private readonly deforming: DeformingLumps | undefined;
  private readonly fates: Uint8Array;
  private readonly leaves = new LeafList();
  private readonly levels: readonly LeafList[] = PATTERNS.map(() => new LeafList());

  constructor(batch: PlannedBatch) {
    const { arrays, bodies, worn } = batch;
    this.batch = batch;
    this.bodies = new Map(bodies.map((body) => [body.id, body]));
    this.clusters = new Clusters(batch);
    this.fates = new Uint8Array(this.clusters.fates);
    const { motion } = bodies[0].object;
    const deforms = motion.kind === 'sampled-points';
    this.deforming = deforms ? new DeformingLumps(this.clusters, arrays.indices, motion) : undefined;
    this.lumps = deforms ? [] : lumpsOf(this.clusters, arrays);
    const wholeOf = ({ from, first, end }: Run): Lump => together(this.lumps.slice(from, from + end - first));
    const all = deforms ? [] : this.clusters.runs.slice(0, worn ? 1 : undefined).map(wholeOf);
    this.whole = worn ? this.clusters.runs.map(() => all[0]) : all;
  }

  /** First triangle of each cluster, and after the last one the number of triangles. */
  get starts(): Uint32Array {
    return this.clusters.starts;
  }

  /** `tolerance` [px]: that of the look, or more where the budget asks for it. Stops when there are more leaves than `most`. */
  plan(look: Look, tolerance = look.tolerance, most = Number.POSITIVE_INFINITY): Plan {
    const gauge = gaugeOf(look, tolerance);
    this.leaves.clear();
    for (let r = 0; r < this.clusters.runs.length; r++) this.planRun(r, gauge, most);
    const { leaves, count } = this.leaves;
    return { whole: this.fates.every((f) => f === DRAWN), clusters: this.fates, leaves, count, tolerance };
  }

  /** The levels of a plan's leaves, for the same look. */
  levelled({ leaves, count, tolerance }: Plan, look: Look): Levelled {
    const gauge = gaugeOf(look, tolerance);
    const { bodies, worn } = this.batch;
    const { indices, ids } = this.batch.arrays;
    for (const list of this.levels) list.clear();
    let fine: Fine | undefined;
    let body = -1;
    for (let i = 0; i < count; i++) {
      const at = LEAF_FLOATS * i;
      const owner = worn ? bodies[leaves[at + WEARER_AT]].id - 1 : ids[2 * indices[3 * leaves[at]]];
      if (owner !== body) {
        const shown = this.shown(owner, gauge);
        fine = shown && new Fine(shown, gauge);
        body = owner;
      }
      fine?.measure(leaves, i, indices);
      if (fine) this.levels[fine.pattern].copy(leaves, i, fine.levels);
    }
    return this.levels;
  }

  private shown(body: number, gauge: Gauge): Shown | undefined {
    const found = this.bodies.get(body + 1);
    return found && showing(found, this.batch, gauge);
  }

  private planRun(r: number, gauge: Gauge, most: number): void {
    const run = this.clusters.runs[r];
    const shown = this.shown(run.body, gauge);
    if (!shown) {
      this.fates.fill(OUTSIDE, run.first, run.end);
      return;
    }
    this.decide(r, shown, gauge);
    this.keepOrder(run);
    const coarse = new Coarse(shown, gauge, this.leaves, most, run.wearer);
    for (let k = run.first; k < run.end; k++)
      if (this.fates[k] === REFINED && this.cut(k - run.first + run.from, coarse)) this.fates[k] = DRAWN;
  }

  /** The body as a whole first: most need no look at their clusters. */
  private decide(r: number, shown: Shown, gauge: Gauge): void {
    const { first, end, from, body } = this.clusters.runs[r];
    const found = this.bodies.get(body + 1);
    const window = found && this.deforming ? windowOf(found, gauge) : undefined;
    const lumps = window && this.deforming ? this.deforming.over(window) : this.lumps;
    if (!this.deforming) {
      const fate = shown.fate(this.whole[r]);
      if (fate === OUTSIDE || end - first === 1) {
        this.fates.fill(fate, first, end);
        return;
      }
    }
    for (let k = first; k < end; k++) this.fates[k] = shown.fate(lumps[k - first + from]);
  }

  /** What is blended keeps the order of its triangles: all of a body are leaves, or none is. */
  private keepOrder({ first, end }: Run): void {
    if (!this.batch.transparent) return;
    const fates = this.fates.subarray(first, end);
    if (!fates.includes(REFINED)) return;
    for (let k = 0; k < fates.length; k++) if (fates[k] === DRAWN) fates[k] = REFINED;
  }

  /** Tells whether no edge of a cluster is cut after all, so that it is drawn as it is. */
  private cut(cluster: number, coarse: Coarse): boolean {
    const { indices } = this.batch.arrays;
    const before = this.leaves.count;
    let whole = !this.batch.transparent;
    for (let t = this.starts[cluster]; t < this.starts[cluster + 1]; t++)
      whole = coarse.cut(t, indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]) && whole;
    if (whole) this.leaves.truncate(before);
    return whole;
  }
}
