import { Fn, instanceIndex, int, uniform } from 'three/tsl';
import type { ComputeNode, WebGPURenderer } from 'three/webgpu';
import type { Vec3 } from '../../../shaders/types.ts';
import { type MotionSources, type SpacetimeProjection, vertexCameraPosition } from '../../geometry/vertexStage.ts';
import type { TessellationView } from '../criterion/tessellationView.ts';
import type { TessellationPlan } from '../plan/tessellationPlan.ts';
import type { PatchBuffers, PatchRange } from './patchBuffers.ts';
import { EdgeMetricUniforms, patchFactors } from './patchFactors.ts';
import { cornerWeights } from './shaderPatch.ts';
import type { TriangleTable } from './triangleTable.ts';

/** The patches of one batch in one view. */
export interface PatchRequest {
  /** The batch's index in the buffers. */
  readonly slot: number;
  /** The same for batches that can share a kernel: their bodies have one kind of motion, one set of sources, and one table of triangles. */
  readonly kernelKey: string;
  readonly sources: MotionSources;
  readonly triangles: TriangleTable;
  readonly plan: TessellationPlan;
  /** Added to the triangle and instance indices of the patches. */
  readonly firstTriangle: number;
  readonly firstInstance: number;
}

/** A kernel for the patches of all batches with one key, which are consecutive in the buffers. */
interface FactorKernel {
  readonly node: ComputeNode;
  readonly first: { value: number };
}

/**
 * WebGPU only: compute kernels that find the tessellation factors of each patch's edges, each from the edge alone, and append the patch to the list of its
 * pattern.
 */
export class FactorKernels {
  private readonly renderer: WebGPURenderer;
  private readonly buffers: PatchBuffers;
  private readonly metric = new EdgeMetricUniforms();
  private readonly kernels = new Map<string, FactorKernel>();
  private used = 0;

  constructor(renderer: WebGPURenderer, buffers: PatchBuffers) {
    this.renderer = renderer;
    this.buffers = buffers;
  }

  /** Whether the last view had patches. */
  get busy(): boolean {
    return this.used > 0;
  }

  /** The next view has no patches. */
  clear(): void {
    this.used = 0;
  }

  /** Fills the lists and returns where the patches of each request are. */
  dispatch(view: TessellationView, requests: readonly PatchRequest[]): ReadonlyMap<PatchRequest, PatchRange> {
    const ranges = new Map<PatchRequest, PatchRange>();
    this.buffers.begin(requests.reduce((sum, { plan }) => sum + plan.count, 0));
    const kernelNodes: ComputeNode[] = [];
    this.used = 0;
    for (const group of byKernel(requests).values()) {
      const kernel = this.kernel(group[0], view.projection);
      kernel.first.value = this.used;
      for (const request of group) {
        const range = { first: this.used, count: request.plan.count };
        this.buffers.write(request.slot, range, request.plan.patches, request.firstTriangle, request.firstInstance);
        ranges.set(request, range);
        this.used += range.count;
      }
      kernel.node.count = this.used - kernel.first.value;
      kernelNodes.push(kernel.node);
    }
    if (requests.length > 0) {
      this.metric.set(view, requests[0].plan.tolerance);
      this.renderer.compute(kernelNodes);
    }
    return ranges;
  }

  dispose(): void {
    for (const { node } of this.kernels.values()) node.dispose();
  }

  private kernel(request: PatchRequest, projection: SpacetimeProjection): FactorKernel {
    const name = `${request.kernelKey} ${projection.event} ${projection.place}`;
    const kernel = this.kernels.get(name) ?? this.makeKernel(request, projection);
    this.kernels.set(name, kernel);
    return kernel;
  }

  private makeKernel({ sources, triangles }: PatchRequest, projection: SpacetimeProjection): FactorKernel {
    const { buffers, metric } = this;
    const first = uniform(0, 'uint');
    const node = Fn(() => {
      const index = instanceIndex.add(first).toVar();
      const { head, tail, instance } = buffers.patch(index);
      const triangle = int(head.x).toVar();
      const project = (weights: Vec3) =>
        vertexCameraPosition(
          sources,
          projection,
          triangles.interpolate(triangle, weights, { ...sources, colored: false }, instance),
        );
      const { factors, pattern } = patchFactors(
        cornerWeights(head, tail),
        project,
        metric,
        triangles.isRound(triangle),
      );
      buffers.append(index, int(tail.w).toVar(), factors, pattern);
    })().compute(1);
    return { node, first };
  }
}

function byKernel(requests: readonly PatchRequest[]): Map<string, PatchRequest[]> {
  const byKey = new Map<string, PatchRequest[]>();
  for (const request of requests) byKey.set(request.kernelKey, [...(byKey.get(request.kernelKey) ?? []), request]);
  return byKey;
}
