import { attribute, float, int, vec3 } from 'three/tsl';
import { BufferAttribute, BufferGeometry } from 'three/webgpu';
import { cornerSources, type DrawCall, makeDrawCall } from '../../gbuffer/drawCall.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import { PATCH_FLOATS } from '../patches/patch.ts';
import { tessellatePatch } from '../patches/pattern.ts';
import type { PatchesByPattern } from '../plan/tessellationPlan.ts';
import type { TriangleTable } from './triangleTable.ts';

/** Numbers per vertex: triangle, and the weights of its second and third corner. */
const VERTEX_FLOATS = 3;
const MIN_CAPACITY = 1024;

/**
 * A transparent batch with its pieces as plain triangles in the order of the mesh, so that it does not depend on levels what is blended over
 * what. Levels are found on the CPU.
 */
export class OrderedPatches {
  readonly drawables: readonly DrawCall[];
  private places = new Float32Array(VERTEX_FLOATS * MIN_CAPACITY);
  private used = 0;

  constructor(indexed: DrawCall, corners: TriangleTable) {
    const vertex = (): VertexInput => {
      const { x: triangle, y: second, z: third } = attribute<'vec3'>('position', 'vec3');
      const weights = vec3(second.oneMinus().sub(third), second, third).toVar();
      return corners.interpolate(int(triangle), weights, cornerSources(indexed), float(0));
    };
    const sources = { ...indexed, vertex: { ...indexed.vertex, vertex } };
    this.drawables = [makeDrawCall(geometryOf(this.places), sources)];
    this.hide();
  }

  /** `firstTriangle` is added to the leaves' triangles. Tells how many triangles that makes. */
  show(levels: PatchesByPattern, firstTriangle: number): number {
    this.used = 0;
    for (const leaf of inTriangleOrder(levels)) this.addPatch(leaf, firstTriangle);
    this.upload();
    return this.used / (3 * VERTEX_FLOATS);
  }

  hide(): void {
    this.drawables[0].mesh.visible = false;
  }

  private addPatch([triangle, w01, w02, w11, w12, w21, w22, levels]: Float32Array, firstTriangle: number): void {
    const places = tessellatePatch(levels);
    for (let v = 0; v < places.length; v += 2) {
      const [f1, f2] = [places[v], places[v + 1]];
      const f0 = 1 - f1 - f2;
      this.add(triangle + firstTriangle, w01 * f0 + w11 * f1 + w21 * f2, w02 * f0 + w12 * f1 + w22 * f2);
    }
  }

  private add(triangle: number, second: number, third: number): void {
    if (this.used + VERTEX_FLOATS > this.places.length) {
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
    mesh.geometry.setDrawRange(0, this.used / VERTEX_FLOATS);
    mesh.visible = this.used > 0;
  }
}

function geometryOf(places: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, VERTEX_FLOATS));
  return geometry;
}

/** Leaves of all levels in the order of their triangles. */
function inTriangleOrder(levels: PatchesByPattern): Float32Array[] {
  const all = levels.flatMap(({ patches: leaves, count }) =>
    Array.from({ length: count }, (_, i) => leaves.subarray(PATCH_FLOATS * i, PATCH_FLOATS * (i + 1))),
  );
  return all.sort((a, b) => a[0] - b[0]);
}
