import { serveTracer } from '../../reference/tracerServer.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readBlob } from '../loading/readBlob.ts';

setFileReader(readBlob);

/** A thread of the reference renderer, started by tracePicture.worker.ts. */
serveTracer({
  listen: (hear) => addEventListener('message', ({ data }) => hear(data)),
  post: (reply, transfer) => postMessage(reply, { transfer: [...transfer] as ArrayBuffer[] }),
});
