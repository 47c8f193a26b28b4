import type { DecodedImage } from '../../../image/decodeImage.ts';
import { hasRadiance, looksLikeColor } from '../../../image/imageKind.ts';
import type { DecodedRadiance } from '../../../image/radiance/radianceLimits.ts';
import type { AssetFiles } from '../../assets/assetFiles.ts';

/** A texture, or the tiles of a UDIM set as one. */
export interface LoadedImage extends DecodedImage {
  /** sRGB colour data rather than linear numbers, by its content. */
  readonly looksLikeColor: boolean;
  readonly tiles?: readonly [columns: number, rows: number];
  /** Of a picture of linear light: its pixels without the sRGB curve. */
  readonly numbers?: Uint8Array;
}

/** An asset path, and the layer that it is relative to. */
interface TextureFile {
  readonly asset: string;
  readonly anchor: string;
}

/** The picture in a file, or in those of a UDIM set; undefined if there is none. Throws if it cannot be read. Decoders are loaded when pictures are met. */
export async function readImage(files: AssetFiles, { asset, anchor }: TextureFile): Promise<LoadedImage | undefined> {
  if (asset.includes('<UDIM>')) {
    const { atlasOf, readTiles } = await import('./udim.ts');
    const tiles = await readTiles((tile) => files.findBytes(anchor, asset.replaceAll('<UDIM>', tile)));
    return tiles.length > 0 ? { ...atlasOf(tiles), looksLikeColor: looksLikeColor(tiles[0].bytes) } : undefined;
  }
  const found = await files.findBytes(anchor, asset);
  if (!found) return undefined;
  if (hasRadiance(found.bytes)) {
    const { decodeFloatPicture } = await import('../../../image/radiance/floatPicture.ts');
    return { ...decodeFloatPicture(found.bytes, found.id)!, looksLikeColor: true };
  }
  const { decodeImage } = await import('../../../image/decodeImage.ts');
  return { ...decodeImage(found.bytes, found.id), looksLikeColor: looksLikeColor(found.bytes) };
}

/** The same for pictures of radiance; undefined if the file is of another format. */
export async function readRadiance(
  files: AssetFiles,
  { asset, anchor }: TextureFile,
): Promise<DecodedRadiance | undefined> {
  const found = await files.findBytes(anchor, asset);
  if (!found || !hasRadiance(found.bytes)) return undefined;
  const { decodeRadiance } = await import('../../../image/radiance/radiance.ts');
  return decodeRadiance(found.bytes, found.id);
}
