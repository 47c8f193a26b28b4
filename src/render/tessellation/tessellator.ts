import { deforms } from '../../scene/motion/motion.ts';
import type { DrawCall } from '../gbuffer/drawCall.ts';
import { type Batch, isPiece } from '../geometry/batches.ts';
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

/** A batch, its clusters that are drawn as they are, and its patches, which are created lazily. */
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

/** Most patches of a view: on WebGPU the GPU computes their factors, on WebGL2 the CPU. */
const MAX_PATCHES = { webgpu: 2 ** 17, webgl: 2 ** 16 } as const;
/** Number of pictures between two counts. */
const COUNT_INTERVAL = 10;
/** Default of `RendererOptions.tolerance` [px]. */
const DEFAULT_TOLERANCE = 0.25;

/** Tessellates a scene's batches for each view: on WebGPU with compute kernels and indirect draws, on WebGL2 and for transparent batches on the CPU. */
export class Tessellator {
  private readonly gpu: Gpu;
  private readonly tolerance: number;
  private readonly parts: readonly TessellatedBatch[];
  private readonly planner: Planner;
  private readonly addDrawCall: (drawCall: DrawCall) => void;
  private readonly triangles: TriangleTable;
  /** Of pieces, which take turns. */
  private readonly pieceTriangles: TriangleTable;
  private readonly patterns = patternGeometry(ALL_PATTERNS);
  private readonly buffers: PatchBuffers;
  private readonly kernels: FactorKernels;
  /** Triangles of the last picture that were counted here, and those that kernels listed, as last read back. */
  private cpuTriangles = 0;
  private gpuTriangles = 0;
  /** Of the faces before, in a picture of several. */
  private otherTriangles = 0;
  private frames = 0;
  private achieved = 0;

  /** `triangles`: of all batches that are not pieces. `add` is called with draw calls as they are created; the caller disposes of them. */
  constructor(
    gpu: Gpu,
    indexed: readonly DrawCall[],
    triangles: TriangleTable,
    add: (drawCall: DrawCall) => void,
    options: TessellatorOptions,
  ) {
    this.gpu = gpu;
    this.triangles = triangles;
    this.pieceTriangles = new TriangleTable(gpu.renderer);
    this.tolerance = options.tolerance ?? DEFAULT_TOLERANCE;
    this.addDrawCall = add;
    this.planner = makePlanner(
      indexed.map(({ batch }) => ({ batch, needsFactors: batch.transparent || gpu.backend !== 'webgpu' })),
      options,
    );
    this.parts = indexed.map((drawCall, slot) => {
      const starts = this.planner.starts(slot);
      const clusters = drawCall.batch.instancing
        ? new InstancedClusters(drawCall, drawCall.batch.instancing, starts, add)
        : new IndexedClusters(drawCall, starts);
      return { slot, indexed: drawCall, clusters };
    });
    this.buffers = new PatchBuffers(indexed.length, this.patterns.runs);
    this.kernels = new FactorKernels(gpu.renderer, this.buffers);
  }

  /** Triangles drawn in the last picture; on WebGPU up to date after `count`, which counts those that kernels listed for the last of several faces. */
  get triangleCount(): number {
    return this.otherTriangles + this.cpuTriangles + this.gpuTriangles;
  }

  /** Largest distance of straight edges from their curves in the last picture [px]; more than requested if there would be too many patches. */
  get achievedTolerance(): number {
    return this.achieved;
  }

  /** Whether a better plan for this view is being made than the one that it was drawn with. */
  awaitsBetter(viewIndex: number | undefined): boolean {
    return viewIndex !== undefined && this.planner.awaitsBetter(viewIndex);
  }

  /** Tessellates the batches that may be visible in a view and hides the others. `viewIndex`: index of the view in the picture, undefined for one of many parts. `continues`: it is another face of the same picture. */
  update(
    view: Omit<TessellationView, 'tolerance' | 'maxPatches'>,
    viewIndex: number | undefined,
    isVisible: (batch: Batch) => boolean,
    continues = false,
  ): void {
    this.otherTriangles = continues ? this.otherTriangles + this.cpuTriangles : 0;
    if (this.tolerance === Number.POSITIVE_INFINITY) {
      this.showUntessellated(isVisible);
      return;
    }
    const requested: TessellationView = {
      ...view,
      tolerance: this.tolerance,
      maxPatches: MAX_PATCHES[this.gpu.backend],
    };
    const visible = this.parts.map(({ indexed }) => isVisible(indexed.batch));
    this.pieceTriangles.trim(isVisible);
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

  /** Hides all batches: a capture shows them. */
  hideAll(): void {
    this.parts.forEach(hidePart);
    this.kernels.clear();
    [this.cpuTriangles, this.gpuTriangles, this.otherTriangles] = [0, 0, 0];
  }

  /** Calls `count` every `COUNT_INTERVAL` pictures, without waiting for it. */
  countPeriodically(): void {
    if (this.frames++ % COUNT_INTERVAL === 0) this.count().catch(() => undefined);
  }

  /** Reads back how many triangles kernels have listed for the last picture. */
  async count(): Promise<void> {
    if (!this.kernels.busy) return;
    const draws = await this.gpu.renderer.getArrayBufferAsync(this.buffers.draws);
    this.gpuTriangles = PatchBuffers.countTriangles(new Uint32Array(draws));
  }

  /** Makes the draw calls of patches that no picture has needed yet, so that their shaders can be compiled before one does; not those of pieces, which are many. */
  makeAllPatches(): void {
    if (this.tolerance === Number.POSITIVE_INFINITY) return;
    for (const part of this.parts) if (!isPiece(part.indexed.batch)) part.patches ??= this.makePatches(part);
  }

  dispose(): void {
    this.planner.dispose();
    this.kernels.dispose();
    this.buffers.dispose();
    this.pieceTriangles.dispose();
    this.patterns.geometry.dispose();
  }

  private showUntessellated(isVisible: (batch: Batch) => boolean): void {
    this.cpuTriangles = 0;
    for (const part of this.parts)
      if (isVisible(part.indexed.batch)) this.cpuTriangles += part.clusters.showAll();
      else hidePart(part);
  }

  private showPart(part: TessellatedBatch, plan: BatchPlan, requests: IndirectRequest[]): void {
    const { clusters, indexed, slot } = part;
    const firstInstance = indexed.batch.instancing?.first ?? 0;
    const firstTriangle = plan.count > 0 ? this.tableOf(indexed).firstTriangle(indexed.batch) : undefined;
    if (firstTriangle === undefined) {
      part.patches?.hide();
      this.cpuTriangles += plan.count > 0 ? clusters.showAll() : clusters.show(plan.clusterStates);
      return;
    }
    part.patches ??= this.makePatches(part);
    const { patches } = part;
    if (patches instanceof IndirectPatches)
      requests.push({
        slot,
        kernelKey: kernelKeyOf(indexed),
        triangles: this.tableOf(indexed),
        sources: indexed.vertex,
        plan,
        firstTriangle,
        firstInstance,
        patches,
      });
    else this.cpuTriangles += patches.show(plan.patchesByPattern ?? [], firstTriangle, firstInstance);
    if (patches instanceof OrderedPatches) clusters.hide();
    else this.cpuTriangles += clusters.show(plan.clusterStates);
  }

  private tableOf({ batch }: DrawCall): TriangleTable {
    return isPiece(batch) ? this.pieceTriangles : this.triangles;
  }

  private makePatches({ indexed, slot }: TessellatedBatch): IndirectPatches | InstancedPatches | OrderedPatches {
    const { patterns, buffers } = this;
    const triangleTable = this.tableOf(indexed);
    const patches = indexed.batch.transparent
      ? new OrderedPatches(indexed, triangleTable)
      : this.gpu.backend === 'webgpu'
        ? new IndirectPatches(indexed, slot, patterns.geometry, triangleTable, buffers)
        : new InstancedPatches(indexed, triangleTable);
    patches.drawCalls.forEach(this.addDrawCall);
    return patches;
  }
}

function makePlanner(
  parts: readonly PlannedPart[],
  { tessellationWorker, onBetterTessellation }: TessellatorOptions,
): Planner {
  if (!tessellationWorker || !fitsWorker(parts)) return new LocalPlanner(parts);
  return new WorkerPlanner(parts, tessellationWorker(), () => onBetterTessellation?.());
}

function hidePart({ clusters, patches }: TessellatedBatch): void {
  clusters.hide();
  patches?.hide();
}

/** Equal for batches whose factors one kernel computes. Deforming bodies have a kernel each, because their samples are in tables of their own. */
function kernelKeyOf({ batch }: DrawCall): string {
  const { kind, bodies, instancing } = batch;
  if (deforms({ kind })) return `${kind} ${bodies[0].id}`;
  return [kind, instancing && 'instanced', isPiece(batch) && 'piece'].filter(Boolean).join(' ');
}
