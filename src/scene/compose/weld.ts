/** Groups of vertices at the same point. */
export interface WeldedVertices {
  /** By vertex: its point. */
  readonly pointOfVertex: Uint32Array;
  /** The first vertex of each point. */
  readonly vertexOfPoint: Uint32Array;
}

/** Merges vertices at the same position, or within a distance along each axis [m], because meshes split vertices where normals and uvs differ. */
export function weld(positions: Float32Array, within = 0): WeldedVertices {
  const cells = new Map<string, number[]>();
  const vertexOfPoint: number[] = [];
  const pointOfVertex = new Uint32Array(positions.length / 3);
  const isNear = (point: number, v: number): boolean =>
    [0, 1, 2].every((k) => Math.abs(positions[3 * vertexOfPoint[point] + k] - positions[3 * v + k]) <= within);
  for (let v = 0; v < pointOfVertex.length; v++) {
    const [x, y, z] = [0, 1, 2].map((k) => sidesOf(positions[3 * v + k], within));
    const around = new Set(x.flatMap((i) => y.flatMap((j) => z.map((k) => `${i} ${j} ${k}`))));
    const existing = [...around].flatMap((cell) => cells.get(cell) ?? []).find((point) => isNear(point, v));
    pointOfVertex[v] = existing ?? vertexOfPoint.length;
    if (existing !== undefined) continue;
    const cell = [0, 1, 2].map((k) => cellOf(positions[3 * v + k], within)).join(' ');
    cells.set(cell, [...(cells.get(cell) ?? []), vertexOfPoint.length]);
    vertexOfPoint.push(v);
  }
  return { pointOfVertex, vertexOfPoint: Uint32Array.from(vertexOfPoint) };
}

/** Cells are wide compared with `within`, so that few vertices are near several of them. */
const cellOf = (x: number, within: number): number => (within === 0 ? x : Math.floor(x / (8 * within)));

const sidesOf = (x: number, within: number): readonly number[] => [
  ...new Set([cellOf(x - within, within), cellOf(x + within, within)]),
];
