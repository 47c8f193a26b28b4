import { msg } from '../messages/message.ts';
import { DEFAULT_LIGHT, MAX_BOUNCES, MAX_SAMPLES, SEED_COUNT } from '../reference/lights/lightOptions.ts';
import type { PipelineOptions } from './options.ts';

export const REFERENCE = { id: 'reference', name: msg`reference renderer` } as const;

/** n, for n × n samples from which noise can be told. */
const DEFAULT_MIN_SAMPLES = 3;

/** Options of the reference renderer. */
export const REFERENCE_OPTIONS = {
  threads: {
    kind: 'integer',
    min: 1,
    max: 1024,
    help: msg`number of worker threads (default: that of processors)`,
    changesPicture: false,
  },
  seed: {
    kind: 'integer',
    min: 0,
    max: SEED_COUNT - 1,
    default: 0,
    help: msg`seed of the random numbers; the same seed gives the same bits (default: 0)`,
    changesPicture: false,
    param: { title: msg`Seed`, help: msg`Seed of the random numbers: another seed gives other noise.` },
  },
  noiseThreshold: {
    kind: 'number',
    min: 0,
    max: 1,
    default: 0,
    step: 0.01,
    help: msg`adaptive sampling: ends where there is little noise, instead of taking --samples everywhere; the standard error that those that get all of them may have, of sRGB values 0 … 1, in an .exr relative to the light (0, the default: off)`,
    changesPicture: false,
    param: {
      title: msg`Noise threshold`,
      help: msg`Adaptive sampling: pixels with little noise get fewer samples, and those that get all may have this standard error, relative to the light. 0: all get all.`,
    },
  },
  minSamples: {
    kind: 'integer',
    min: 1,
    max: MAX_SAMPLES,
    default: DEFAULT_MIN_SAMPLES,
    help: msg`with --noise-threshold: n × n samples per pixel at least; more find what is small and bright (default: ${DEFAULT_MIN_SAMPLES})`,
    changesPicture: false,
    param: {
      title: msg`Min samples`,
      help: msg`With a noise threshold: n × n samples per pixel at least. More find what is small and bright.`,
    },
  },
  denoise: {
    kind: 'boolean',
    default: false,
    help: msg`removes what is left of the noise by Open Image Denoise's network: few samples are enough, fine detail of shadows and reflections may be lost`,
    changesPicture: false,
    param: {
      title: msg`Denoise`,
      help: msg`Removes what is left of the noise by Open Image Denoise’s network. Few samples are enough; fine detail of shadows and reflections may be lost.`,
    },
  },
  bounces: {
    kind: 'integer',
    min: 0,
    max: MAX_BOUNCES,
    default: DEFAULT_LIGHT.bounces,
    help: msg`number of bounces of light from the sky and from emissive surfaces (default: ${DEFAULT_LIGHT.bounces})`,
    changesPicture: true,
    param: {
      title: msg`Bounces`,
      help: msg`How often light of the sky and of emissive surfaces is scattered on its way. 0: only suns and lamps; 1: also the sky and emissive surfaces; 2: also surfaces lit by these.`,
    },
  },
  mirrors: {
    kind: 'boolean',
    default: DEFAULT_LIGHT.mirrors,
    help: msg`smooth surfaces reflect the sky and emissive surfaces, but not each other`,
    changesPicture: true,
    param: {
      title: msg`Mirrors`,
      help: msg`Smooth surfaces reflect each other; otherwise only the sky and emissive surfaces.`,
    },
  },
  glass: {
    kind: 'boolean',
    default: DEFAULT_LIGHT.glass,
    help: msg`closed transparent objects refract light with the index of refraction of their material`,
    changesPicture: true,
    param: {
      title: msg`Glass`,
      help: msg`Closed transparent objects refract light; otherwise they are blended with what is behind them.`,
    },
  },
} as const satisfies PipelineOptions;
