import { BufferAttribute, InstancedBufferAttribute, InstancedBufferGeometry } from 'three/webgpu';
import { type DrawCall, makeDrawCall } from '../../gbuffer/drawCall.ts';
import type { BatchInstancing } from '../../geometry/batches.ts';
import { shareVertices } from '../../geometry/sharedGeometry.ts';
import { DRAWN } from '../criterion/projectedBody.ts';

/**
 * The clusters of a mesh that many bodies share. Bodies with all clusters DRAWN are drawn together as instances; each body with only some of them, by an
 * index buffer of its own on the same vertices.
 */
export class InstancedClusters {
  private readonly drawCall: DrawCall;
  private readonly instancing: BatchInstancing;
  private readonly starts: Uint32Array;
  private readonly add: (drawCall: DrawCall) => void;
  private readonly instances: InstancedBufferAttribute;
  private readonly geometry: InstancedBufferGeometry;
  /** Single bodies in use, by the index of their body. */
  private readonly singles = new Map<number, SingleBody>();
  private readonly unused: SingleBody[] = [];

  /** `starts`: first triangle of each cluster, then the number of triangles. `add` is called with each draw call that is created. */
  constructor(drawCall: DrawCall, instancing: BatchInstancing, starts: Uint32Array, add: (drawCall: DrawCall) => void) {
    this.drawCall = drawCall;
    this.instancing = instancing;
    this.starts = starts;
    this.add = add;
    this.instances = new InstancedBufferAttribute(new Float32Array(instancing.materials.length), 1);
    const { geometry: whole } = drawCall.mesh;
    this.geometry = shareVertices(whole, new InstancedBufferGeometry());
    this.geometry.setIndex(whole.index);
    this.geometry.setAttribute('instance', this.instances);
    drawCall.mesh.geometry = this.geometry;
  }

  /** Shows the clusters that are DRAWN, and returns the number of their triangles. */
  show(clusters: Uint8Array): number {
    const clusterCount = this.starts.length - 1;
    const bodies = this.instancing.materials.length;
    const wholeBodies: number[] = [];
    let triangles = 0;
    for (let body = 0; body < bodies; body++) {
      const states = clusters.subarray(clusterCount * body, clusterCount * (body + 1));
      const drawn = this.trianglesOf(states);
      triangles += drawn;
      if (drawn === this.starts[clusterCount]) wholeBodies.push(this.instancing.first + body);
      if (drawn === 0 || drawn === this.starts[clusterCount]) this.release(body);
    }
    for (let body = 0; body < bodies; body++) {
      const states = clusters.subarray(clusterCount * body, clusterCount * (body + 1));
      const drawn = this.trianglesOf(states);
      if (drawn > 0 && drawn < this.starts[clusterCount]) this.single(body).show(states);
    }
    this.showInstances(wholeBodies);
    return triangles;
  }

  showAll(): number {
    return this.show(new Uint8Array(this.instancing.materials.length * (this.starts.length - 1)).fill(DRAWN));
  }

  hide(): void {
    this.drawCall.mesh.visible = false;
    for (const body of [...this.singles.keys()]) this.release(body);
  }

  private trianglesOf(states: Uint8Array): number {
    let triangles = 0;
    for (let k = 0; k < states.length; k++) if (states[k] === DRAWN) triangles += this.starts[k + 1] - this.starts[k];
    return triangles;
  }

  private showInstances(wholeBodies: readonly number[]): void {
    const { array } = this.instances;
    const changed =
      wholeBodies.length !== this.geometry.instanceCount || wholeBodies.some((instance, i) => array[i] !== instance);
    this.drawCall.mesh.visible = wholeBodies.length > 0;
    if (wholeBodies.length === 0 || !changed) return;
    array.set(wholeBodies);
    this.geometry.instanceCount = wholeBodies.length;
    this.instances.clearUpdateRanges();
    this.instances.addUpdateRange(0, wholeBodies.length);
    this.instances.needsUpdate = true;
  }

  private release(body: number): void {
    const single = this.singles.get(body);
    if (!single) return;
    single.hide();
    this.singles.delete(body);
    this.unused.push(single);
  }

  private single(body: number): SingleBody {
    const existing = this.singles.get(body);
    if (existing) return existing;
    const single = this.unused.pop() ?? new SingleBody(this.drawCall, this.starts, this.add);
    this.singles.set(body, single);
    single.setInstance(this.instancing.first + body);
    return single;
  }
}

/** One body with some of its clusters. */
class SingleBody {
  private readonly drawCall: DrawCall;
  private readonly whole: Uint32Array;
  private readonly starts: Uint32Array;
  private readonly index: BufferAttribute;
  private readonly instance: InstancedBufferAttribute;
  private lastStates = new Uint8Array();

  constructor(drawCall: DrawCall, starts: Uint32Array, add: (drawCall: DrawCall) => void) {
    this.whole = drawCall.batch.arrays.indices;
    this.starts = starts;
    this.index = new BufferAttribute(new Uint32Array(this.whole.length), 1);
    this.instance = new InstancedBufferAttribute(new Float32Array(1), 1);
    const geometry = shareVertices(drawCall.mesh.geometry, new InstancedBufferGeometry());
    geometry.setIndex(this.index);
    geometry.setAttribute('instance', this.instance);
    geometry.instanceCount = 1;
    // All share one shader, so one set of materials.
    this.drawCall = { ...makeDrawCall(geometry, drawCall), materials: drawCall.materials };
    add(this.drawCall);
  }

  setInstance(instance: number): void {
    this.instance.array[0] = instance;
    this.instance.needsUpdate = true;
  }

  /** Shows the clusters that are DRAWN. */
  show(states: Uint8Array): void {
    this.drawCall.mesh.visible = true;
    if (
      states.length === this.lastStates.length &&
      states.every((state, k) => (state === DRAWN) === (this.lastStates[k] === DRAWN))
    )
      return;
    this.lastStates = states.slice();
    let used = 0;
    for (let k = 0; k < states.length; k++) {
      if (states[k] !== DRAWN) continue;
      const indices = this.whole.subarray(3 * this.starts[k], 3 * this.starts[k + 1]);
      this.index.array.set(indices, used);
      used += indices.length;
    }
    this.index.clearUpdateRanges();
    this.index.addUpdateRange(0, used);
    this.index.needsUpdate = true;
    this.drawCall.mesh.geometry.setDrawRange(0, used);
  }

  hide(): void {
    this.drawCall.mesh.visible = false;
  }
}
