import { readdir, readFile } from 'node:fs/promises';
import { basename, dirname, isAbsolute, join, resolve } from 'node:path';
import { openScene } from '../formats/open.ts';
import type { FileSource } from '../formats/source.ts';
import type { Scene } from '../scene/types.ts';

/** The files of a folder on disk; `..` and absolute paths lead where they say, since the person who runs this may read them. */
export function folderSource(folder: string): FileSource {
  return {
    read: async (path) => {
      try {
        return new Uint8Array(await readFile(isAbsolute(path) ? path : join(folder, path)));
      } catch (error) {
        const code = (error as NodeJS.ErrnoException).code;
        if (code === 'ENOENT' || code === 'ENOTDIR') return undefined;
        throw error;
      }
    },
    list: async () => (await readdir(folder, { withFileTypes: true })).filter((e) => e.isFile()).map((e) => e.name),
  };
}

export function openSceneFile(path: string): Promise<Scene> {
  const file = resolve(path);
  return openScene(folderSource(dirname(file)), basename(file));
}
