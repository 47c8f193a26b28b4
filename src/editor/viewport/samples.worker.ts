import { serveSamples } from '../../render/geometry/pointSamples/sampleServer.ts';
import { setSampleCacheSize } from '../../scene/streaming/sampleCache.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { readBlob } from '../loading/readBlob.ts';

/** Reads samples that are left in files, off the main thread. */
setFileReader(readBlob);
// Each sample is requested once.
setSampleCacheSize(0);
serveSamples(self);
