import { inputError } from '../../formats/diagnostics/inputError.ts';
import { entryOf } from '../../formats/entry.ts';
import { type FileSource, normalizePath } from '../../formats/files/fileSource.ts';
import type { OpenFilmFrames } from '../../formats/film/filmFrames.ts';
import { openScene } from '../../formats/open.ts';
import { memoryFile, splitArchive, zipSource } from '../../formats/zip/zipSource.ts';
import { transferables } from '../../graph/evaluation/transferables.ts';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import type { LoadedScene } from '../../nodes/services.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { InputError } from '../../scene/types.ts';
import { decodePicture } from './browserPictures.ts';
import { localSource, urlSource } from './fileSources.ts';
import { loadedScene } from './loadedScene.ts';
import type { LoaderReply, LoadRequest } from './protocol.ts';
import { readBlob } from './readBlob.ts';

setFileReader(readBlob);

/** Reads one scene off the main thread; its arrays are transferred, not copied. */
addEventListener('message', async ({ data }: MessageEvent<LoadRequest>) => {
  try {
    const files = new Map<string, Uint8Array>();
    const loaded = await load(data, data.collect && files);
    if (data.collect) reply({ kind: 'collected', files });
    else reply({ kind: 'done', loaded }, transferables(loaded));
  } catch (error) {
    reply({
      kind: 'failed',
      message: messageOf(error),
      diagnostic: error instanceof InputError ? error.diagnostic : undefined,
    });
  }
});

/** Decodes films by code that is loaded with the first one. */
const openFilm: OpenFilmFrames = (track) => {
  const opened = import('../films/webFrames.ts').then(({ openWebFrames }) => openWebFrames(track));
  return {
    frame: async (index) => (await opened).frame(index),
    close: () => void opened.then((frames) => frames.close()).catch(() => {}),
  };
};

/** Progress of validating a long cache, which reads all samples. */
const progress = (part: number): void => reply({ kind: 'progress', stage: 'parse', part });

async function load(request: LoadRequest, files?: Map<string, Uint8Array>): Promise<LoadedScene> {
  const { source, entry } = await sceneIn(sourceOf(request, files), request.entry);
  return loadedScene(await openScene(source, entry, { ...request.how, progress, decodePicture, openFilm }));
}

/** The read fraction of a file is known; that of parsing is not. */
const report = (received: number, total: number): void =>
  received < total
    ? reply({ kind: 'progress', stage: 'fetch', part: received / total })
    : reply({ kind: 'progress', stage: 'parse', part: undefined });

function sourceOf({ files, base }: LoadRequest, asked?: Map<string, Uint8Array>): FileSource {
  const server = base === undefined ? undefined : urlSource(base, report);
  return localSource(new Map(files), report, server && asked ? collecting(server, asked) : server);
}

/** Records the files that are read. */
const collecting = ({ read }: FileSource, files: Map<string, Uint8Array>): FileSource => ({
  read: async (path) => {
    const bytes = await read(path);
    // Readers may transfer the buffers they get.
    if (bytes) files.set(normalizePath(path), bytes.slice());
    return bytes;
  },
});

/** The scene itself, or the best one of an archive. */
async function sceneIn(source: FileSource, path: string): Promise<{ source: FileSource; entry: string }> {
  const zip = splitArchive(path);
  const bytes = zip && (await source.read(zip.archive));
  if (!zip || !bytes) return { source, entry: path };
  const inside = await zipSource(memoryFile(bytes), zip.archive, source);
  const entry = zip.inner === undefined ? entryOf(await inside.list()) : `${zip.archive}/${zip.inner}`;
  if (entry === undefined) throw inputError('zip.no-scene', zip.archive, msg`none of its files is a scene`);
  return { source: inside, entry };
}

const reply = (message: LoaderReply, transfer: ArrayBuffer[] = []): void => postMessage(message, { transfer });
