import { deforms } from '../../scene/motion/motion.ts';
import type { DrawCall } from '../gbuffer/drawCall.ts';
import type { Batch } from '../geometry/batches.ts';
import type { Gpu } from '../gpu/device.ts';
import type { RendererOptions } from '../settings.ts';
import type { TessellationView } from './criterion/tessellationView.ts';
import { FactorKernels, type PatchRequest } from './gpu/factorKernels.ts';
import { IndexedClusters } from './gpu/indexedClusters.ts';
import { IndirectPatches } from './gpu/indirectPatches.ts';
import { InstancedClusters } from './gpu/instancedClusters.ts';
import { InstancedPatches } from './gpu/instancedPatches.ts';
import { OrderedPatches } from './gpu/orderedPatches.ts';
import { PatchBuffers } from './gpu/patchBuffers.ts';
import { ALL_PATTERNS, patternGeometry } from './gpu/patternGeometry.ts';
import { TriangleTable } from './gpu/triangleTable.ts';
import { type BatchPlan, LocalPlanner, type PlannedPart, type Planner } from './plan/planner.ts';
import { fitsWorker, WorkerPlanner } from './plan/workerPlanner.ts';

/** A batch: what of it is drawn as it is, and what in pieces, made when it first needs any. */
interface TessellatedBatch {
  readonly slot: number;
  readonly indexed: DrawCall;
  readonly clusters: IndexedClusters | InstancedClusters;
  patches?: IndirectPatches | InstancedPatches | OrderedPatches;
}

interface IndirectRequest extends PatchRequest {
  readonly patches: IndirectPatches;
}

export type TessellatorOptions = Pick<RendererOptions, 'tolerance' | 'tessellationWorker' | 'onBetterTessellation'>;

/** Most leaves of a picture, by who finds their levels. */
const MAX_PATCHES = { webgpu: 2 ** 17, webgl: 2 ** 16 } as const;
/** Pictures. */
const COUNT_INTERVAL = 10;
/** [px] */
const DEFAULT_TOLERANCE = 0.25;

/** Cuts a scene's batches as each picture needs it: on WebGPU by kernels and indirect draws, elsewhere and what is transparent on the CPU. */
export class Tessellator {
  private readonly gpu: Gpu;
  private readonly tolerance: number;
  private readonly parts: readonly TessellatedBatch[];
  private readonly planner: Planner;
  private readonly addDrawable: (drawable: DrawCall) => void;
  private readonly triangleTable = new TriangleTable();
  private readonly patterns = patternGeometry(ALL_PATTERNS);
  private readonly buffers: PatchBuffers;
  private readonly kernels: FactorKernels;
  /** Triangles of the last picture, as far as they are known here, and those that a kernel listed. */
  private cpuTriangles = 0;
  private gpuTriangles = 0;
  private frames = 0;
  private achieved = 0;

  /** `add` is given drawables as they are made; they are its to dispose. */
  constructor(gpu: Gpu, indexed: readonly DrawCall[], add: (drawable: DrawCall) => void, options: TessellatorOptions) {
    this.gpu = gpu;
    this.tolerance = options.tolerance ?? DEFAULT_TOLERANCE;
    this.addDrawable = add;
    this.planner = makePlanner(
      indexed.map(({ batch }) => ({ batch, needsFactors: batch.transparent || gpu.backend !== 'webgpu' })),
      options,
    );
    this.parts = indexed.map((drawable, slot) => {
      const starts = this.planner.starts(slot);
      const clusters = drawable.batch.instancing
        ? new InstancedClusters(drawable, drawable.batch.instancing, starts, add)
        : new IndexedClusters(drawable, starts);
      return { slot, indexed: drawable, clusters };
    });
    this.buffers = new PatchBuffers(indexed.length, this.patterns.runs);
    this.kernels = new FactorKernels(gpu.renderer, this.triangleTable, this.buffers);
  }

  /** Drawn in the last picture; on WebGPU what kernels listed is known after `count`. */
  get triangleCount(): number {
    return this.cpuTriangles + this.gpuTriangles;
  }

  /** How far straight edges may be from the curves that are seen in the last picture [px]: more than asked for where there would be too many. */
  get achievedTolerance(): number {
    return this.achieved;
  }

  /** Shows what is drawn of the batches that may be visible in a view, tessellated for it; `viewIndex`: its place in the picture's views. */
  update(
    view: Omit<TessellationView, 'tolerance' | 'maxPatches'>,
    viewIndex: number,
    seen: (batch: Batch) => boolean,
  ): void {
    if (this.tolerance === Number.POSITIVE_INFINITY) {
      this.showUncut(seen);
      return;
    }
    const requested: TessellationView = {
      ...view,
      tolerance: this.tolerance,
      maxPatches: MAX_PATCHES[this.gpu.backend],
    };
    const visible = this.parts.map(({ indexed }) => seen(indexed.batch));
    const plans = this.planner.plan({ viewIndex, view: requested, visible });
    const requests: IndirectRequest[] = [];
    this.cpuTriangles = 0;
    this.achieved = plans.reduce((most, plan) => Math.max(most, plan?.tolerance ?? 0), this.tolerance);
    this.parts.forEach((part, i) => {
      const plan = plans[i];
      if (plan) this.showPart(part, plan, requests);
      else hidePart(part);
    });
    const runs = this.kernels.dispatch(requested, requests);
    for (const request of requests) request.patches.show(runs.get(request) ?? { first: 0, count: 0 });
    if (requests.length === 0) this.gpuTriangles = 0;
  }

  /** Counts now and then, without waiting for it. */
  countPeriodically(): void {
    if (this.frames++ % COUNT_INTERVAL === 0) this.count().catch(() => undefined);
  }

  /** Asks the GPU how many triangles it has listed for the last picture. */
  async count(): Promise<void> {
    if (!this.kernels.busy) return;
    const draws = await this.gpu.renderer.getArrayBufferAsync(this.buffers.draws);
    this.gpuTriangles = PatchBuffers.countTriangles(new Uint32Array(draws));
  }

  dispose(): void {
    this.planner.dispose();
    this.kernels.dispose();
    this.buffers.dispose();
    this.triangleTable.dispose();
    this.patterns.geometry.dispose();
  }

  private showUncut(seen: (batch: Batch) => boolean): void {
    this.cpuTriangles = 0;
    for (const part of this.parts)
      if (seen(part.indexed.batch)) this.cpuTriangles += part.clusters.showAll();
      else hidePart(part);
  }

  private showPart(part: TessellatedBatch, plan: BatchPlan, requests: IndirectRequest[]): void {
    const { clusters, indexed, slot } = part;
    const firstInstance = indexed.batch.instancing?.first ?? 0;
    const firstTriangle = plan.count > 0 ? this.triangleTable.firstTriangle(indexed.batch) : undefined;
    if (firstTriangle === undefined) {
      part.patches?.hide();
      this.cpuTriangles += plan.count > 0 ? clusters.showAll() : clusters.show(plan.clusterStates);
      return;
    }
    part.patches ??= this.makePatches(part);
    const { patches: pieces } = part;
    if (pieces instanceof IndirectPatches)
      requests.push({
        slot,
        kernelKey: kernelKeyOf(indexed),
        sources: indexed.vertex,
        plan,
        firstTriangle,
        firstInstance,
        patches: pieces,
      });
    else this.cpuTriangles += pieces.show(plan.patchesByPattern ?? [], firstTriangle, firstInstance);
    if (pieces instanceof OrderedPatches) clusters.hide();
    else this.cpuTriangles += clusters.show(plan.clusterStates);
  }

  private makePatches({ indexed, slot }: TessellatedBatch): IndirectPatches | InstancedPatches | OrderedPatches {
    const { triangleTable, patterns, buffers } = this;
    const pieces = indexed.batch.transparent
      ? new OrderedPatches(indexed, triangleTable)
      : this.gpu.backend === 'webgpu'
        ? new IndirectPatches(indexed, slot, patterns.geometry, triangleTable, buffers)
        : new InstancedPatches(indexed, triangleTable);
    pieces.drawables.forEach(this.addDrawable);
    return pieces;
  }
}

function makePlanner(
  parts: readonly PlannedPart[],
  { tessellationWorker, onBetterTessellation }: TessellatorOptions,
): Planner {
  if (!tessellationWorker || !fitsWorker(parts)) return new LocalPlanner(parts);
  return new WorkerPlanner(parts, tessellationWorker(), () => onBetterTessellation?.());
}

function hidePart({ clusters, patches: pieces }: TessellatedBatch): void {
  clusters.hide();
  pieces?.hide();
}

/** Of the batches whose levels one kernel finds: it reads the samples of a deforming body from a table of its own. */
const kernelKeyOf = ({ batch: { kind, bodies, instancing: worn } }: DrawCall): string =>
  deforms({ kind }) ? `${kind} ${bodies[0].id}` : worn ? `${kind} worn` : kind;
