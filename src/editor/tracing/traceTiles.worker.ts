import { serveTracer } from '../../reference/tracerServer.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readBlob } from '../loading/readBlob.ts';

setFileReader(readBlob);

/** A thread of the reference renderer; tracePicture.worker.ts starts it and gives it work. */
serveTracer({
  listen: (hear) => addEventListener('message', ({ data }) => hear(data)),
  post: (reply, transfer) => postMessage(reply, { transfer: [...transfer] as ArrayBuffer[] }),
});
