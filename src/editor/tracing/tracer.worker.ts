import { serve } from '../../reference/serve.ts';
import { readFilesWith } from '../../scene/storedNumbers.ts';
import { readBlob } from '../loading/blobs.ts';

readFilesWith(readBlob);

/** A thread of the reference renderer; trace.worker.ts starts it and gives it work. */
serve({
  listen: (hear) => addEventListener('message', ({ data }) => hear(data)),
  answer: (reply, transfer) => postMessage(reply, { transfer: [...transfer] as ArrayBuffer[] }),
});
