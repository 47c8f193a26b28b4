import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { OpenFilmReader, SeenDome } from '../../pipelines/films/filmReader.ts';
import { workerError } from '../pipelines/workerError.ts';
import type { FilmMessage, FilmReply } from './protocol.ts';

/** Reads a film in a worker of its own. */
export const openFilmInWorker: OpenFilmReader = (dome, means) => {
  const worker = new Worker(new URL('./films.worker.ts', import.meta.url), { type: 'module' });
  const post = (message: FilmMessage): void => worker.postMessage(message);
  let last: SeenDome | undefined;
  let pending: { resolve(seen: SeenDome): void; reject(error: Error): void } | undefined;
  worker.addEventListener('error', ({ message }) => pending?.reject(workerError(message)));
  worker.addEventListener('message', ({ data }: MessageEvent<FilmReply>) => {
    if (data.kind === 'failed') pending?.reject(new MessageError(data.message));
    else {
      if (data.kind === 'seen') last = data.seen;
      if (last) pending?.resolve(last);
    }
  });
  post({ kind: 'open', dome, means });
  return {
    seenAt: (event) =>
      new Promise((resolve, reject) => {
        pending = { resolve, reject };
        post({ kind: 'seen', event });
      }),
    close: () => {
      worker.terminate();
      pending?.reject(new CancelledError());
    },
  };
};
