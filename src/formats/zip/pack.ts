import { type Zippable, zipSync } from 'fflate';

/** Earliest date of the zip format, for reproducible output. */
const NO_DATE = new Date(1980, 0, 1);
/** Already compressed formats, which are stored. */
const PACKED = /\.(zip|usdz|png|jpe?g|webp|ktx2|mp4|glb)$/i;

/** A zip of some files, in the order given. */
export function packZip(files: ReadonlyMap<string, Uint8Array>): Uint8Array {
  const entries: Zippable = Object.create(null);
  for (const [path, bytes] of files) entries[path] = [bytes, { level: PACKED.test(path) ? 0 : 6, mtime: NO_DATE }];
  return zipSync(entries);
}
