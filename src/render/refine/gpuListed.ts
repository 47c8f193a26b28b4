import { attribute, instanceIndex, int, uniform } from 'three/tsl';
import { type BufferAttribute, BufferGeometry } from 'three/webgpu';
import { cornersOf, type Drawable, makeDrawable } from '../drawable.ts';
import type { VertexInput } from '../vertexInput.ts';
import type { LeafBuffers, LeafRun } from './gpuBuffers.ts';
import type { Corners } from './gpuCorners.ts';
import { weightsAt } from './gpuLeaf.ts';

/** The leaves of one batch, drawn from the lists that a kernel filled (gpuLevels.ts): one indirect draw per pattern. */
export class ListedPieces {
  readonly drawables: readonly Drawable[];
  private readonly first = uniform(0, 'uint');
  private readonly count = uniform(0, 'uint');

  /** `patterns`: all, as gpuPatterns.ts makes them. */
  constructor(indexed: Drawable, slot: number, patterns: BufferGeometry, corners: Corners, buffers: LeafBuffers) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', patterns.getAttribute('position') as BufferAttribute);
    geometry.setIndex(patterns.index);
    geometry.setIndirect(buffers.draws, buffers.offsets(slot));
    const { first, count } = this;
    const vertex = (): VertexInput => {
      const place = attribute<'vec3'>('position', 'vec3');
      const leaf = buffers.listed({ first, count }, int(place.z), instanceIndex);
      const weights = weightsAt(leaf, place.x, place.y);
      return corners.point(int(leaf.head.x), weights, cornersOf(indexed), leaf.instance);
    };
    this.drawables = [makeDrawable(geometry, { ...indexed, vertex: { ...indexed.vertex, vertex } })];
  }

  show(run: LeafRun): void {
    this.first.value = run.first;
    this.count.value = run.count;
    this.drawables[0].mesh.visible = run.count > 0;
  }

  hide(): void {
    this.drawables[0].mesh.visible = false;
  }
}
