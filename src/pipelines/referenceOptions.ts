import { DEFAULT_LIGHT, MAX_BOUNCES, SEED_COUNT } from '../reference/lights/lightOptions.ts';
import type { PipelineOptions } from './options.ts';

export const REFERENCE = { id: 'reference', name: 'reference renderer' } as const;

/** Options of the reference renderer. */
export const REFERENCE_OPTIONS = {
  threads: {
    kind: 'integer',
    min: 1,
    max: 1024,
    help: 'worker threads (default: as many as there are processors)',
    changesPicture: false,
  },
  seed: {
    kind: 'integer',
    min: 0,
    max: SEED_COUNT - 1,
    default: 0,
    help: 'of its random numbers; the same seed gives the same bits (default: 0)',
    changesPicture: false,
    param: { title: 'param.seed', help: 'param.seed.help' },
  },
  bounces: {
    kind: 'integer',
    min: 0,
    max: MAX_BOUNCES,
    default: DEFAULT_LIGHT.bounces,
    help: `how often light of the sky and of what glows is scattered on its way (default: ${DEFAULT_LIGHT.bounces})`,
    changesPicture: true,
    param: { title: 'param.bounces', help: 'param.bounces.help' },
  },
  mirrors: {
    kind: 'boolean',
    default: DEFAULT_LIGHT.mirrors,
    help: 'smooth surfaces mirror the sky and what glows, not each other',
    changesPicture: true,
    param: { title: 'param.mirrors', help: 'param.mirrors.help' },
  },
  glass: {
    kind: 'boolean',
    default: DEFAULT_LIGHT.glass,
    help: 'closed transparent bodies refract light, by their material’s ior',
    changesPicture: true,
    param: { title: 'param.glass', help: 'param.glass.help' },
  },
} as const satisfies PipelineOptions;
