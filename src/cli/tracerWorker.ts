import { parentPort } from 'node:worker_threads';
import { serve } from '../reference/serve.ts';
import { readFilesWith } from '../scene/storedNumbers.ts';
import { readDiskFile } from './diskFiles.ts';

/** A thread of the reference renderer; tracerPool.ts starts it and gives it work. */
if (!parentPort) throw new Error('tracerWorker is a worker thread of tracerPool');
const port = parentPort;
readFilesWith(readDiskFile);
serve({
  listen: (hear) => void port.on('message', hear),
  answer: (reply, transfer) => port.postMessage(reply, transfer as readonly ArrayBuffer[]),
});
