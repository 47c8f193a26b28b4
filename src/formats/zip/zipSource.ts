import { type FileSource, normalizePath } from '../files/fileSource.ts';
import { nearestPath } from '../files/nearestPath.ts';
import { type RandomAccessFile, readZipDirectory } from './directory.ts';
import { unpack } from './unpack.ts';

/**
 * In-memory bytes as a random access file.
 * @example
 * memoryFile(new Uint8Array([1, 2, 3])).size; // 3 bytes
 */
export const memoryFile = (bytes: Uint8Array): RandomAccessFile => ({
  size: bytes.length,
  read: async (from, to) => bytes.subarray(from, to),
});

/**
 * Mounts an archive as a folder of its own name: `set.zip/scene.usda`. Paths outside it are resolved in `around`;
 * broken paths inside by file name.
 * @example
 * // With a zip of a scene and its textures; `zip` has its bytes.
 * async function open(zip: Uint8Array) {
 *   const source = await zipSource(memoryFile(zip), 'set.zip', memorySource({}));
 *   return openScene(source, entryOf((await source.list?.()) ?? [])!);
 * }
 */
export async function zipSource(
  archive: RandomAccessFile,
  name: string,
  around: FileSource,
): Promise<Required<Pick<FileSource, 'read' | 'list'>>> {
  const folder = `${normalizePath(name)}/`;
  const entries = new Map((await readZipDirectory(archive, name)).map((entry) => [folder + entry.path, entry]));
  return {
    read: async (path) => {
      const wanted = normalizePath(path);
      const exact = entries.get(wanted);
      if (exact) return unpack(archive, exact, name);
      const beside = wanted.startsWith(folder) ? undefined : await around.read(path);
      const near = beside ? undefined : nearestPath(entries.keys(), wanted);
      return near === undefined ? beside : unpack(archive, entries.get(near)!, name);
    },
    list: async () => [...entries.keys()],
  };
}

/** `set.zip[a/scene.usda]` → `set.zip` and `a/scene.usda`; undefined if not a zip. */
export function splitArchive(path: string): { readonly archive: string; readonly inner?: string } | undefined {
  const [, archive, inner] = /^(.*\.zip)(?:\[(.+)\])?$/is.exec(path) ?? [];
  if (archive === undefined) return undefined;
  return inner === undefined ? { archive } : { archive, inner };
}
