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

/** How one batch is drawn in one view. */
export interface TessellationPlan {
  /** Whether every cluster is DRAWN. */
  readonly allDrawn: boolean;
  /** The `ClusterState` of each cluster; with instancing, of all clusters of the first body, then of the second … */
  readonly clusterStates: Uint8Array;
  /** Patches (patch.ts) in the order of bodies and triangles; valid until the next plan. */
  readonly patches: Float32Array;
  readonly count: number;
  /** The tolerance that the patch budget allowed [px], for which tessellation factors are computed. */
  readonly tolerance: number;
}

/** Patches with their tessellation factors, by pattern (pattern.ts); valid until the next call. */
export type PatchesByPattern = readonly PatchArray[];
/** A list of patches (patch.ts). */
export interface PatchArray {
  readonly patches: Float32Array;
  readonly count: number;
}

/** Plans one batch: classifies its clusters and subdivides triangles into patches. */
export class BatchPlanner {
  private readonly batch: PlannedBatch;
  private readonly bodies: ReadonlyMap<number, MovingBody>;
  private readonly clusters: Clusters;
  /** Bounds of each cluster and of each body's range; empty if the mesh deforms. */
  private readonly bounds: readonly ClusterBounds[];
  private readonly rangeBounds: readonly ClusterBounds[];
  private readonly deformingBounds: DeformingClusterBounds | undefined;
  private readonly states: Uint8Array;
  private readonly patches = new PatchList();
  private readonly byPattern: readonly PatchList[] = PATTERNS.map(() => new PatchList());

  constructor(batch: PlannedBatch) {
    const { bodies, instancing } = batch;
    this.batch = batch;
    this.bodies = new Map(bodies.map((body) => [body.id, body]));
    this.clusters = new Clusters(batch);
    this.states = new Uint8Array(this.clusters.totalCount);
    const samples = pointSamples(bodies[0].object.motion);
    const deforms = samples !== undefined;
    this.deformingBounds = samples && new DeformingClusterBounds(this.clusters, batch.arrays.indices, samples);
    this.bounds = deforms ? [] : clusterBoundsOf(this.clusters, batch);
    const wholeOf = ({ firstInMesh: from, first, end }: ClusterRange): ClusterBounds =>
      mergeBounds(this.bounds.slice(from, from + end - first));
    const all = deforms ? [] : this.clusters.ranges.slice(0, instancing ? 1 : undefined).map(wholeOf);
    this.rangeBounds = instancing ? this.clusters.ranges.map(() => all[0]) : all;
  }

  /** First triangle of each cluster, and after the last one the number of triangles. */
  get starts(): Uint32Array {
    return this.clusters.starts;
  }

  /** `tolerance` [px]: the view's, or more to stay within the budget. Stops early once there are more than `maxPatches` patches. */
  plan(view: TessellationView, tolerance = view.tolerance, maxPatches = Number.POSITIVE_INFINITY): TessellationPlan {
    const metric = screenMetricOf(view, tolerance);
    this.patches.clear();
    for (let r = 0; r < this.clusters.ranges.length; r++) this.planRange(r, metric, maxPatches);
    const { patches, count } = this.patches;
    return {
      allDrawn: this.states.every((state) => state === DRAWN),
      clusterStates: this.states,
      patches,
      count,
      tolerance,
    };
  }

  /** Computes the tessellation factors of a plan's patches, for the same view. */
  groupByPattern({ patches, count, tolerance }: TessellationPlan, view: TessellationView): PatchesByPattern {
    const metric = screenMetricOf(view, tolerance);
    const { bodies, instancing } = this.batch;
    const { indices, ids } = this.batch.arrays;
    for (const list of this.byPattern) list.clear();
    let edges: EdgeFactors | undefined;
    let body = -1;
    for (let i = 0; i < count; i++) {
      const at = PATCH_FLOATS * i;
      const owner = instancing ? bodies[patches[at + INSTANCE_OFFSET]].id - 1 : ids[2 * indices[3 * patches[at]]];
      if (owner !== body) {
        const projected = this.projected(owner, metric);
        edges = projected && new EdgeFactors(projected, metric);
        body = owner;
      }
      edges?.compute(patches, i, indices);
      if (edges) this.byPattern[edges.pattern].copy(patches, i, edges.factors);
    }
    return this.byPattern;
  }

  private projected(id: number, metric: ScreenMetric): ProjectedBody | undefined {
    const body = this.bodies.get(id + 1);
    return body && projectBody(body, this.batch, metric);
  }

  private planRange(r: number, metric: ScreenMetric, maxPatches: number): void {
    const range = this.clusters.ranges[r];
    const projected = this.projected(range.body, metric);
    if (!projected) {
      this.states.fill(CULLED, range.first, range.end);
      return;
    }
    this.classifyRange(r, projected, metric);
    this.keepOrder(range);
    const subdivider = new Subdivider(projected, metric, this.patches, maxPatches, range.instance);
    for (let k = range.first; k < range.end; k++)
      if (this.states[k] === TESSELLATED && this.subdivideCluster(k - range.first + range.firstInMesh, subdivider))
        this.states[k] = DRAWN;
  }

  /** Sets the states of a body's clusters, at once if the whole body is outside the picture. */
  private classifyRange(r: number, projected: ProjectedBody, metric: ScreenMetric): void {
    const { first, end, firstInMesh, body: id } = this.clusters.ranges[r];
    const body = this.bodies.get(id + 1);
    const window = body && this.deformingBounds ? sampleWindowOf(body, metric) : undefined;
    const bounds = window && this.deformingBounds ? this.deformingBounds.boundsOver(window) : this.bounds;
    if (!this.deformingBounds) {
      const state = projected.classify(this.rangeBounds[r]);
      if (state === CULLED || end - first === 1) {
        this.states.fill(state, first, end);
        return;
      }
    }
    for (let k = first; k < end; k++) this.states[k] = projected.classify(bounds[k - first + firstInMesh]);
  }

  /** Keeps the drawing order of blended triangles: either all clusters of a body are tessellated, or none is. */
  private keepOrder({ first, end }: ClusterRange): void {
    if (!this.batch.transparent) return;
    const states = this.states.subarray(first, end);
    if (!states.includes(TESSELLATED)) return;
    for (let k = 0; k < states.length; k++) if (states[k] === DRAWN) states[k] = TESSELLATED;
  }

  /** Adds the patches of a cluster. Returns true, without patches, if no edge needs tessellation and the cluster can be drawn as it is. */
  private subdivideCluster(cluster: number, subdivider: Subdivider): boolean {
    const { indices } = this.batch.arrays;
    const before = this.patches.count;
    let whole = !this.batch.transparent;
    for (let t = this.starts[cluster]; t < this.starts[cluster + 1]; t++)
      whole = subdivider.subdivide(t, indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]) && whole;
    if (whole) this.patches.truncate(before);
    return whole;
  }
}
