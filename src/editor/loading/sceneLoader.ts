import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import type { AbortSignalLike, ProgressCallback } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { LoadedScene, ReadRequest, SceneReadOptions, Services } from '../../nodes/services.ts';
import { InputError } from '../../scene/types.ts';
import { workerError } from '../pipelines/workerError.ts';
import { localSource, splitAddress, urlSource } from './fileSources.ts';
import { type LocalFiles, sceneName } from './localFiles.ts';
import type { LoaderReply, LoadRequest, SceneFiles } from './protocol.ts';

/** Reads the scene of a document's `source`: user files of this session, or an address relative to the page. */
export function sceneReader(local: LocalFiles): Services['readScene'] {
  return (source, { signal, progress, ...how }) =>
    readInWorker({ ...filesOf(local, source), how }, { ...(signal && { signal }), progress });
}

const filesOf = (local: LocalFiles, source: string): SceneFiles => local.get(source) ?? filesAtAddress(source);

/** Reads a small file of a document: a user file of this session, or an address relative to the page. */
export function fileReader(local: LocalFiles): Services['readFile'] {
  return async (source) => {
    const { files, base, entry } = filesOf(local, source);
    const others = base === undefined ? undefined : urlSource(base, () => {});
    const bytes = await localSource(new Map(files), () => {}, others).read(entry);
    if (bytes) return bytes;
    const message = msg`there is no such file; put it beside the project, or open it`;
    throw new InputError({ severity: 'error', code: 'file.missing', place: sceneName(source), message });
  };
}

function filesAtAddress(source: string): SceneFiles {
  if (source.startsWith('local:')) {
    const message = msg`the file was opened in an earlier session; open it again`;
    throw new InputError({ severity: 'error', code: 'file.forgotten', place: sceneName(source), message });
  }
  return { files: [], ...splitAddress(new URL(source, document.baseURI)) };
}

/** One worker per scene; it is terminated to cancel. */
async function readInWorker(
  request: LoadRequest,
  { signal, progress }: Pick<ReadRequest, 'signal' | 'progress'>,
): Promise<LoadedScene> {
  progress(undefined, 'fetch');
  const reply = await askWorker(request, progress, signal);
  if (reply.kind === 'done') return reply.loaded;
  throw new MessageError(msg`the reader did not give the scene`);
}

/** Files on a server that reading a scene requests, by path relative to its folder. */
export async function collectServerFiles(
  local: LocalFiles,
  source: string,
  how: SceneReadOptions,
): Promise<ReadonlyMap<string, Uint8Array>> {
  const reply = await askWorker({ ...filesOf(local, source), how, collect: true }, () => {});
  if (reply.kind !== 'collected') throw new MessageError(msg`the reader did not give the files`);
  return reply.files;
}

type LoaderAnswer = Extract<LoaderReply, { readonly kind: 'done' | 'collected' }>;

function askWorker(request: LoadRequest, progress: ProgressCallback, signal?: AbortSignalLike): Promise<LoaderAnswer> {
  const worker = new Worker(new URL('./loader.worker.ts', import.meta.url), { type: 'module' });
  const reading = new Promise<LoaderAnswer>((resolve, reject) => {
    signal?.addEventListener('abort', () => reject(new CancelledError()));
    worker.addEventListener('error', (event) =>
      reject(workerError(event.message, msg`the reader could not be started`)),
    );
    worker.addEventListener('message', ({ data }: MessageEvent<LoaderReply>) => {
      if (data.kind === 'progress') progress(data.part, data.stage);
      else if (data.kind === 'failed')
        reject(data.diagnostic ? new InputError(data.diagnostic) : new MessageError(data.message));
      else resolve(data);
    });
    worker.postMessage(request);
  });
  return reading.finally(() => worker.terminate());
}
