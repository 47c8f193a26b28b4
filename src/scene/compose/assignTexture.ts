import type { Texture } from '../materials/texture.ts';
import { bakedObject } from '../mesh/stretch.ts';
import type { Material, Mesh, Scene, SceneObject } from '../types.ts';
import { withObjects } from './assignMaterial.ts';

/** How a texture lies on objects. */
export interface TexturePlacement {
  readonly texture: Texture;
  /** Linear sRGB factor of the texels. */
  readonly tint: Material['baseColor'];
  /** How often it repeats per unit of u and v. */
  readonly repeat: readonly [u: number, v: number];
  /** Side of one repetition [m] of a texture that is projected along the axis nearest to each triangle's normal; absent: the objects' own u and v. */
  readonly projected?: number;
}

/**
 * Puts a picture on all objects at a path and below it, in place of their base colour. Their materials keep everything
 * else; vertex colours and measured reflectances, which it would fight with, go.
 */
export function assignTexture(scene: Scene, path: string, how: TexturePlacement): Scene {
  const materials = [...scene.materials];
  const textured = new Map<number, number>();
  const meshes = new Map<Mesh, Mesh>();
  const material = (index: number): number => {
    const known = textured.get(index);
    if (known !== undefined) return known;
    const { reflectance: _, ...plain } = scene.materials[index]!;
    textured.set(index, materials.length);
    return materials.push({ ...plain, baseColor: how.tint, baseColorTexture: how.texture }) - 1;
  };
  const mesh = (of: Mesh): Mesh => {
    const known = meshes.get(of);
    if (known) return known;
    const { colors: _, ...plain } = how.projected === undefined ? scaled(of, how.repeat) : projected(of, how.projected);
    const groups = plain.groups.map((group) => ({ ...group, material: material(group.material) }));
    meshes.set(of, { ...plain, groups });
    return { ...plain, groups };
  };
  const objects = withObjects(scene, path, (object) => {
    const plain = how.projected === undefined ? object : bakedObject(object);
    return { ...plain, mesh: meshes.get(plain.mesh) ?? mesh(plain.mesh) };
  });
  return { ...scene, objects, materials };
}

/** Whether a mesh has texture coordinates: not all are the same. */
export const hasUvs = ({ uvs }: Mesh): boolean => uvs.some((x, i) => x !== uvs[i % 2]);

/** Whether a texture can be projected onto an object: its points are not samples of their own. */
export const canProject = ({ motion }: SceneObject): boolean => motion.kind !== 'sampled-points';

function scaled(mesh: Mesh, [u, v]: readonly [number, number]): Mesh {
  if (u === 1 && v === 1) return mesh;
  return { ...mesh, uvs: mesh.uvs.map((x, i) => x * (i % 2 === 0 ? u : v)) };
}

/** Each triangle gets vertices of its own, with the two coordinates across its normal's largest component, over `side`. */
function projected(mesh: Mesh, side: number): Mesh {
  const { indices, positions, normals } = mesh;
  const count = indices.length;
  const out = {
    positions: new Float32Array(3 * count),
    normals: new Float32Array(3 * count),
    uvs: new Float32Array(2 * count),
  };
  for (let corner = 0; corner < count; corner += 3) {
    const [across, up, mirrored] = axesOf(positions, indices, corner);
    for (let i = corner; i < corner + 3; i++) {
      const vertex = 3 * indices[i]!;
      for (let k = 0; k < 3; k++) {
        out.positions[3 * i + k] = positions[vertex + k]!;
        out.normals[3 * i + k] = normals[vertex + k]!;
      }
      out.uvs[2 * i] = ((mirrored ? -1 : 1) * positions[vertex + across]!) / side;
      out.uvs[2 * i + 1] = positions[vertex + up]! / side;
    }
  }
  return { ...mesh, ...out, indices: Uint32Array.from({ length: count }, (_, i) => i) };
}

/** The axes of u and v for a triangle, and whether u runs against its axis, so that a picture is not seen from behind. */
function axesOf(positions: Float32Array, indices: Uint32Array, corner: number): readonly [number, number, boolean] {
  const at = (i: number, k: number): number => positions[3 * indices[corner + i]! + k]!;
  const edge = (i: number, k: number): number => at(i, k) - at(0, k);
  const normal = [0, 1, 2].map((k) => {
    const [a, b] = [(k + 1) % 3, (k + 2) % 3];
    return edge(1, a) * edge(2, b) - edge(1, b) * edge(2, a);
  });
  const along = normal.map(Math.abs);
  const axis = along.indexOf(Math.max(...along));
  const [across, up] = [
    [2, 1],
    [0, 2],
    [0, 1],
  ][axis] as [number, number];
  return [across, up, axis === 2 ? normal[axis]! < 0 : normal[axis]! > 0];
}
