import { add, dot, length, normalize, scale, type Vec3 } from '../../src/math/vec3.ts';

/** A value at each point, positive inside a body, and its gradient [1/m]. */
export interface Field {
  value(p: Vec3): number;
  gradient(p: Vec3): Vec3;
}

/** The surface of a body, with as many vertices as cells that it crosses. */
export interface SurfaceNet {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly indices: Uint32Array;
}

/** Corners of a cell by bits: x, y, z. */
const corner = (bits: number): Vec3 => [bits & 1, (bits >> 1) & 1, (bits >> 2) & 1];
const EDGES = [0, 1, 2].flatMap((axis) =>
  [0, 1, 2, 3, 4, 5, 6, 7].flatMap((bits) => (bits & (1 << axis) ? [] : [[bits, bits | (1 << axis)] as const])),
);

/**
 * The surface at which a field is zero, by surface nets (Gibson 1998): a vertex in each cell that it crosses, at the mean of its crossings of the edges, moved
 * onto the surface along the gradient; a quad around each crossed edge. `size`: of a cell [m]; the body lies within the box.
 */
export function surfaceNet(field: Field, low: Vec3, counts: Vec3, size: number): SurfaceNet {
  const [nx, ny] = [counts[0] + 1, counts[1] + 1];
  const indexOf = (i: number, j: number, k: number): number => i + nx * (j + ny * k);
  const placeOf = (i: number, j: number, k: number): Vec3 => [low[0] + size * i, low[1] + size * j, low[2] + size * k];
  const values: number[] = [];
  for (let k = 0; k <= counts[2]; k++)
    for (let j = 0; j <= counts[1]; j++)
      for (let i = 0; i <= counts[0]; i++) values[indexOf(i, j, k)] = field.value(placeOf(i, j, k));
  const positions: number[] = [];
  const normals: number[] = [];
  const vertexOf = new Map<number, number>();
  for (let k = 0; k < counts[2]; k++)
    for (let j = 0; j < counts[1]; j++)
      for (let i = 0; i < counts[0]; i++) {
        const at = (bits: number): number => {
          const [x, y, z] = corner(bits);
          return values[indexOf(i + x, j + y, k + z)];
        };
        const crossings = EDGES.filter(([a, b]) => at(a) > 0 !== at(b) > 0).map(([a, b]) => {
          const s = at(a) / (at(a) - at(b));
          return corner(a).map((x, axis) => x + s * (corner(b)[axis] - x));
        });
        if (crossings.length === 0) continue;
        const [x, y, z] = [0, 1, 2].map((axis) => crossings.reduce((sum, p) => sum + p[axis], 0) / crossings.length);
        const p = ontoSurface(field, placeOf(i + x, j + y, k + z), size);
        vertexOf.set(indexOf(i, j, k), positions.length / 3);
        positions.push(...p);
        normals.push(...outward(field.gradient(p)));
      }
  const indices: number[] = [];
  for (let k = 1; k < counts[2]; k++)
    for (let j = 1; j < counts[1]; j++)
      for (let i = 1; i < counts[0]; i++)
        for (let axis = 0; axis < 3; axis++) {
          const step = [0, 1, 2].map((other) => (other === axis ? 1 : 0));
          const isInside = values[indexOf(i, j, k)] > 0;
          if (isInside === values[indexOf(i + step[0], j + step[1], k + step[2])] > 0) continue;
          // The four cells around the edge, counterclockwise about it.
          const around = [
            [-1, -1],
            [0, -1],
            [0, 0],
            [-1, 0],
          ].map(([u, v]) => {
            const offset = [0, 0, 0];
            offset[(axis + 1) % 3] = u;
            offset[(axis + 2) % 3] = v;
            return vertexOf.get(indexOf(i + offset[0], j + offset[1], k + offset[2]))!;
          });
          const [a, b, c, d] = isInside ? around : around.reverse();
          indices.push(a, b, c, a, c, d);
        }
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint32Array.from(indices),
  };
}

/** By Newton's method, and at most half a cell away, so that neighbours keep their order. */
function ontoSurface(field: Field, from: Vec3, size: number): Vec3 {
  let p = from;
  for (let i = 0; i < 4; i++) {
    const gradient = field.gradient(p);
    const square = dot(gradient, gradient);
    if (square === 0) break;
    const step = scale(gradient, -field.value(p) / square);
    p = add(p, scale(step, Math.min(1, size / 4 / Math.max(1e-9, length(step)))));
  }
  return Math.hypot(...p.map((x, k) => x - from[k])) > size / 2 ? from : p;
}

const outward = (gradient: Vec3): Vec3 => (length(gradient) > 0 ? normalize(scale(gradient, -1)) : [0, 1, 0]);
