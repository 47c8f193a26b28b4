import { Fn, instanceIndex, int, uniform } from 'three/tsl';
import type { ComputeNode, WebGPURenderer } from 'three/webgpu';
import type { Vec3 } from '../../shaders/types.ts';
import { type MotionSources, type Projection, shownPoint } from '../vertexStage.ts';
import type { LeafBuffers, LeafRun } from './gpuBuffers.ts';
import type { Corners } from './gpuCorners.ts';
import { EdgeGauge, leafLevels } from './gpuCriterion.ts';
import { cornerWeights } from './gpuLeaf.ts';
import type { Look } from './look.ts';
import type { Plan } from './plan.ts';

/** The leaves of one batch in one picture. */
export interface LeafRequest {
  /** The batch's place in the buffers. */
  readonly slot: number;
  /** Batches whose bodies move alike, by the same sources, have one name. */
  readonly family: string;
  readonly sources: MotionSources;
  readonly plan: Plan;
  /** What is added to the triangles and the instances of its leaves. */
  readonly firstTriangle: number;
  readonly firstInstance: number;
}

/** A kernel for the leaves of a family, as they lie together. */
interface Kernel {
  readonly node: ComputeNode;
  readonly first: { value: number };
}

/** On WebGPU: kernels that find the levels of each leaf's edges, each from the edge alone, and put the leaf into the list of its pattern. */
export class GpuLevels {
  private readonly renderer: WebGPURenderer;
  private readonly corners: Corners;
  private readonly buffers: LeafBuffers;
  private readonly gauge = new EdgeGauge();
  private readonly kernels = new Map<string, Kernel>();
  private used = 0;

  constructor(renderer: WebGPURenderer, corners: Corners, buffers: LeafBuffers) {
    this.renderer = renderer;
    this.corners = corners;
    this.buffers = buffers;
  }

  /** Whether the last picture had leaves. */
  get busy(): boolean {
    return this.used > 0;
  }

  /** Fills the lists; tells where the leaves of each request are. */
  find(look: Look, requests: readonly LeafRequest[]): ReadonlyMap<LeafRequest, LeafRun> {
    const runs = new Map<LeafRequest, LeafRun>();
    this.buffers.begin(requests.reduce((sum, { plan }) => sum + plan.count, 0));
    const work: ComputeNode[] = [];
    this.used = 0;
    for (const [family, members] of byFamily(requests)) {
      const kernel = this.kernel(family, members[0].sources, look.projection);
      kernel.first.value = this.used;
      for (const request of members) {
        const run = { first: this.used, count: request.plan.count };
        this.buffers.write(request.slot, run, request.plan.leaves, request.firstTriangle, request.firstInstance);
        runs.set(request, run);
        this.used += run.count;
      }
      kernel.node.count = this.used - kernel.first.value;
      work.push(kernel.node);
    }
    if (requests.length > 0) {
      this.gauge.take(look, requests[0].plan.tolerance);
      this.renderer.compute(work);
    }
    return runs;
  }

  dispose(): void {
    for (const { node } of this.kernels.values()) node.dispose();
  }

  private kernel(family: string, sources: MotionSources, projection: Projection): Kernel {
    const name = `${family} ${projection.event} ${projection.place}`;
    const known = this.kernels.get(name) ?? this.makeKernel(sources, projection);
    this.kernels.set(name, known);
    return known;
  }

  private makeKernel(sources: MotionSources, projection: Projection): Kernel {
    const { buffers, corners, gauge } = this;
    const first = uniform(0, 'uint');
    const node = Fn(() => {
      const index = instanceIndex.add(first).toVar();
      const { head, tail, instance } = buffers.leaf(index);
      const triangle = int(head.x).toVar();
      const show = (weights: Vec3) =>
        shownPoint(sources, projection, corners.point(triangle, weights, { ...sources, colored: false }, instance));
      const { levels, pattern } = leafLevels(cornerWeights(head, tail), show, gauge);
      buffers.enlist(index, int(tail.w).toVar(), levels, pattern);
    })().compute(1);
    return { node, first };
  }
}

function byFamily(requests: readonly LeafRequest[]): Map<string, LeafRequest[]> {
  const families = new Map<string, LeafRequest[]>();
  for (const request of requests) families.set(request.family, [...(families.get(request.family) ?? []), request]);
  return families;
}
