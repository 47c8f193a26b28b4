import { DEFAULT_LIGHT, MAX_BOUNCES, SEED_COUNT } from '../reference/lights/lightOptions.ts';
import type { PipelineOptions } from './options.ts';

export const REFERENCE = { id: 'reference', name: 'reference renderer' } as const;

/** Options of the reference renderer. */
export const REFERENCE_OPTIONS = {
  threads: {
    kind: 'integer',
    min: 1,
    max: 1024,
    help: 'number of worker threads (default: that of processors)',
    changesPicture: false,
  },
  seed: {
    kind: 'integer',
    min: 0,
    max: SEED_COUNT - 1,
    default: 0,
    help: 'seed of the random numbers; the same seed gives the same bits (default: 0)',
    changesPicture: false,
    param: { title: 'param.seed', help: 'param.seed.help' },
  },
  bounces: {
    kind: 'integer',
    min: 0,
    max: MAX_BOUNCES,
    default: DEFAULT_LIGHT.bounces,
    help: `number of bounces of light from the sky and from emissive surfaces (default: ${DEFAULT_LIGHT.bounces})`,
    changesPicture: true,
    param: { title: 'param.bounces', help: 'param.bounces.help' },
  },
  mirrors: {
    kind: 'boolean',
    default: DEFAULT_LIGHT.mirrors,
    help: 'smooth surfaces reflect the sky and emissive surfaces, but not each other',
    changesPicture: true,
    param: { title: 'param.mirrors', help: 'param.mirrors.help' },
  },
  glass: {
    kind: 'boolean',
    default: DEFAULT_LIGHT.glass,
    help: 'closed transparent objects refract light with the index of refraction of their material',
    changesPicture: true,
    param: { title: 'param.glass', help: 'param.glass.help' },
  },
} as const satisfies PipelineOptions;
