import { pipelineNamed } from '../../pipelines/registry.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readBlob } from '../loading/readBlob.ts';

setFileReader(readBlob);

/** Messages that arrive while the pipeline's code is being loaded. */
const early: unknown[] = [];
let hear = (message: unknown): void => void early.push(message);
addEventListener('message', ({ data }) => hear(data));

/** A thread of the pipeline that the worker is named after, started by workerThreads.ts. */
void pipelineNamed(self.name).serveThread?.({
  listen: (listener) => {
    hear = listener as (message: unknown) => void;
    early.splice(0).forEach(hear);
  },
  post: (reply, transfer) => postMessage(reply, { transfer: [...transfer] as ArrayBuffer[] }),
});
