import { serveSamples } from '../../render/sampleServer.ts';
import { readFilesWith } from '../../scene/storedNumbers.ts';
import { readBlob } from '../loading/blobs.ts';

/** Reads samples that are left in files off the main thread. */
readFilesWith(readBlob);
serveSamples(self);
