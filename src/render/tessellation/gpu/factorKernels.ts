import { Fn, instanceIndex, int, uniform } from 'three/tsl';
import type { ComputeNode, WebGPURenderer } from 'three/webgpu';
import type { Vec3 } from '../../../shaders/types.ts';
import { type MotionSources, type SpacetimeProjection, vertexObserverPosition } from '../../geometry/vertexStage.ts';
import type { TessellationView } from '../criterion/tessellationView.ts';
import type { TessellationPlan } from '../plan/tessellationPlan.ts';
import type { PatchBuffers, PatchRange } from './patchBuffers.ts';
import { EdgeMetricUniforms, patchFactors } from './patchFactors.ts';
import { cornerWeights } from './shaderPatch.ts';
import type { TriangleTable } from './triangleTable.ts';

/** The leaves of one batch in one picture. */
export interface PatchRequest {
  /** The batch's place in the buffers. */
  readonly slot: number;
  /** Batches whose bodies move alike, by the same sources, have one name. */
  readonly kernelKey: string;
  readonly sources: MotionSources;
  readonly plan: TessellationPlan;
  /** What is added to the triangles and the instances of its leaves. */
  readonly firstTriangle: number;
  readonly firstInstance: number;
}

/** A kernel for the leaves of a family, as they lie together. */
interface FactorKernel {
  readonly node: ComputeNode;
  readonly first: { value: number };
}

/** On WebGPU: kernels that find the levels of each leaf's edges, each from the edge alone, and put the leaf into the list of its pattern. */
export class FactorKernels {
  private readonly renderer: WebGPURenderer;
  private readonly triangleTable: TriangleTable;
  private readonly buffers: PatchBuffers;
  private readonly metric = new EdgeMetricUniforms();
  private readonly kernels = new Map<string, FactorKernel>();
  private used = 0;

  constructor(renderer: WebGPURenderer, corners: TriangleTable, buffers: PatchBuffers) {
    this.renderer = renderer;
    this.triangleTable = corners;
    this.buffers = buffers;
  }

  /** Whether the last picture had leaves. */
  get busy(): boolean {
    return this.used > 0;
  }

  /** Fills the lists; tells where the leaves of each request are. */
  dispatch(look: TessellationView, requests: readonly PatchRequest[]): ReadonlyMap<PatchRequest, PatchRange> {
    const runs = new Map<PatchRequest, PatchRange>();
    this.buffers.begin(requests.reduce((sum, { plan }) => sum + plan.count, 0));
    const work: ComputeNode[] = [];
    this.used = 0;
    for (const [family, members] of byKernel(requests)) {
      const kernel = this.kernel(family, members[0].sources, look.projection);
      kernel.first.value = this.used;
      for (const request of members) {
        const run = { first: this.used, count: request.plan.count };
        this.buffers.write(request.slot, run, request.plan.patches, request.firstTriangle, request.firstInstance);
        runs.set(request, run);
        this.used += run.count;
      }
      kernel.node.count = this.used - kernel.first.value;
      work.push(kernel.node);
    }
    if (requests.length > 0) {
      this.metric.set(look, requests[0].plan.tolerance);
      this.renderer.compute(work);
    }
    return runs;
  }

  dispose(): void {
    for (const { node } of this.kernels.values()) node.dispose();
  }

  private kernel(family: string, sources: MotionSources, projection: SpacetimeProjection): FactorKernel {
    const name = `${family} ${projection.event} ${projection.place}`;
    const known = this.kernels.get(name) ?? this.makeKernel(sources, projection);
    this.kernels.set(name, known);
    return known;
  }

  private makeKernel(sources: MotionSources, projection: SpacetimeProjection): FactorKernel {
    const { buffers, triangleTable, metric } = this;
    const first = uniform(0, 'uint');
    const node = Fn(() => {
      const index = instanceIndex.add(first).toVar();
      const { head, tail, instance } = buffers.patch(index);
      const triangle = int(head.x).toVar();
      const show = (weights: Vec3) =>
        vertexObserverPosition(
          sources,
          projection,
          triangleTable.interpolate(triangle, weights, { ...sources, colored: false }, instance),
        );
      const { levels, pattern } = patchFactors(cornerWeights(head, tail), show, metric);
      buffers.append(index, int(tail.w).toVar(), levels, pattern);
    })().compute(1);
    return { node, first };
  }
}

function byKernel(requests: readonly PatchRequest[]): Map<string, PatchRequest[]> {
  const families = new Map<string, PatchRequest[]>();
  for (const request of requests)
    families.set(request.kernelKey, [...(families.get(request.kernelKey) ?? []), request]);
  return families;
}
