import { serveSamples } from '../../render/geometry/pointSamples/sampleServer.ts';
import { setFileReader } from '../../scene/streaming/storedNumbers.ts';
import { setSampleCacheSize } from '../../scene/streaming/streamedPoints.ts';
import { readBlob } from '../loading/readBlob.ts';

/** Reads samples that are left in files, off the main thread. */
setFileReader(readBlob);
// Each sample is requested once.
setSampleCacheSize(0);
serveSamples(self);
