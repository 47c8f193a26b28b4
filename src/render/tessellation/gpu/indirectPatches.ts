import { attribute, instanceIndex, int, uniform } from 'three/tsl';
import { type BufferAttribute, BufferGeometry } from 'three/webgpu';
import { cornerSources, type DrawCall, makeDrawCall } from '../../gbuffer/drawCall.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import type { PatchBuffers, PatchRange } from './patchBuffers.ts';
import { weightsAt } from './shaderPatch.ts';
import type { TriangleTable } from './triangleTable.ts';

/** The leaves of one batch, drawn from the lists that a kernel filled (factorKernels.ts): one indirect draw per pattern. */
export class IndirectPatches {
  readonly drawables: readonly DrawCall[];
  private readonly first = uniform(0, 'uint');
  private readonly count = uniform(0, 'uint');

  /** `patterns`: all, as patternGeometry.ts makes them. */
  constructor(
    indexed: DrawCall,
    slot: number,
    patterns: BufferGeometry,
    corners: TriangleTable,
    buffers: PatchBuffers,
  ) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', patterns.getAttribute('position') as BufferAttribute);
    geometry.setIndex(patterns.index);
    geometry.setIndirect(buffers.draws, buffers.offsets(slot));
    const { first, count } = this;
    const vertex = (): VertexInput => {
      const place = attribute<'vec3'>('position', 'vec3');
      const leaf = buffers.patchOfInstance({ first, count }, int(place.z), instanceIndex);
      const weights = weightsAt(leaf, place.x, place.y);
      return corners.interpolate(int(leaf.head.x), weights, cornerSources(indexed), leaf.instance);
    };
    this.drawables = [makeDrawCall(geometry, { ...indexed, vertex: { ...indexed.vertex, vertex } })];
  }

  show(run: PatchRange): void {
    this.first.value = run.first;
    this.count.value = run.count;
    this.drawables[0].mesh.visible = run.count > 0;
  }

  hide(): void {
    this.drawables[0].mesh.visible = false;
  }
}
