import { pointSamples } from '../../../scene/motion/motion.ts';
import type { MovingBody } from '../../geometry/bodies.ts';
import { type ClusterBounds, CULLED, DRAWN, type ProjectedBody, TESSELLATED } from '../criterion/projectedBody.ts';
import { type ScreenMetric, screenMetricOf, type TessellationView } from '../criterion/tessellationView.ts';
import { EdgeFactors } from '../patches/edgeFactors.ts';
import { INSTANCE_OFFSET, PATCH_FLOATS, PatchList } from '../patches/patch.ts';
import { PATTERNS } from '../patches/pattern.ts';
import { Subdivider } from '../patches/subdivider.ts';
import { type PlannedBatch, projectBody, sampleWindowOf } from '../projection/projectBody.ts';
import { type ClusterRange, Clusters, clusterBoundsOf, mergeBounds } from './clusters.ts';
import { DeformingClusterBounds } from './deformingClusterBounds.ts';

/** How one batch is drawn in one picture. */
export interface TessellationPlan {
  /** Every cluster is DRAWN. */
  readonly allDrawn: boolean;
  /** The Fate of each cluster; where many wear the mesh, of all clusters of the first body, then of the second … */
  readonly clusterStates: Uint8Array;
  /** As in patch.ts, in the order of their bodies and triangles; valid until the next plan. */
  readonly patches: Float32Array;
  readonly count: number;
  /** The tolerance that the budget allowed [px]; the levels are found for it. */
  readonly tolerance: number;
}

/** Leaves by their patterns (pattern.ts), the levels of their edges filled in; valid until the next call. */
export type PatchesByPattern = readonly PatchArray[];
/** As in patch.ts. */
export interface PatchArray {
  readonly patches: Float32Array;
  readonly count: number;
}

/** One batch: its clusters, and what they need in a picture. */
export class BatchPlanner {
  private readonly batch: PlannedBatch;
  private readonly bodies: ReadonlyMap<number, MovingBody>;
  private readonly clusters: Clusters;
  /** Of each cluster, where the mesh does not deform, and of each run. */
  private readonly bounds: readonly ClusterBounds[];
  private readonly rangeBounds: readonly ClusterBounds[];
  private readonly deformingBounds: DeformingClusterBounds | undefined;
  private readonly states: Uint8Array;
  private readonly patches = new PatchList();
  private readonly byPattern: readonly PatchList[] = PATTERNS.map(() => new PatchList());

  constructor(batch: PlannedBatch) {
    const { arrays, bodies, instancing: worn } = batch;
    this.batch = batch;
    this.bodies = new Map(bodies.map((body) => [body.id, body]));
    this.clusters = new Clusters(batch);
    this.states = new Uint8Array(this.clusters.totalCount);
    const samples = pointSamples(bodies[0].object.motion);
    const deforms = samples !== undefined;
    this.deformingBounds = samples && new DeformingClusterBounds(this.clusters, arrays.indices, samples);
    this.bounds = deforms ? [] : clusterBoundsOf(this.clusters, arrays);
    const wholeOf = ({ firstInMesh: from, first, end }: ClusterRange): ClusterBounds =>
      mergeBounds(this.bounds.slice(from, from + end - first));
    const all = deforms ? [] : this.clusters.ranges.slice(0, worn ? 1 : undefined).map(wholeOf);
    this.rangeBounds = worn ? this.clusters.ranges.map(() => all[0]) : all;
  }

  /** First triangle of each cluster, and after the last one the number of triangles. */
  get starts(): Uint32Array {
    return this.clusters.starts;
  }

  /** `tolerance` [px]: that of the look, or more where the budget asks for it. Stops when there are more leaves than `most`. */
  plan(look: TessellationView, tolerance = look.tolerance, most = Number.POSITIVE_INFINITY): TessellationPlan {
    const gauge = screenMetricOf(look, tolerance);
    this.patches.clear();
    for (let r = 0; r < this.clusters.ranges.length; r++) this.planRange(r, gauge, most);
    const { patches: leaves, count } = this.patches;
    return {
      allDrawn: this.states.every((f) => f === DRAWN),
      clusterStates: this.states,
      patches: leaves,
      count,
      tolerance,
    };
  }

  /** The levels of a plan's leaves, for the same look. */
  groupByPattern({ patches: leaves, count, tolerance }: TessellationPlan, look: TessellationView): PatchesByPattern {
    const gauge = screenMetricOf(look, tolerance);
    const { bodies, instancing: worn } = this.batch;
    const { indices, ids } = this.batch.arrays;
    for (const list of this.byPattern) list.clear();
    let fine: EdgeFactors | undefined;
    let body = -1;
    for (let i = 0; i < count; i++) {
      const at = PATCH_FLOATS * i;
      const owner = worn ? bodies[leaves[at + INSTANCE_OFFSET]].id - 1 : ids[2 * indices[3 * leaves[at]]];
      if (owner !== body) {
        const shown = this.projected(owner, gauge);
        fine = shown && new EdgeFactors(shown, gauge);
        body = owner;
      }
      fine?.compute(leaves, i, indices);
      if (fine) this.byPattern[fine.pattern].copy(leaves, i, fine.factors);
    }
    return this.byPattern;
  }

  private projected(body: number, gauge: ScreenMetric): ProjectedBody | undefined {
    const found = this.bodies.get(body + 1);
    return found && projectBody(found, this.batch, gauge);
  }

  private planRange(r: number, gauge: ScreenMetric, most: number): void {
    const run = this.clusters.ranges[r];
    const shown = this.projected(run.body, gauge);
    if (!shown) {
      this.states.fill(CULLED, run.first, run.end);
      return;
    }
    this.classifyRange(r, shown, gauge);
    this.keepOrder(run);
    const coarse = new Subdivider(shown, gauge, this.patches, most, run.instance);
    for (let k = run.first; k < run.end; k++)
      if (this.states[k] === TESSELLATED && this.subdivideCluster(k - run.first + run.firstInMesh, coarse))
        this.states[k] = DRAWN;
  }

  /** The body as a whole first: most need no look at their clusters. */
  private classifyRange(r: number, shown: ProjectedBody, gauge: ScreenMetric): void {
    const { first, end, firstInMesh: from, body } = this.clusters.ranges[r];
    const found = this.bodies.get(body + 1);
    const window = found && this.deformingBounds ? sampleWindowOf(found, gauge) : undefined;
    const lumps = window && this.deformingBounds ? this.deformingBounds.boundsOver(window) : this.bounds;
    if (!this.deformingBounds) {
      const fate = shown.classify(this.rangeBounds[r]);
      if (fate === CULLED || end - first === 1) {
        this.states.fill(fate, first, end);
        return;
      }
    }
    for (let k = first; k < end; k++) this.states[k] = shown.classify(lumps[k - first + from]);
  }

  /** What is blended keeps the order of its triangles: all of a body are leaves, or none is. */
  private keepOrder({ first, end }: ClusterRange): void {
    if (!this.batch.transparent) return;
    const fates = this.states.subarray(first, end);
    if (!fates.includes(TESSELLATED)) return;
    for (let k = 0; k < fates.length; k++) if (fates[k] === DRAWN) fates[k] = TESSELLATED;
  }

  /** Tells whether no edge of a cluster is cut after all, so that it is drawn as it is. */
  private subdivideCluster(cluster: number, coarse: Subdivider): boolean {
    const { indices } = this.batch.arrays;
    const before = this.patches.count;
    let whole = !this.batch.transparent;
    for (let t = this.starts[cluster]; t < this.starts[cluster + 1]; t++)
      whole = coarse.subdivide(t, indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]) && whole;
    if (whole) this.patches.truncate(before);
    return whole;
  }
}
