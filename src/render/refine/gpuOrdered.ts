import { attribute, float, int, vec3 } from 'three/tsl';
import { BufferAttribute, BufferGeometry } from 'three/webgpu';
import { cornersOf, type Drawable, makeDrawable } from '../drawable.ts';
import type { VertexInput } from '../vertexInput.ts';
import type { Corners } from './gpuCorners.ts';
import { LEAF_FLOATS } from './leaf.ts';
import { cutLeaf } from './pattern.ts';
import type { Levelled } from './plan.ts';

/** Numbers per vertex: triangle, and the weights of its second and third corner. */
const SIZE = 3;
const LEAST_ROOM = 1024;

/**
 * A transparent batch with its pieces as plain triangles in the order of the mesh, so that it does not depend on levels what is blended over
 * what. Levels are found on the CPU.
 */
export class OrderedPieces {
  readonly drawables: readonly Drawable[];
  private places = new Float32Array(SIZE * LEAST_ROOM);
  private used = 0;

  constructor(indexed: Drawable, corners: Corners) {
    const vertex = (): VertexInput => {
      const { x: triangle, y: second, z: third } = attribute<'vec3'>('position', 'vec3');
      const weights = vec3(second.oneMinus().sub(third), second, third).toVar();
      return corners.point(int(triangle), weights, cornersOf(indexed), float(0));
    };
    const sources = { ...indexed, vertex: { ...indexed.vertex, vertex } };
    this.drawables = [makeDrawable(geometryOf(this.places), sources)];
    this.hide();
  }

  /** `firstTriangle` is added to the leaves' triangles. Tells how many triangles that makes. */
  show(levels: Levelled, firstTriangle: number): number {
    this.used = 0;
    for (const leaf of inOrder(levels)) this.addLeaf(leaf, firstTriangle);
    this.upload();
    return this.used / (3 * SIZE);
  }

  hide(): void {
    this.drawables[0].mesh.visible = false;
  }

  private addLeaf([triangle, w01, w02, w11, w12, w21, w22, levels]: Float32Array, firstTriangle: number): void {
    const places = cutLeaf(levels);
    for (let v = 0; v < places.length; v += 2) {
      const [f1, f2] = [places[v], places[v + 1]];
      const f0 = 1 - f1 - f2;
      this.add(triangle + firstTriangle, w01 * f0 + w11 * f1 + w21 * f2, w02 * f0 + w12 * f1 + w22 * f2);
    }
  }

  private add(triangle: number, second: number, third: number): void {
    if (this.used + SIZE > this.places.length) {
      const grown = new Float32Array(2 * this.places.length);
      grown.set(this.places);
      this.places = grown;
    }
    this.places[this.used++] = triangle;
    this.places[this.used++] = second;
    this.places[this.used++] = third;
  }

  private upload(): void {
    const { mesh } = this.drawables[0];
    const position = mesh.geometry.getAttribute('position') as BufferAttribute;
    if (position.array === this.places) {
      position.clearUpdateRanges();
      position.addUpdateRange(0, this.used);
      position.needsUpdate = true;
    } else {
      mesh.geometry.dispose();
      mesh.geometry = geometryOf(this.places);
    }
    mesh.geometry.setDrawRange(0, this.used / SIZE);
    mesh.visible = this.used > 0;
  }
}

function geometryOf(places: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, SIZE));
  return geometry;
}

/** Leaves of all levels in the order of their triangles. */
function inOrder(levels: Levelled): Float32Array[] {
  const all = levels.flatMap(({ leaves, count }) =>
    Array.from({ length: count }, (_, i) => leaves.subarray(LEAF_FLOATS * i, LEAF_FLOATS * (i + 1))),
  );
  return all.sort((a, b) => a[0] - b[0]);
}
