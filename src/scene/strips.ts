/** Three vertices of a triangle, or three weights. */
export type Corners = readonly [number, number, number];

/** Who knows the vertices of a mesh that is being cut. */
export interface Seams {
  /** The k-th of n + 1 points from vertex a (k = 0) to vertex b (k = n). */
  onEdge(a: number, b: number, k: number, n: number): number;
  /** A new vertex inside the triangle, by the weights of its corners. */
  inside(weights: Corners): number;
  squaredDistance(a: number, b: number): number;
  emit(a: number, b: number, c: number): void;
}

/**
 * A triangle seen from the corner across the edge with the fewest pieces: rows run from that apex to this base, each a little
 * wider than the one before, so that a sliver becomes one strip.
 */
interface Fan {
  /** Place of the base edge's first corner. */
  readonly base: number;
  readonly left: number;
  readonly right: number;
  readonly width: number;
  readonly rows: number;
}

/** `pieces`: of the edges from each corner to the next. */
function fanOf(pieces: readonly number[]): Fan {
  const base = pieces.indexOf(Math.min(...pieces));
  const [left, right] = [pieces[(base + 2) % 3], pieces[(base + 1) % 3]];
  return { base, left, right, width: pieces[base], rows: Math.max(left, right) };
}

const piecesInRow = ({ width, rows }: Fan, row: number): number => Math.ceil((width * row) / rows);

/** How many triangles `cutTriangle` makes, or a few more. */
export function countPieces(pieces: readonly number[]): number {
  const fan = fanOf(pieces);
  // One piece wide all the way down: two triangles a row, but for the apex.
  if (fan.width === 1) return 2 * fan.rows - 1;
  let count = 0;
  for (let row = 1; row <= fan.rows; row++) count += piecesInRow(fan, row - 1) + piecesInRow(fan, row);
  return count;
}

/** Cuts a triangle whose edges have so many `pieces` (from each corner to the next); the winding stays. */
export function cutTriangle(corners: Corners, pieces: readonly number[], seams: Seams): void {
  if (Math.max(...pieces) === 1) {
    seams.emit(...corners);
    return;
  }
  const fan = fanOf(pieces);
  let above = rowOf(corners, fan, 0, seams);
  for (let row = 1; row <= fan.rows; row++) {
    const below = rowOf(corners, fan, row, seams);
    zip(above, below, seams);
    above = below;
  }
}

/** The vertices of a row from the left edge to the right one. */
function rowOf(corners: Corners, fan: Fan, row: number, seams: Seams): number[] {
  const { base, left, right, width, rows } = fan;
  const [apex, first, last] = [corners[(base + 2) % 3], corners[base], corners[(base + 1) % 3]];
  if (row === 0) return [apex];
  if (row === rows) return Array.from({ length: width + 1 }, (_, k) => seams.onEdge(first, last, k, width));
  const [l, r] = [Math.round((row * left) / rows), Math.round((row * right) / rows)];
  const out = [seams.onEdge(apex, first, l, left)];
  const count = piecesInRow(fan, row);
  for (let k = 1; k < count; k++) {
    const s = k / count;
    const weights: [number, number, number] = [0, 0, 0];
    weights[base] = ((1 - s) * l) / left;
    weights[(base + 1) % 3] = (s * r) / right;
    weights[(base + 2) % 3] = 1 - weights[base] - weights[(base + 1) % 3];
    out.push(seams.inside(weights));
  }
  out.push(seams.onEdge(apex, last, r, right));
  return out;
}

/** Triangles between two rows, along the shorter diagonals. */
function zip(above: readonly number[], below: readonly number[], seams: Seams): void {
  let [i, j] = [0, 0];
  while (i + 1 < above.length || j + 1 < below.length) {
    const down = j + 1 < below.length ? seams.squaredDistance(above[i], below[j + 1]) : Infinity;
    const across = i + 1 < above.length ? seams.squaredDistance(below[j], above[i + 1]) : Infinity;
    const next = down <= across ? below[j + 1] : above[i + 1];
    // Where an edge has fewer pieces than there are rows, two rows end in the same vertex.
    if (above[i] !== below[j] && above[i] !== next && below[j] !== next) seams.emit(above[i], below[j], next);
    if (down <= across) j++;
    else i++;
  }
}
