import { attribute, float, int, vec3 } from 'three/tsl';
import { BufferAttribute, BufferGeometry } from 'three/webgpu';
import { cornerSources, type DrawCall, makeDrawCall } from '../../gbuffer/drawCall.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import { PATCH_FLOATS } from '../patches/patch.ts';
import { tessellatePatch } from '../patches/pattern.ts';
import type { PatchesByPattern } from '../plan/tessellationPlan.ts';
import type { TriangleTable } from './triangleTable.ts';

/** Floats per vertex: triangle, and the weights of its second and third corner. */
const VERTEX_FLOATS = 3;
const MIN_CAPACITY = 1024;

/**
 * The patches of a transparent batch as plain triangles in the order of the mesh, so that the order of blending does not depend on tessellation factors,
 * which are computed on the CPU.
 */
export class OrderedPatches {
  readonly drawCalls: readonly DrawCall[];
  private vertices = new Float32Array(VERTEX_FLOATS * MIN_CAPACITY);
  private used = 0;

  constructor(indexed: DrawCall, triangleTable: TriangleTable) {
    const vertex = (): VertexInput => {
      const { x: triangle, y: second, z: third } = attribute<'vec3'>('position', 'vec3');
      const weights = vec3(second.oneMinus().sub(third), second, third).toVar();
      return triangleTable.interpolate(int(triangle), weights, cornerSources(indexed), float(0));
    };
    const sources = { ...indexed, vertex: { ...indexed.vertex, vertex } };
    this.drawCalls = [makeDrawCall(geometryOf(this.vertices), sources)];
    this.hide();
  }

  /** `firstTriangle` is added to the patches' triangle indices. Returns the number of triangles. */
  show(patchesByPattern: PatchesByPattern, firstTriangle: number): number {
    this.used = 0;
    for (const patch of inTriangleOrder(patchesByPattern)) this.addPatch(patch, firstTriangle);
    this.upload();
    return this.used / (3 * VERTEX_FLOATS);
  }

  hide(): void {
    this.drawCalls[0].mesh.visible = false;
  }

  private addPatch([triangle, w01, w02, w11, w12, w21, w22, factors]: Float32Array, firstTriangle: number): void {
    const coordinates = tessellatePatch(factors);
    for (let v = 0; v < coordinates.length; v += 2) {
      const [f1, f2] = [coordinates[v], coordinates[v + 1]];
      const f0 = 1 - f1 - f2;
      this.add(triangle + firstTriangle, w01 * f0 + w11 * f1 + w21 * f2, w02 * f0 + w12 * f1 + w22 * f2);
    }
  }

  private add(triangle: number, second: number, third: number): void {
    if (this.used + VERTEX_FLOATS > this.vertices.length) {
      const grown = new Float32Array(2 * this.vertices.length);
      grown.set(this.vertices);
      this.vertices = grown;
    }
    this.vertices[this.used++] = triangle;
    this.vertices[this.used++] = second;
    this.vertices[this.used++] = third;
  }

  private upload(): void {
    const { mesh } = this.drawCalls[0];
    const position = mesh.geometry.getAttribute('position') as BufferAttribute;
    if (position.array === this.vertices) {
      position.clearUpdateRanges();
      position.addUpdateRange(0, this.used);
      position.needsUpdate = true;
    } else {
      mesh.geometry.dispose();
      mesh.geometry = geometryOf(this.vertices);
    }
    mesh.geometry.setDrawRange(0, this.used / VERTEX_FLOATS);
    mesh.visible = this.used > 0;
  }
}

function geometryOf(vertices: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(vertices, VERTEX_FLOATS));
  return geometry;
}

/** The patches of all patterns in the order of their triangles. */
function inTriangleOrder(patchesByPattern: PatchesByPattern): Float32Array[] {
  const ofAllPatterns = patchesByPattern.flatMap(({ patches, count }) =>
    Array.from({ length: count }, (_, i) => patches.subarray(PATCH_FLOATS * i, PATCH_FLOATS * (i + 1))),
  );
  return ofAllPatterns.sort((a, b) => a[0] - b[0]);
}
