import { serveSamples } from '../../render/sampleServer.ts';
import { readFilesWith } from '../../scene/storedNumbers.ts';
import { keepSamplesIn } from '../../scene/streamedPoints.ts';
import { readBlob } from '../loading/blobs.ts';

/** Reads samples that are left in files off the main thread. */
readFilesWith(readBlob);
// Each is asked for once.
keepSamplesIn(0);
serveSamples(self);
