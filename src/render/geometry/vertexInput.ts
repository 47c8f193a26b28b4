import { attribute, int, vertexIndex } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Float, Int, Vec3, Vec4 } from '../../shaders/types.ts';
import type { FloatTable } from '../gpu/floatTable.ts';

/** A vertex before its motion is applied: of a mesh (`indexedVertex`), or a point in one of its triangles (tessellation/gpu/triangleTable.ts). */
export interface VertexInput {
  /** From the body's centre [m]; unused if the mesh deforms. */
  readonly offset: Vec3;
  readonly normal: Vec3;
  readonly uv: Node<'vec2'>;
  /** Linear RGB. */
  readonly color: Vec3 | undefined;
  /** Object id − 1. */
  readonly object: Float;
  readonly material: Float;
  /** For deforming meshes: what `read` gives for this vertex of the mesh; of a point in a triangle, interpolated from its corners. */
  readonly ofVertices: (read: (vertex: Int) => Vec3) => Vec3;
}

/** The instance table's texel for an instance: (object id − 1, material, 0, 0). */
export const instanceRecord = (instances: FloatTable, instance: Float): Vec4 => instances.texel(int(instance)).toVar();

/** The vertex that the index buffer names; `instances`: set for batches with instancing. */
export function indexedVertex(colored: boolean, instances?: FloatTable): VertexInput {
  const ids = instances
    ? instanceRecord(instances, attribute<'float'>('instance', 'float')).xy
    : attribute<'vec2'>('ids', 'vec2');
  return {
    offset: attribute<'vec3'>('position', 'vec3'),
    normal: attribute<'vec3'>('normal', 'vec3'),
    uv: attribute<'vec2'>('uv', 'vec2'),
    color: colored ? attribute<'vec3'>('color', 'vec3') : undefined,
    object: ids.x,
    material: ids.y,
    ofVertices: (read) => read(int(vertexIndex)),
  };
}
