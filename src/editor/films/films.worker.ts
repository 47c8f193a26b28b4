import { transferables } from '../../graph/evaluation/transferables.ts';
import { messageOf } from '../../messages/messageError.ts';
import type { FilmReader, SeenDome } from '../../pipelines/films/filmReader.ts';
import { makeFilmReader } from '../../pipelines/films/makeFilmReader.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readBlob } from '../loading/readBlob.ts';
import type { FilmMessage, FilmReply } from './protocol.ts';
import { openWebFrames } from './webFrames.ts';

setFileReader(readBlob);

let reader: FilmReader | undefined;
let sent: SeenDome | undefined;

/** Makes what events see of one film; for openFilmInWorker.ts. */
addEventListener('message', async ({ data }: MessageEvent<FilmMessage>) => {
  try {
    if (data.kind === 'open') reader = makeFilmReader(data.dome, data.means, openWebFrames);
    else await answer(data);
  } catch (error) {
    reply({ kind: 'failed', message: messageOf(error) });
  }
});

async function answer({ event }: Extract<FilmMessage, { readonly kind: 'seen' }>): Promise<void> {
  if (!reader) throw new Error('the film is not open');
  const seen = await reader.seenAt(event);
  if (seen === sent) reply({ kind: 'same' });
  else reply({ kind: 'seen', seen }, transferables(seen));
  sent = seen;
}

const reply = (message: FilmReply, transfer: ArrayBuffer[] = []): void => postMessage(message, { transfer });
