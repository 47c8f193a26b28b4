import { parentPort, workerData } from 'node:worker_threads';
import { pipelineNamed } from '../../pipelines/registry.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readDiskFile } from '../files/diskFiles.ts';

/** Entry of a pipeline's worker thread; nodeThreads.ts starts it with the pipeline's id. */
if (!parentPort) throw new Error('threadWorker is a worker thread of nodeThreads');
const port = parentPort;
setFileReader(readDiskFile);
await pipelineNamed(workerData).serveThread?.({
  listen: (hear) => void port.on('message', hear),
  post: (reply, transfer) => port.postMessage(reply, transfer as readonly ArrayBuffer[]),
});
