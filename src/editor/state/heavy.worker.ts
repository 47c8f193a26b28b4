import { serveHeavy } from '../../graph/evaluation/heavyWorkers.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { workerServices } from '../../nodes/services.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readBlob } from '../loading/readBlob.ts';

setFileReader(readBlob);

/** Evaluates heavy nodes off the main thread. */
serveHeavy(nodeLibrary, workerServices, {
  listen: (hear) => addEventListener('message', ({ data }) => hear(data)),
  reply: (reply, transfer) => postMessage(reply, { transfer }),
});
