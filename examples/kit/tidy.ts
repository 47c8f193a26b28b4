import type { Mesh } from '../../src/scene/types.ts';

const rounded = (values: Float32Array, digits: number): Float32Array => {
  const k = 10 ** digits;
  return values.map((x) => Math.round(x * k) / k + 0);
};

/** Rounds positions to 0.1 mm and normals to 0.001, so that the text of a scene is short. */
export const roundForText = (mesh: Mesh): Mesh => ({
  ...mesh,
  positions: rounded(mesh.positions, 4),
  normals: rounded(mesh.normals, 3),
  uvs: rounded(mesh.uvs, 4),
});
