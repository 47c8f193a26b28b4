import { servePlans } from '../../render/refine/planServer.ts';
import { readFilesWith } from '../../scene/storedNumbers.ts';
import { readBlob } from '../loading/blobs.ts';

/** Plans pictures off the main thread. */
readFilesWith(readBlob);
servePlans(self);
