import type { BufferAttribute } from 'three/webgpu';
import type { DrawCall } from '../../gbuffer/drawCall.ts';
import { DRAWN } from '../criterion/projectedBody.ts';

/**
 * The clusters of a batch that are drawn as they are. The others' triangles shrink to points in the index buffer, in place: from picture to
 * picture few clusters change, and only they are uploaded.
 */
export class IndexedClusters {
  private readonly drawable: DrawCall;
  private readonly starts: Uint32Array;
  private readonly drawn: Uint8Array;
  private readonly index: BufferAttribute;
  private ownArray: Uint32Array | undefined;

  /** `starts`: first triangle of each cluster, and the number of triangles. */
  constructor(drawable: DrawCall, starts: Uint32Array) {
    const { index } = drawable.mesh.geometry;
    if (!index) throw new Error('a batch has indices');
    this.drawable = drawable;
    this.index = index;
    this.starts = starts;
    this.drawn = new Uint8Array(starts.length - 1).fill(1);
  }

  /** Shows the clusters that are DRAWN, and tells how many triangles they have. */
  show(clusters: Uint8Array): number {
    let triangles = 0;
    for (let k = 0; k < clusters.length; k++) {
      const drawn = clusters[k] === DRAWN ? 1 : 0;
      if (drawn) triangles += this.starts[k + 1] - this.starts[k];
    }
    this.drawable.mesh.visible = triangles > 0;
    // What nobody sees can stay as it was.
    if (triangles > 0) this.update(clusters);
    return triangles;
  }

  showAll(): number {
    return this.show(new Uint8Array(this.drawn.length).fill(DRAWN));
  }

  hide(): void {
    this.drawable.mesh.visible = false;
  }

  private update(clusters: Uint8Array): void {
    const changed = (k: number) => (clusters[k] === DRAWN) !== (this.drawn[k] === 1);
    for (let k = 0; k < clusters.length; k++) {
      if (!changed(k)) continue;
      const first = k;
      for (; k < clusters.length && changed(k); k++) this.set(k, clusters[k] === DRAWN);
      this.upload(this.starts[first], this.starts[k]);
    }
  }

  private set(cluster: number, drawn: boolean): void {
    const whole = this.drawable.batch.arrays.indices;
    const [from, to] = [3 * this.starts[cluster], 3 * this.starts[cluster + 1]];
    const array = this.ownIndices();
    if (drawn) array.set(whole.subarray(from, to), from);
    else array.fill(whole[from], from, to);
    this.drawn[cluster] = drawn ? 1 : 0;
  }

  private upload(fromTriangle: number, toTriangle: number): void {
    this.index.addUpdateRange(3 * fromTriangle, 3 * (toTriangle - fromTriangle));
    this.index.needsUpdate = true;
  }

  /** A copy, for plans and corners are made from the batch's indices. */
  private ownIndices(): Uint32Array {
    const { indices } = this.drawable.batch.arrays;
    this.ownArray ??= indices.slice();
    this.index.array = this.ownArray;
    return this.ownArray;
  }
}
