/** Vertices that are one point. */
export interface WeldedVertices {
  /** Of each vertex. */
  readonly pointOfVertex: Uint32Array;
  /** The first vertex of each point. */
  readonly vertexOfPoint: Uint32Array;
}

/** Vertices at one place are one point, or within so much of it along each axis [m]: meshes are split where normals and uvs differ. */
export function weld(positions: Float32Array, within = 0): WeldedVertices {
  const cells = new Map<string, number[]>();
  const vertexOfPoint: number[] = [];
  const pointOfVertex = new Uint32Array(positions.length / 3);
  const isNear = (point: number, v: number): boolean =>
    [0, 1, 2].every((k) => Math.abs(positions[3 * vertexOfPoint[point] + k] - positions[3 * v + k]) <= within);
  for (let v = 0; v < pointOfVertex.length; v++) {
    const [x, y, z] = [0, 1, 2].map((k) => sidesOf(positions[3 * v + k], within));
    const around = new Set(x.flatMap((i) => y.flatMap((j) => z.map((k) => `${i} ${j} ${k}`))));
    const known = [...around].flatMap((cell) => cells.get(cell) ?? []).find((point) => isNear(point, v));
    pointOfVertex[v] = known ?? vertexOfPoint.length;
    if (known !== undefined) continue;
    const own = [0, 1, 2].map((k) => cellOf(positions[3 * v + k], within)).join(' ');
    cells.set(own, [...(cells.get(own) ?? []), vertexOfPoint.length]);
    vertexOfPoint.push(v);
  }
  return { pointOfVertex, vertexOfPoint: Uint32Array.from(vertexOfPoint) };
}

/** Cells are wide against what is near, so that hardly a vertex is near to two. */
const cellOf = (x: number, within: number): number => (within === 0 ? x : Math.floor(x / (8 * within)));

const sidesOf = (x: number, within: number): readonly number[] => [
  ...new Set([cellOf(x - within, within), cellOf(x + within, within)]),
];
