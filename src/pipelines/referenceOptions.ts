import { msg } from '../messages/message.ts';
import { DEFAULT_LIGHT, MAX_BOUNCES, SEED_COUNT } from '../reference/lights/lightOptions.ts';
import type { PipelineOptions } from './options.ts';

export const REFERENCE = { id: 'reference', name: msg`reference renderer` } as const;

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
