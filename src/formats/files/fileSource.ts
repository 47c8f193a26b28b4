import { type LocalizedText, listed } from '../../messages/message.ts';
import { RangedFile } from './rangedFile.ts';

/**
 * Where a scene's files come from: a folder on disk, files dropped on the page, a web server, memory. Paths use '/' and
 * are relative to the folder of the source; `..` may lead out of it, where the source allows that.
 */
export interface FileSource {
  /** The file's bytes, or undefined where there is no such file. */
  read(path: string): Promise<Uint8Array | undefined>;
  /** The file for random access, valid as long as the scene; absent where not supported. */
  open?(path: string): Promise<RangedFile | undefined>;
  /** All files, where the source can list them; for messages and suggestions. */
  list?(): Promise<string[]>;
}

/**
 * Files held in memory, by path.
 * @example
 * const files = memorySource({ 'set/cube.obj': new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n') });
 * const scene = await openScene(files, 'set/cube.obj');
 * scene.objects[0].mesh.indices.length; // 3
 */
export function memorySource(files: Readonly<Record<string, Uint8Array>>): FileSource {
  const byPath = new Map(Object.entries(files).map(([path, bytes]) => [normalizePath(path), bytes]));
  return {
    read: async (path) => byPath.get(normalizePath(path)),
    open: async (path) => {
      const handle = byPath.get(normalizePath(path));
      return handle && new RangedFile({ name: path, handle }, handle.length);
    },
    list: async () => [...byPath.keys()],
  };
}

/** `./a//b/../c` → `a/c`. A leading `..` stays, and so does a leading `/`. */
export function normalizePath(path: string): string {
  const parts: string[] = [];
  for (const part of path.replaceAll('\\', '/').split('/')) {
    if (part === '' || part === '.') continue;
    if (part === '..' && parts.length > 0 && parts.at(-1) !== '..') parts.pop();
    else parts.push(part);
  }
  return (path.startsWith('/') ? '/' : '') + parts.join('/');
}

/** The path of what `file` refers to as `reference`: relative to the folder of `file`, unless it is absolute. */
export function resolvePath(file: string, reference: string): string {
  if (reference.startsWith('/')) return normalizePath(reference);
  return normalizePath(`${file.slice(0, file.lastIndexOf('/') + 1)}${reference}`);
}

/** `a/b/Scene.GLB` → `glb`; empty where the name has no extension. */
export function extensionOf(path: string): string {
  const name = path.slice(path.lastIndexOf('/') + 1);
  const dot = name.lastIndexOf('.');
  return dot > 0 ? name.slice(dot + 1).toLowerCase() : '';
}

/** `usda`, `usdz` → `.usda, .usdz`. */
export const dotted = (extensions: readonly string[]): LocalizedText => listed(extensions.map((each) => `.${each}`));

/** `a/b/Scene.v2.glb` → `Scene.v2`. */
export const stemOf = (path: string): string => path.replace(/^.*\//, '').replace(/(?<=.)\.[^.]*$/, '');
