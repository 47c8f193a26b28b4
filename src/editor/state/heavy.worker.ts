import { serveHeavy } from '../../graph/heavy.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { threadServices } from '../../nodes/services.ts';
import { readFilesWith } from '../../scene/storedNumbers.ts';
import { readBlob } from '../loading/blobs.ts';

readFilesWith(readBlob);

/** Evaluates heavy nodes off the main thread. */
serveHeavy(nodeLibrary, threadServices, {
  listen: (hear) => addEventListener('message', ({ data }) => hear(data)),
  reply: (reply, transfer) => postMessage(reply, { transfer }),
});
