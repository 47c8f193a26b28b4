import { open, readdir, readFile } from 'node:fs/promises';
import { basename, dirname, isAbsolute, join, resolve } from 'node:path';
import { inputError } from '../../formats/diagnostics/inputError.ts';
import { entryOf } from '../../formats/entry.ts';
import type { FileSource } from '../../formats/files/fileSource.ts';
import { openScene } from '../../formats/open.ts';
import type { ReadOptions } from '../../formats/readOptions.ts';
import type { RandomAccessFile } from '../../formats/zip/directory.ts';
import { splitArchive, zipSource } from '../../formats/zip/zipSource.ts';
import { msg } from '../../messages/message.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { InputError, type Scene } from '../../scene/types.ts';
import { decodePicture } from './decodePicture.ts';
import { openDiskFile, readDiskFile } from './diskFiles.ts';
import { openFfmpegFrames } from './ffmpegFrames.ts';

/** The files of a folder on disk. `..` and absolute paths are allowed: the user may read those files anyway. */
export function folderSource(folder: string): FileSource {
  setFileReader(readDiskFile);
  const onDisk = (path: string): string => (isAbsolute(path) ? path : join(folder, path));
  return {
    open: async (path) => openDiskFile(onDisk(path), path),
    read: async (path) => {
      try {
        return new Uint8Array(await readFile(onDisk(path)));
      } catch (error) {
        if (isAbsent(error)) return undefined;
        throw error;
      }
    },
    list: async () => {
      try {
        const entries = await readdir(folder, { withFileTypes: true });
        return entries.filter((entry) => entry.isFile()).map(({ name }) => name);
      } catch (error) {
        if (isAbsent(error)) return [];
        throw error;
      }
    },
  };
}

const isAbsent = (error: unknown): boolean =>
  ['ENOENT', 'ENOTDIR'].includes((error as NodeJS.ErrnoException).code ?? '');

/** A scene's file and the source of the files that it may refer to. */
export interface SceneLocation {
  readonly source: FileSource;
  /** Absolute; paths of `source` are relative to it. */
  readonly folder: string;
  readonly entry: string;
}

/** Locates `scene.usda`, `set.zip[scene.usda]` or the first scene of `set.zip` by `entryOf`. */
export async function locateScene(path: string): Promise<SceneLocation> {
  const zip = splitArchive(path);
  const file = resolve(zip?.archive ?? path);
  const [folder, name] = [dirname(file), basename(file)];
  const source = folderSource(folder);
  if (!zip) return { source, folder, entry: name };
  const inside = await zipSource(await partedFile(file), name, source);
  const paths = await inside.list();
  const entry = zip.inner === undefined ? entryOf(paths) : `${name}/${zip.inner}`;
  if (entry === undefined) throw inputError('zip.no-scene', name, msg`none of its ${paths.length} files is a scene`);
  return { source: inside, folder, entry };
}

export async function openSceneFile(path: string, options: ReadOptions = {}): Promise<Scene> {
  const { source, entry } = await locateScene(path);
  return openScene(source, entry, { decodePicture, openFilm: openFfmpegFrames, ...options });
}

/** A file on disk that is opened for each read; archives need few. */
export async function partedFile(path: string): Promise<RandomAccessFile> {
  try {
    const stat = await withFile(path, (file) => file.stat());
    if (!stat.isFile()) throw inputError('file.missing', path, msg`is a folder; name the scene in it`);
    const read = (from: number, to: number) =>
      withFile(path, async (file) => {
        const { buffer, bytesRead } = await file.read(new Uint8Array(to - from), 0, to - from, from);
        return buffer.subarray(0, bytesRead);
      });
    return { size: stat.size, read };
  } catch (error) {
    if (error instanceof InputError) throw error;
    const { code, message } = error as NodeJS.ErrnoException;
    throw inputError(
      'file.missing',
      path,
      code === 'ENOENT' ? msg`no such file` : msg`cannot be read (${message})`,
      error,
    );
  }
}

async function withFile<T>(path: string, use: (file: Awaited<ReturnType<typeof open>>) => Promise<T>): Promise<T> {
  const file = await open(path);
  try {
    return await use(file);
  } finally {
    await file.close();
  }
}
