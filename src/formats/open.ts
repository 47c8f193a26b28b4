import { listed, msg } from '../messages/message.ts';
import { messageOf } from '../messages/messageError.ts';
import { matchesPath } from '../scene/compose/mergeScenes.ts';
import { InputError, type Scene } from '../scene/types.ts';
import { formatBytes, inputError } from './diagnostics/inputError.ts';
import { scenesIn } from './entry.ts';
import { dotted, extensionOf, type FileSource, normalizePath } from './files/fileSource.ts';
import { sanitizeScene } from './read/sanitize.ts';
import type { ReadOptions } from './readOptions.ts';
import { formatOf, panoramaFormat, sceneFormats } from './registry.ts';

/** How a scene is read, and how much of it at most. */
export interface OpenOptions extends ReadOptions {
  /** Maximum total size of a scene's files [bytes]. */
  readonly maxBytes?: number;
}

/** 2 GiB: maximum typed array size on all platforms. */
export const MAX_BYTES = 2 ** 31;

/**
 * Reads a scene. Throws an InputError, and nothing else, where the file is missing, empty, too large, damaged or of a
 * kind that no reader knows.
 * @example
 * const usda = `#usda 1.0
 * def Sphere "Ball" { double radius = 2 }`;
 * const scene = await openScene(memorySource({ 'ball.usda': new TextEncoder().encode(usda) }), 'ball.usda');
 * scene.objects[0].path; // '/Ball'
 */
export async function openScene(files: FileSource, entry: string, options: OpenOptions = {}): Promise<Scene> {
  const path = normalizePath(entry);
  const format = formatOf(path);
  if (!format) throw unknownFormat(path);
  const source = boundedSource(files, options.maxBytes ?? MAX_BYTES);
  const size = (await source.open?.(path))?.size ?? (await source.read(path))?.length;
  if (size === undefined) throw await missingFile(files, path);
  if (size === 0) throw inputError('file.empty', path, msg`the file is empty (0 bytes); export or copy it again`);
  try {
    return withinPrim(sanitizeScene(await format.read(source, path, options)), path, options.prim);
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    const message = msg`cannot be read as ${format.name}: ${messageOf(thrown)}; the file may be damaged, export it again`;
    throw inputError('file.unreadable', path, message, thrown);
  }
}

/** What is at a prim path and below it; of USD nothing else has been read. Throws an InputError if that is nothing. */
function withinPrim(scene: Scene, file: string, prim: string | undefined): Scene {
  if (!prim) return scene;
  const root = `/${prim.split('/').filter(Boolean).join('/')}`;
  const inside = <T extends { readonly path: string }>(items: readonly T[]): readonly T[] =>
    items.filter(({ path }) => matchesPath(path, root));
  const [objects, lights, cameras] = [inside(scene.objects), inside(scene.lights), inside(scene.cameras)];
  if (objects.length + lights.length + cameras.length > 0) return { ...scene, objects, lights, cameras };
  const others = scene.objects.slice(0, 5).map(({ path }) => path);
  throw inputError(
    'prim.missing',
    file,
    others.length > 0
      ? msg`there is nothing at ${prim}; there is ${listed(others)}`
      : msg`there is nothing to be seen at ${prim}, and no light and no camera; choose another path`,
  );
}

function unknownFormat(path: string): InputError {
  if (/\.slowlight\.json$/i.test(path)) {
    const use = msg`render, simulate and graph check take it, and the page opens it at ?project=…`;
    return inputError('file.unknown-format', path, msg`this is a project, not a scene; ${use}`);
  }
  const known = listed([...sceneFormats, panoramaFormat].map((f) => msg`${f.name} (${dotted(f.extensions)})`));
  const extension = extensionOf(path);
  const message = extension
    ? msg`.${extension} is not a scene format that can be opened; ${known} can`
    : msg`the name has no extension; ${known} can be opened`;
  return inputError('file.unknown-format', path, message);
}

async function missingFile(files: FileSource, path: string): Promise<InputError> {
  const known = scenesIn((await files.list?.()) ?? []);
  const message =
    known.length > 0
      ? msg`no such file; there is ${listed(known.slice(0, 5))}`
      : msg`no such file; check its name, and where it is`;
  return inputError('file.missing', path, message);
}

/** Caches reads and limits their total size; files only opened do not count. */
function boundedSource(files: FileSource, maxBytes: number): FileSource {
  const held = new Map<string, Promise<Uint8Array | undefined>>();
  let total = 0;
  const load = async (path: string): Promise<Uint8Array | undefined> => {
    const bytes = await files.read(path);
    count(path, bytes?.length ?? 0);
    return bytes;
  };
  const count = (path: string, size: number): void => {
    total += size;
    if (total > maxBytes) {
      const message = msg`with this file the scene takes ${formatBytes(total)}, more than the ${formatBytes(maxBytes)} that are read; use smaller textures or fewer samples`;
      throw inputError('file.too-large', path, message);
    }
  };
  const read = (path: string): Promise<Uint8Array | undefined> => {
    const key = normalizePath(path);
    const bytes = held.get(key) ?? load(key);
    held.set(key, bytes);
    return bytes;
  };
  return {
    read,
    ...(files.open && { open: (path: string) => files.open!(normalizePath(path)) }),
    ...(files.list && { list: () => files.list!() }),
  };
}
