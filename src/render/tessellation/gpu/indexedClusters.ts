import { BufferAttribute, BufferGeometry, type TypedArray } from 'three/webgpu';
import type { DrawCall } from '../../gbuffer/drawCall.ts';
import { shareVertices } from '../../geometry/sharedGeometry.ts';
import { DRAWN } from '../criterion/projectedBody.ts';

/**
 * The clusters of a batch that are drawn as they are. The triangles of other clusters are collapsed to points in the index buffer, in place: few clusters
 * change from frame to frame, and only these are uploaded.
 */
export class IndexedClusters {
  private readonly drawCall: DrawCall;
  private readonly starts: Uint32Array;
  private readonly drawn: Uint8Array;
  /** Of its own since the first cluster was collapsed: the batch's is shared, and plans and the triangle table are made from it. */
  private index: BufferAttribute | undefined;

  /** `starts`: first triangle of each cluster, then the number of triangles. */
  constructor(drawCall: DrawCall, starts: Uint32Array) {
    this.drawCall = drawCall;
    this.starts = starts;
    this.drawn = new Uint8Array(starts.length - 1).fill(1);
  }

  /** Shows the clusters that are DRAWN, and returns the number of their triangles. */
  show(clusters: Uint8Array): number {
    let triangles = 0;
    for (let k = 0; k < clusters.length; k++) {
      const drawn = clusters[k] === DRAWN ? 1 : 0;
      if (drawn) triangles += this.starts[k + 1] - this.starts[k];
    }
    this.drawCall.mesh.visible = triangles > 0;
    // A hidden mesh need not be updated.
    if (triangles > 0) this.update(clusters);
    return triangles;
  }

  showAll(): number {
    return this.show(new Uint8Array(this.drawn.length).fill(DRAWN));
  }

  hide(): void {
    this.drawCall.mesh.visible = false;
  }

  private update(clusters: Uint8Array): void {
    const changed = (k: number) => (clusters[k] === DRAWN) !== (this.drawn[k] === 1);
    for (let k = 0; k < clusters.length; k++) {
      if (!changed(k)) continue;
      const first = k;
      this.index ??= this.makeIndex();
      for (; k < clusters.length && changed(k); k++) this.set(this.index.array, k, clusters[k] === DRAWN);
      this.index.addUpdateRange(3 * this.starts[first], 3 * (this.starts[k] - this.starts[first]));
      this.index.needsUpdate = true;
    }
  }

  private set(array: TypedArray, cluster: number, drawn: boolean): void {
    const allIndices = this.drawCall.batch.arrays.indices;
    const [from, to] = [3 * this.starts[cluster], 3 * this.starts[cluster + 1]];
    if (drawn) array.set(allIndices.subarray(from, to), from);
    else array.fill(allIndices[from], from, to);
    this.drawn[cluster] = drawn ? 1 : 0;
  }

  private makeIndex(): BufferAttribute {
    const { mesh, batch } = this.drawCall;
    const index = new BufferAttribute(batch.arrays.indices.slice(), 1);
    mesh.geometry = shareVertices(mesh.geometry, new BufferGeometry()).setIndex(index);
    return index;
  }
}
