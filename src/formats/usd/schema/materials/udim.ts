import { type DecodedImage, decodeImage } from '../../../image/decodeImage.ts';

/** A texture of `columns` × `rows` tiles, the first at the lower left; u and v are in tiles. */
export interface UdimAtlas extends DecodedImage {
  readonly tiles: readonly [columns: number, rows: number];
}

/** Tile numbers are 1001 + column + 10 row. */
const COLUMNS = 10;
const MAX_ROWS = 10;
/** Maximum side of the combined texture [px]. */
export const MAX_UDIM_ATLAS_SIDE = 8192;

interface UdimTile {
  readonly column: number;
  readonly row: number;
  readonly path: string;
  readonly bytes: Uint8Array;
}

/** The existing tiles; the search stops at the first empty row. */
export async function readTiles(
  read: (tile: string) => Promise<{ id: string; bytes: Uint8Array } | undefined>,
): Promise<UdimTile[]> {
  const tiles: UdimTile[] = [];
  for (let row = 0; row < MAX_ROWS; row++) {
    const before = tiles.length;
    for (let column = 0; column < COLUMNS; column++) {
      const found = await read(String(1001 + column + COLUMNS * row));
      if (found) tiles.push({ column, row, path: found.id, bytes: found.bytes });
    }
    if (tiles.length === before) break;
  }
  return tiles;
}

/** Combines all tiles into one texture, with a tile size that is a power of two and fits; missing tiles are black. */
export function atlasOf(tiles: readonly UdimTile[]): UdimAtlas {
  const columns = 1 + Math.max(...tiles.map(({ column }) => column));
  const rows = 1 + Math.max(...tiles.map(({ row }) => row));
  const most = Math.floor(MAX_UDIM_ATLAS_SIDE / Math.max(columns, rows));
  let atlas: UdimAtlas | undefined;
  for (const tile of tiles) {
    const image = decodeImage(tile.bytes, tile.path);
    const side = Math.min(most, 2 ** Math.ceil(Math.log2(Math.max(image.width, image.height))));
    if (!atlas || side * columns > atlas.width) atlas = resizedAtlas(atlas, columns, rows, side);
    drawTile(atlas, image, tile);
  }
  return atlas!;
}

function resizedAtlas(old: UdimAtlas | undefined, columns: number, rows: number, side: number): UdimAtlas {
  const [width, height] = [side * columns, side * rows];
  const made: UdimAtlas = { width, height, data: new Uint8Array(4 * width * height), tiles: [columns, rows] };
  if (old) blit(old, made, 0, 0, width, height);
  else for (let i = 3; i < made.data.length; i += 4) made.data[i] = 255;
  return made;
}

function drawTile(atlas: UdimAtlas, image: DecodedImage, { column, row }: UdimTile): void {
  const [columns, rows] = atlas.tiles;
  const [width, height] = [atlas.width / columns, atlas.height / rows];
  blit(image, atlas, column * width, (rows - 1 - row) * height, width, height);
}

/** Copies an image into a rectangle of another by nearest-neighbour sampling. */
function blit(from: DecodedImage, to: DecodedImage, left: number, top: number, width: number, height: number): void {
  const [source, target] = [new Uint32Array(from.data.slice().buffer), new Uint32Array(to.data.buffer)];
  for (let y = 0; y < height; y++) {
    const row = Math.floor((y * from.height) / height) * from.width;
    for (let x = 0; x < width; x++)
      target[(top + y) * to.width + left + x] = source[row + Math.floor((x * from.width) / width)];
  }
}
