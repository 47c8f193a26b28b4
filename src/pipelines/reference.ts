import { msg } from '../messages/message.ts';
import { MAX_SAMPLES } from '../reference/lights/lightOptions.ts';
import { AOVS, type AovName } from '../scene/view/view.ts';
import { definePipeline } from './pipeline.ts';
import { REFERENCE, REFERENCE_OPTIONS } from './referenceOptions.ts';

/** Traces rays through spacetime in f64 on the processor; its code is imported lazily. */
export const referencePipeline = definePipeline({
  ...REFERENCE,
  summary: msg`traces rays in 64-bit arithmetic on the CPU, without a GPU`,
  backends: [],
  usesThreads: true,
  fallback: msg`slower, and exact`,
  constraint: msg`needs no GPU and is always exact`,
  fixedSettings: { solver: 'exact' },
  options: REFERENCE_OPTIONS,
  aovs: Object.keys(AOVS) as AovName[],
  samples: { default: 4 },
  maxViews: Number.POSITIVE_INFINITY,
  still: {
    node: 'reference-render',
    title: msg`Reference render`,
    help: msg`A still by the reference renderer: rays traced into the past in 64-bit arithmetic, including light that objects cast on each other. It uses the camera and the time set here, not the flying observer. It is centred in the picture at full height; what is wider is cropped. It takes a while, on all processors.`,
    maxPixels: 2 ** 22,
    maxPaths: 2 ** 26,
    maxSamples: MAX_SAMPLES,
  },
  open: async (request, host) => (await import('./referenceSession.ts')).openReferenceSession(request, host),
  serveThread: async (port) => (await import('../reference/tracerServer.ts')).serveTracer(port),
});
