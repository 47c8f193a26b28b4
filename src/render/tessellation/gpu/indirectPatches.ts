import { attribute, instanceIndex, int, uniform } from 'three/tsl';
import { type BufferAttribute, BufferGeometry } from 'three/webgpu';
import { cornerSources, type DrawCall, makeDrawCall } from '../../gbuffer/drawCall.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import type { PatchBuffers, PatchRange } from './patchBuffers.ts';
import { weightsAt } from './shaderPatch.ts';
import type { TriangleTable } from './triangleTable.ts';

/** The patches of one batch, drawn from the lists that a compute kernel has filled (factorKernels.ts): one indirect draw per pattern. */
export class IndirectPatches {
  readonly drawCalls: readonly DrawCall[];
  private readonly first = uniform(0, 'uint');
  private readonly count = uniform(0, 'uint');

  /** `patterns`: geometry of all patterns (patternGeometry.ts). */
  constructor(
    indexed: DrawCall,
    slot: number,
    patterns: BufferGeometry,
    triangleTable: TriangleTable,
    buffers: PatchBuffers,
  ) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', patterns.getAttribute('position') as BufferAttribute);
    geometry.setIndex(patterns.index);
    geometry.setIndirect(buffers.draws, buffers.offsets(slot));
    const { first, count } = this;
    const vertex = (): VertexInput => {
      const coordinate = attribute<'vec3'>('position', 'vec3');
      const patch = buffers.patchOfInstance({ first, count }, int(coordinate.z), instanceIndex);
      const weights = weightsAt(patch, coordinate.x, coordinate.y);
      return triangleTable.interpolate(int(patch.head.x), weights, cornerSources(indexed), patch.instance);
    };
    this.drawCalls = [makeDrawCall(geometry, { ...indexed, vertex: { ...indexed.vertex, vertex } })];
  }

  show(range: PatchRange): void {
    this.first.value = range.first;
    this.count.value = range.count;
    this.drawCalls[0].mesh.visible = range.count > 0;
  }

  hide(): void {
    this.drawCalls[0].mesh.visible = false;
  }
}
