import { parentPort } from 'node:worker_threads';
import { serveHeavy } from '../graph/heavy.ts';
import { nodeLibrary } from '../nodes/library.ts';
import { threadServices } from '../nodes/services.ts';
import { readFilesWith } from '../scene/storedNumbers.ts';
import { readDiskFile } from './diskFiles.ts';

/** A thread that evaluates heavy nodes; heavyNodes.ts starts it and gives it work. */
if (!parentPort) throw new Error('heavyNodeWorker is a worker thread of heavyNodes');
const port = parentPort;
readFilesWith(readDiskFile);
serveHeavy(nodeLibrary, threadServices, {
  listen: (hear) => void port.on('message', hear),
  reply: (reply, transfer) => port.postMessage(reply, transfer),
});
