import { parentPort } from 'node:worker_threads';
import { serveTracer } from '../../reference/tracerServer.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readDiskFile } from '../files/diskFiles.ts';

/** A thread of the reference renderer; tracerPool.ts starts it and gives it work. */
if (!parentPort) throw new Error('tracerWorker is a worker thread of tracerPool');
const port = parentPort;
setFileReader(readDiskFile);
serveTracer({
  listen: (hear) => void port.on('message', hear),
  post: (reply, transfer) => port.postMessage(reply, transfer as readonly ArrayBuffer[]),
});
