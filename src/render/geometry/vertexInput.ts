import { attribute, cross, dot, int, length, max, vec2, vec3, vertexIndex } from 'three/tsl';
import type { Node } from 'three/webgpu';
import { IDENTITY, type Mat3 } from '../../math/mat3.ts';
import type { Float, Int, Vec3 } from '../../shaders/types.ts';
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

/** Texels per instance in the instance table: the rows of its stretch, the first with the object's id − 1, the second with its material. */
export const INSTANCE_TEXELS = 3;

/** The texels of an instance. */
export const instanceTexels = (object: number, material: number, stretch: Mat3 = IDENTITY): readonly number[] => [
  ...[...stretch.slice(0, 3), object],
  ...[...stretch.slice(3, 6), material],
  ...[...stretch.slice(6, 9), 0],
];

/** A body that shares its mesh with others: what it is, and how it stretches the mesh. */
interface Instance extends Pick<VertexInput, 'object' | 'material'> {
  readonly offset: (x: Vec3) => Vec3;
  /** Of unit length. */
  readonly normal: (n: Vec3) => Vec3;
}

export function instanceOf(instances: FloatTable, instance: Float): Instance {
  const first = int(instance).mul(int(INSTANCE_TEXELS)).toVar();
  const rows = [0, 1, 2].map((k) => instances.texel(first.add(int(k))).toVar());
  const [x, y, z] = rows.map((row) => row.xyz);
  return {
    object: rows[0].w,
    material: rows[1].w,
    offset: (v) => vec3(dot(x, v), dot(y, v), dot(z, v)).toVar(),
    normal: (n) => {
      // Products of small numbers vanish in f32.
      const size = max(length(x), max(length(y), length(z)));
      const [a, b, c] = [x, y, z].map((row) => row.div(size).toVar());
      const turned = vec3(dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n)).toVar();
      return turned.div(max(length(turned), 1e-30)).toVar();
    },
  };
}

/** The vertex that the index buffer names; `instances`: set for batches with instancing. */
export function indexedVertex(colored: boolean, instances?: FloatTable): VertexInput {
  const instance = instances && instanceOf(instances, attribute<'float'>('instance', 'float'));
  const [position, normal] = ['position', 'normal'].map((name) => attribute<'vec3'>(name, 'vec3'));
  const ids = instance ? vec2(instance.object, instance.material) : attribute<'vec2'>('ids', 'vec2');
  return {
    offset: instance ? instance.offset(position) : position,
    get normal() {
      return instance ? instance.normal(normal) : normal;
    },
    uv: attribute<'vec2'>('uv', 'vec2'),
    color: colored ? attribute<'vec3'>('color', 'vec3') : undefined,
    object: ids.x,
    material: ids.y,
    ofVertices: (read) => read(int(vertexIndex)),
  };
}
