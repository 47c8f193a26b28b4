import type { Vec3 } from '../../math/vec3.ts';
import type { Mesh } from '../types.ts';
import { mergeMeshes, transformMesh } from './meshOps.ts';
import { box } from './primitives.ts';

/**
 * Square bars along all edges of nx × ny × nz cubes, centred on the origin [m]. Bars end at the faces of a small cube at each node, so that no parts overlap.
 */
export function lattice(cells: readonly [number, number, number], cell: number, thickness: number): Mesh {
  const parts: Mesh[] = [];
  const addAt = (mesh: Mesh, at: Vec3): void => {
    parts.push(transformMesh(mesh, [1, 0, 0, at[0], 0, 1, 0, at[1], 0, 0, 1, at[2], 0, 0, 0, 1]));
  };
  const width = Math.min(thickness, cell);
  const node = box([width, width, width]);
  const bars = [0, 1, 2].map((axis) =>
    box([0, 1, 2].map((k) => (k === axis ? cell - width : width)) as unknown as Vec3),
  );
  const at = (i: number, axis: number): number => (i - cells[axis] / 2) * cell;
  for (let i = 0; i <= cells[0]; i++)
    for (let j = 0; j <= cells[1]; j++)
      for (let k = 0; k <= cells[2]; k++) {
        const here: Vec3 = [at(i, 0), at(j, 1), at(k, 2)];
        addAt(node, here);
        if (width === cell) continue;
        [i, j, k].forEach((index, axis) => {
          if (index < cells[axis])
            addAt(bars[axis], here.map((x, n) => (n === axis ? x + cell / 2 : x)) as unknown as Vec3);
        });
      }
  return mergeMeshes(parts);
}
