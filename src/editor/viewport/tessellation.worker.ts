import { servePlans } from '../../render/tessellation/plan/planServer.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readBlob } from '../loading/readBlob.ts';

/** Plans the tessellation of pictures off the main thread. */
setFileReader(readBlob);
servePlans(self);
