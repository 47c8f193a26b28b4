import { BufferAttribute, InstancedBufferAttribute, InstancedBufferGeometry } from 'three/webgpu';
import { type DrawCall, makeDrawCall } from '../../gbuffer/drawCall.ts';
import type { BatchInstancing } from '../../geometry/batches.ts';
import { DRAWN } from '../criterion/projectedBody.ts';

/** Attributes of a vertex, which all draws of a mesh share. */
const VERTEX_ATTRIBUTES = ['position', 'normal', 'uv', 'color'];

/**
 * The clusters of a mesh that many bodies wear. Bodies of which all are drawn as they are are drawn together, as
 * instances; each of the others, of which some are, by an index buffer of its own on the same vertices.
 */
export class InstancedClusters {
  private readonly drawable: DrawCall;
  private readonly instancing: BatchInstancing;
  private readonly starts: Uint32Array;
  private readonly add: (drawable: DrawCall) => void;
  private readonly instances: InstancedBufferAttribute;
  private readonly geometry: InstancedBufferGeometry;
  /** By the body that each was made for, or is kept for. */
  private readonly singles = new Map<number, SingleBody>();
  private readonly free: SingleBody[] = [];

  /** `starts`: first triangle of each cluster, and the number of triangles. `add` is given drawables as they are made. */
  constructor(drawable: DrawCall, worn: BatchInstancing, starts: Uint32Array, add: (drawable: DrawCall) => void) {
    this.drawable = drawable;
    this.instancing = worn;
    this.starts = starts;
    this.add = add;
    this.instances = new InstancedBufferAttribute(new Float32Array(worn.materials.length), 1);
    this.geometry = sharedGeometry(drawable);
    this.geometry.setIndex(drawable.mesh.geometry.index);
    this.geometry.setAttribute('instance', this.instances);
    drawable.mesh.geometry = this.geometry;
  }

  /** Shows the clusters that are DRAWN, and tells how many triangles they have. */
  show(clusters: Uint8Array): number {
    const each = this.starts.length - 1;
    const bodies = this.instancing.materials.length;
    const whole: number[] = [];
    let triangles = 0;
    for (let body = 0; body < bodies; body++) {
      const fates = clusters.subarray(each * body, each * (body + 1));
      const drawn = this.trianglesOf(fates);
      triangles += drawn;
      if (drawn === this.starts[each]) whole.push(this.instancing.first + body);
      if (drawn === 0 || drawn === this.starts[each]) this.release(body);
    }
    for (let body = 0; body < bodies; body++) {
      const fates = clusters.subarray(each * body, each * (body + 1));
      const drawn = this.trianglesOf(fates);
      if (drawn > 0 && drawn < this.starts[each]) this.single(body).show(fates);
    }
    this.showInstances(whole);
    return triangles;
  }

  showAll(): number {
    return this.show(new Uint8Array(this.instancing.materials.length * (this.starts.length - 1)).fill(DRAWN));
  }

  hide(): void {
    this.drawable.mesh.visible = false;
    for (const body of [...this.singles.keys()]) this.release(body);
  }

  private trianglesOf(fates: Uint8Array): number {
    let triangles = 0;
    for (let k = 0; k < fates.length; k++) if (fates[k] === DRAWN) triangles += this.starts[k + 1] - this.starts[k];
    return triangles;
  }

  private showInstances(whole: readonly number[]): void {
    const { array } = this.instances;
    const changed = whole.length !== this.geometry.instanceCount || whole.some((instance, i) => array[i] !== instance);
    this.drawable.mesh.visible = whole.length > 0;
    if (whole.length === 0 || !changed) return;
    array.set(whole);
    this.geometry.instanceCount = whole.length;
    this.instances.clearUpdateRanges();
    this.instances.addUpdateRange(0, whole.length);
    this.instances.needsUpdate = true;
  }

  private release(body: number): void {
    const single = this.singles.get(body);
    if (!single) return;
    single.hide();
    this.singles.delete(body);
    this.free.push(single);
  }

  private single(body: number): SingleBody {
    const known = this.singles.get(body);
    if (known) return known;
    const single = this.free.pop() ?? new SingleBody(this.drawable, this.starts, this.add);
    this.singles.set(body, single);
    single.setInstance(this.instancing.first + body);
    return single;
  }
}

/** One body with some of its clusters. */
class SingleBody {
  private readonly drawable: DrawCall;
  private readonly whole: Uint32Array;
  private readonly starts: Uint32Array;
  private readonly index: BufferAttribute;
  private readonly instance: InstancedBufferAttribute;
  private shown = new Uint8Array();

  constructor(drawable: DrawCall, starts: Uint32Array, add: (drawable: DrawCall) => void) {
    this.whole = drawable.batch.arrays.indices;
    this.starts = starts;
    this.index = new BufferAttribute(new Uint32Array(this.whole.length), 1);
    this.instance = new InstancedBufferAttribute(new Float32Array(1), 1);
    const geometry = sharedGeometry(drawable);
    geometry.setIndex(this.index);
    geometry.setAttribute('instance', this.instance);
    geometry.instanceCount = 1;
    // One shader for all, so one set of materials.
    this.drawable = { ...makeDrawCall(geometry, drawable), materials: drawable.materials };
    add(this.drawable);
  }

  setInstance(instance: number): void {
    this.instance.array[0] = instance;
    this.instance.needsUpdate = true;
  }

  /** Shows the clusters that are DRAWN. */
  show(fates: Uint8Array): void {
    this.drawable.mesh.visible = true;
    if (fates.length === this.shown.length && fates.every((fate, k) => (fate === DRAWN) === (this.shown[k] === DRAWN)))
      return;
    this.shown = fates.slice();
    let used = 0;
    for (let k = 0; k < fates.length; k++) {
      if (fates[k] !== DRAWN) continue;
      const run = this.whole.subarray(3 * this.starts[k], 3 * this.starts[k + 1]);
      this.index.array.set(run, used);
      used += run.length;
    }
    this.index.clearUpdateRanges();
    this.index.addUpdateRange(0, used);
    this.index.needsUpdate = true;
    this.drawable.mesh.geometry.setDrawRange(0, used);
  }

  hide(): void {
    this.drawable.mesh.visible = false;
  }
}

function sharedGeometry({ mesh }: DrawCall): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  for (const name of VERTEX_ATTRIBUTES) {
    const attribute = mesh.geometry.getAttribute(name);
    if (attribute) geometry.setAttribute(name, attribute);
  }
  return geometry;
}
