import { parentPort } from 'node:worker_threads';
import { serveHeavy } from '../../graph/evaluation/heavyWorkers.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { workerServices } from '../../nodes/services.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readDiskFile } from '../files/diskFiles.ts';
import { teamThreads } from '../simulate/teamThreads.ts';

/** Entry of a worker thread that evaluates heavy nodes; heavyNodes.ts starts it. */
if (!parentPort) throw new Error('heavyNodeWorker is a worker thread of heavyNodes');
const port = parentPort;
setFileReader(readDiskFile);
serveHeavy(
  nodeLibrary,
  { ...workerServices, teamThreads },
  {
    listen: (hear) => void port.on('message', hear),
    reply: (reply, transfer) => port.postMessage(reply, transfer),
  },
);
