import type { RadianceTexture, Texture } from '../../scene/types.ts';

/** A picture of linear light in halves, or of sRGB in bytes: RGBA, rows from the top. */
export type PanoramaPicture = Pick<Texture | RadianceTexture, 'width' | 'height' | 'data' | 'colorSpace'>;

/**
 * A face of a cube as it is seen from inside, upright: a square part of a picture [px]. `turned`: by half a turn, as the last one of a cross that is higher
 * than wide.
 */
export interface FacePicture {
  readonly picture: PanoramaPicture;
  readonly left: number;
  readonly top: number;
  readonly size: number;
  readonly turned: boolean;
}

/** Right, left, up, down, ahead, behind: +x, −x, +y, −y, +z, −z of a left-handed cube, as in OpenGL (4.6, table 8.19). */
export type CubeFaces = readonly [FacePicture, FacePicture, FacePicture, FacePicture, FacePicture, FacePicture];

/** Column and row of each face in a picture of so many columns and rows of cells. */
interface FaceLayout {
  readonly columns: number;
  readonly rows: number;
  readonly cells: readonly (readonly [column: number, row: number])[];
  readonly lastTurned?: true;
}

const inRows = (columns: number): FaceLayout['cells'] =>
  Array.from({ length: 6 }, (_, i) => [i % columns, Math.floor(i / columns)] as const);

/** All faces of a cross but the back. */
const CROSS: FaceLayout['cells'] = [
  [2, 1],
  [0, 1],
  [1, 0],
  [1, 2],
  [1, 1],
];

/** Strips and grids have the faces in their order; a cross is an unfolded cube, with its sides in the second row, or its middle in the second column. */
const LAYOUTS: readonly FaceLayout[] = [
  { columns: 6, rows: 1, cells: inRows(6) },
  { columns: 1, rows: 6, cells: inRows(1) },
  { columns: 3, rows: 2, cells: inRows(3) },
  {
    columns: 4,
    rows: 3,
    cells: [...CROSS, [3, 1]],
  },
  {
    columns: 3,
    rows: 4,
    cells: [...CROSS, [1, 3]],
    lastTurned: true,
  },
];

/** The faces in a picture of six, by its aspect ratio; undefined if it is none. A cross has nothing in its corners, by which it is told from a photograph. */
export function facesIn(picture: PanoramaPicture): CubeFaces | undefined {
  const { width, height } = picture;
  const layout = LAYOUTS.find(
    ({ columns, rows }) => width * rows === height * columns && Number.isInteger(width / columns),
  );
  if (!layout) return undefined;
  const { columns, rows, cells, lastTurned = false } = layout;
  const size = width / columns;
  const isUsed = (column: number, row: number): boolean => cells.some(([c, r]) => c === column && r === row);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++)
      if (!isUsed(column, row) && !isBlank(picture, column * size, row * size, size)) return undefined;
  return cells.map(([column, row], i) => ({
    ...{ picture, left: column * size, top: row * size, size },
    turned: lastTurned && i === 5,
  })) as unknown as CubeFaces;
}

/** By how much an empty cell may vary, of 8 bits: what JPEG leaves. */
const BLANK_RANGE = 12;

/** Whether a square is of one colour; its outermost texels, where JPEG blurs the neighbours in, do not count. */
function isBlank({ data, width }: PanoramaPicture, left: number, top: number, size: number): boolean {
  const rim = Math.min(8, Math.floor(size / 4));
  const first = 4 * ((top + rim) * width + left + rim);
  const range = data instanceof Uint8Array ? BLANK_RANGE : 0;
  for (let y = top + rim; y < top + size - rim; y++)
    for (let x = left + rim; x < left + size - rim; x++)
      for (let k = 0; k < 3; k++) if (Math.abs(data[4 * (y * width + x) + k] - data[first + k]) > range) return false;
  return true;
}
