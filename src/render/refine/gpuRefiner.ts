import type { Batch } from '../batches.ts';
import type { Gpu } from '../device.ts';
import type { Drawable } from '../drawable.ts';
import type { RendererOptions } from '../settings.ts';
import { canTravel, DistantPlanner } from './distantPlanner.ts';
import { LeafBuffers } from './gpuBuffers.ts';
import { Corners } from './gpuCorners.ts';
import { IndexedClusters } from './gpuIndexed.ts';
import { InstancedPieces } from './gpuInstanced.ts';
import { GpuLevels, type LeafRequest } from './gpuLevels.ts';
import { ListedPieces } from './gpuListed.ts';
import { OrderedPieces } from './gpuOrdered.ts';
import { ALL_PATTERNS, patternGeometry } from './gpuPatterns.ts';
import { WornClusters } from './gpuWorn.ts';
import type { Look } from './look.ts';
import { type LevelledPlan, LocalPlanner, type PlannedPart, type Planner } from './planner.ts';

/** A batch: what of it is drawn as it is, and what in pieces, made when it first needs any. */
interface Part {
  readonly slot: number;
  readonly indexed: Drawable;
  readonly clusters: IndexedClusters | WornClusters;
  pieces?: ListedPieces | InstancedPieces | OrderedPieces;
}

interface ListRequest extends LeafRequest {
  readonly pieces: ListedPieces;
}

export type RefinerOptions = Pick<RendererOptions, 'tolerance' | 'planWorker' | 'onBetterPlan'>;

/** Most leaves of a picture, by who finds their levels. */
const BUDGET = { webgpu: 2 ** 17, webgl: 2 ** 16 } as const;
/** Pictures. */
const COUNT_EVERY = 10;
/** [px] */
const TOLERANCE = 0.25;

/** Cuts a scene's batches as each picture needs it: on WebGPU by kernels and indirect draws, elsewhere and what is transparent on the CPU. */
export class Refiner {
  private readonly gpu: Gpu;
  private readonly tolerance: number;
  private readonly parts: readonly Part[];
  private readonly planner: Planner;
  private readonly addDrawable: (drawable: Drawable) => void;
  private readonly corners = new Corners();
  private readonly patterns = patternGeometry(ALL_PATTERNS);
  private readonly buffers: LeafBuffers;
  private readonly levels: GpuLevels;
  /** Triangles of the last picture, as far as they are known here, and those that a kernel listed. */
  private known = 0;
  private listed = 0;
  private pictures = 0;
  private reached = 0;

  /** `add` is given drawables as they are made; they are its to dispose. */
  constructor(gpu: Gpu, indexed: readonly Drawable[], add: (drawable: Drawable) => void, options: RefinerOptions) {
    this.gpu = gpu;
    this.tolerance = options.tolerance ?? TOLERANCE;
    this.addDrawable = add;
    this.planner = plannerOf(
      indexed.map(({ batch }) => ({ batch, levelled: batch.transparent || gpu.backend !== 'webgpu' })),
      options,
    );
    this.parts = indexed.map((drawable, slot) => {
      const starts = this.planner.starts(slot);
      const clusters = drawable.batch.worn
        ? new WornClusters(drawable, drawable.batch.worn, starts, add)
        : new IndexedClusters(drawable, starts);
      return { slot, indexed: drawable, clusters };
    });
    this.buffers = new LeafBuffers(indexed.length, this.patterns.runs);
    this.levels = new GpuLevels(gpu.renderer, this.corners, this.buffers);
  }

  /** Drawn in the last picture; on WebGPU what kernels listed is known after `count`. */
  get triangles(): number {
    return this.known + this.listed;
  }

  /** How far straight edges may be from the curves that are seen in the last picture [px]: more than asked for where there would be too many. */
  get toleranceReached(): number {
    return this.reached;
  }

  /** Shows what is drawn of the batches that may be in the picture, cut for it. */
  show(look: Omit<Look, 'tolerance' | 'budget'>, seen: (batch: Batch) => boolean): void {
    if (this.tolerance === Number.POSITIVE_INFINITY) {
      this.showUncut(seen);
      return;
    }
    const wanted: Look = { ...look, tolerance: this.tolerance, budget: BUDGET[this.gpu.backend] };
    const plans = this.planner.plan({ look: wanted, seen: this.parts.map(({ indexed }) => seen(indexed.batch)) });
    const requests: ListRequest[] = [];
    this.known = 0;
    this.reached = plans.reduce((most, plan) => Math.max(most, plan?.tolerance ?? 0), this.tolerance);
    this.parts.forEach((part, i) => {
      const plan = plans[i];
      if (plan) this.showPart(part, plan, requests);
      else hidePart(part);
    });
    const runs = this.levels.find(wanted, requests);
    for (const request of requests) request.pieces.show(runs.get(request) ?? { first: 0, count: 0 });
    if (requests.length === 0) this.listed = 0;
  }

  /** Counts now and then, without waiting for it. */
  countSometimes(): void {
    if (this.pictures++ % COUNT_EVERY === 0) this.count().catch(() => undefined);
  }

  /** Asks the GPU how many triangles it has listed for the last picture. */
  async count(): Promise<void> {
    if (!this.levels.busy) return;
    const draws = await this.gpu.renderer.getArrayBufferAsync(this.buffers.draws);
    this.listed = LeafBuffers.triangles(new Uint32Array(draws));
  }

  dispose(): void {
    this.planner.dispose();
    this.levels.dispose();
    this.buffers.dispose();
    this.corners.dispose();
    this.patterns.geometry.dispose();
  }

  private showUncut(seen: (batch: Batch) => boolean): void {
    this.known = 0;
    for (const part of this.parts)
      if (seen(part.indexed.batch)) this.known += part.clusters.showAll();
      else hidePart(part);
  }

  private showPart(part: Part, plan: LevelledPlan, requests: ListRequest[]): void {
    const { clusters, indexed, slot } = part;
    const firstInstance = indexed.batch.worn?.first ?? 0;
    const firstTriangle = plan.count > 0 ? this.corners.firstTriangle(indexed.batch) : undefined;
    if (firstTriangle === undefined) {
      part.pieces?.hide();
      this.known += plan.count > 0 ? clusters.showAll() : clusters.show(plan.clusters);
      return;
    }
    part.pieces ??= this.makePieces(part);
    const { pieces } = part;
    if (pieces instanceof ListedPieces)
      requests.push({
        slot,
        family: familyOf(indexed),
        sources: indexed.vertex,
        plan,
        firstTriangle,
        firstInstance,
        pieces,
      });
    else this.known += pieces.show(plan.levels ?? [], firstTriangle, firstInstance);
    if (pieces instanceof OrderedPieces) clusters.hide();
    else this.known += clusters.show(plan.clusters);
  }

  private makePieces({ indexed, slot }: Part): ListedPieces | InstancedPieces | OrderedPieces {
    const { corners, patterns, buffers } = this;
    const pieces = indexed.batch.transparent
      ? new OrderedPieces(indexed, corners)
      : this.gpu.backend === 'webgpu'
        ? new ListedPieces(indexed, slot, patterns.geometry, corners, buffers)
        : new InstancedPieces(indexed, corners);
    pieces.drawables.forEach(this.addDrawable);
    return pieces;
  }
}

function plannerOf(parts: readonly PlannedPart[], { planWorker, onBetterPlan }: RefinerOptions): Planner {
  if (!planWorker || !canTravel(parts)) return new LocalPlanner(parts);
  return new DistantPlanner(parts, planWorker(), () => onBetterPlan?.());
}

function hidePart({ clusters, pieces }: Part): void {
  clusters.hide();
  pieces?.hide();
}

/** Of the batches whose levels one kernel finds: it reads the samples of a deforming body from a table of its own. */
const familyOf = ({ batch: { kind, bodies, worn } }: Drawable): string =>
  kind === 'sampled-points' ? `${kind} ${bodies[0].id}` : worn ? `${kind} worn` : kind;
