import { type BufferGeometry, type Object3D, Mesh as ThreeMesh } from 'three';
import type { Scene } from '../../src/scene/types.ts';

/** Triangles as sorted text, each beginning with its smallest corner, so that equal meshes compare equal in any order. */
type Soup = string[];

const digits = (x: number | undefined): string => (Math.abs(x ?? 0) < 5e-7 ? 0 : (x ?? 0)).toFixed(5);
const canonical = (corners: string[]): string => {
  const least = corners.indexOf([...corners].sort()[0]);
  return [...corners.slice(least), ...corners.slice(0, least)].join(' | ');
};

/** Positions and uvs (and normals on request) of all meshes read by three.js. */
export function threeSoup(root: Object3D, withNormals = false): Soup {
  const out: Soup = [];
  root.traverse((thing) => {
    if (!(thing instanceof ThreeMesh)) return;
    const { attributes, index } = thing.geometry as BufferGeometry;
    const count = index ? index.count : attributes.position.count;
    const corner = (i: number): string => {
      const v = index ? index.getX(i) : i;
      const { position: p, uv, normal: n } = attributes;
      const parts = [p.getX(v), p.getY(v), p.getZ(v), uv?.getX(v), uv?.getY(v)];
      return [...parts, ...(withNormals ? [n.getX(v), n.getY(v), n.getZ(v)] : [])].map(digits).join(',');
    };
    for (let i = 0; i + 2 < count; i += 3) out.push(canonical([corner(i), corner(i + 1), corner(i + 2)]));
  });
  return out.sort();
}

/** The same for a scene whose objects are at rest at the origin. */
export function sceneSoup({ objects }: Scene, withNormals = false): Soup {
  const out: Soup = [];
  for (const { mesh } of objects) {
    const corner = (v: number): string => {
      const at = (from: Float32Array, size: number): number[] => [...from.subarray(size * v, size * v + size)];
      const parts = [...at(mesh.positions, 3), ...at(mesh.uvs, 2), ...(withNormals ? at(mesh.normals, 3) : [])];
      return parts.map(digits).join(',');
    };
    for (let i = 0; i < mesh.indices.length; i += 3) {
      out.push(canonical([corner(mesh.indices[i]), corner(mesh.indices[i + 1]), corner(mesh.indices[i + 2])]));
    }
  }
  return out.sort();
}
