import { SKY_SHAPE } from '../lights/skyGradient.ts';

/*
 * Image effects: their names, arguments and the G-buffer channels that they read. Each is implemented twice: in f64 in reference/post/effects/, which is the
 * standard, and for GPUs in render/post/. All map linear light of any magnitude to linear light. A picture is mirrored beyond its edges, so that blurs neither
 * lose nor gain light there.
 */

/** What an effect may read of a pixel beside its colour. */
export type EffectChannel =
  /** Apparent distance |Δx′| [m], and whether there is a surface. */
  | 'depth'
  /** Unit normal in the surface's rest frame. */
  | 'normal'
  /** World position of the emission event relative to the observer [m]; its length is the distance that the light has travelled in the world frame. */
  | 'event'
  /** Direction that the pixel shows: unit, world frame. */
  | 'direction';

export interface EffectArgument {
  /** Text key. */
  readonly title: string;
  readonly default: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly unit?: string;
  readonly scale?: 'linear' | 'log';
}

export type EffectCategory = 'blur' | 'lens' | 'distance' | 'lines';

export interface EffectInfo {
  readonly title: string;
  readonly help: string;
  readonly category: EffectCategory;
  /** arg1 … arg4; at most four. */
  readonly args: readonly EffectArgument[];
  readonly reads: readonly EffectChannel[];
}

const fraction = (title: string, value: number): EffectArgument => ({
  title,
  default: value,
  min: 0,
  max: 1,
  step: 0.01,
});
const metres = (title: string, value: number): EffectArgument => ({
  title,
  default: value,
  min: 0,
  max: 1e9,
  step: 0.1,
  unit: 'm',
  scale: 'log',
});

export const EFFECTS = {
  'gaussian-blur': {
    title: 'effect.gaussianBlur',
    help: 'effect.gaussianBlur.help',
    category: 'blur',
    args: [
      { title: 'effect.sigma', default: 4, min: 0, max: 20, step: 0.1, unit: 'px' },
      { title: 'effect.angle', default: 0, min: 0, max: 180, step: 1, unit: '°' },
    ],
    reads: [],
  },
  'bilateral-filter': {
    title: 'effect.bilateralFilter',
    help: 'effect.bilateralFilter.help',
    category: 'blur',
    args: [
      { title: 'effect.sigma', default: 3, min: 0, max: 8, step: 0.1, unit: 'px' },
      { title: 'effect.depthRange', default: 0.02, min: 0, max: 1, step: 0.001 },
      { title: 'effect.normalRange', default: 15, min: 0, max: 180, step: 1, unit: '°' },
    ],
    reads: ['depth', 'normal'],
  },
  'sky-background': {
    title: 'effect.skyBackground',
    help: 'effect.skyBackground.help',
    category: 'distance',
    args: [
      { title: 'effect.brightness', default: 1, min: 0, max: 1e6, step: 0.01, scale: 'log' },
      { title: 'effect.steepness', default: SKY_SHAPE.curve, min: 0.05, max: 4, step: 0.05 },
      metres('effect.fadeDistance', 0),
      fraction('effect.opacity', 1),
    ],
    reads: ['depth', 'event', 'direction'],
  },
  sharpen: {
    title: 'effect.sharpen',
    help: 'effect.sharpen.help',
    category: 'lines',
    args: [
      { title: 'effect.strength', default: 0.5, min: 0, max: 4, step: 0.05 },
      { title: 'effect.overshoot', default: 0, min: 0, max: 1, step: 0.05 },
    ],
    reads: [],
  },
  bloom: {
    title: 'effect.bloom',
    help: 'effect.bloom.help',
    category: 'lens',
    args: [fraction('effect.scattered', 0.05), fraction('effect.spread', 0.7)],
    reads: [],
  },
  edge: {
    title: 'effect.edge',
    help: 'effect.edge.help',
    category: 'lines',
    args: [
      { title: 'effect.edgeLight', default: 0, min: 0, max: 10, step: 0.1 },
      { title: 'effect.edgeDepth', default: 2, min: 0, max: 100, step: 0.1 },
      { title: 'effect.edgeNormal', default: 1, min: 0, max: 10, step: 0.1 },
      fraction('effect.edgeUnder', 1),
    ],
    reads: ['depth', 'normal'],
  },
  vignette: {
    title: 'effect.vignette',
    help: 'effect.vignette.help',
    category: 'lens',
    args: [
      fraction('effect.strength', 1),
      { title: 'effect.power', default: 4, min: 0, max: 16, step: 0.5 },
      { title: 'effect.corner', default: 0, min: 0, max: 89, step: 1, unit: '°' },
    ],
    reads: [],
  },
  fog: {
    title: 'effect.fog',
    help: 'effect.fog.help',
    category: 'distance',
    args: [
      { ...metres('effect.freePath', 100), min: 1e-3 },
      { title: 'effect.brightness', default: 0.5, min: 0, max: 1e6, step: 0.01, scale: 'log' },
      fraction('effect.haze', 0.5),
      fraction('effect.overSky', 1),
    ],
    reads: ['depth', 'event'],
  },
  'depth-of-field': {
    title: 'effect.depthOfField',
    help: 'effect.depthOfField.help',
    category: 'lens',
    args: [
      { ...metres('effect.focus', 5), min: 1e-3 },
      { title: 'effect.aperture', default: 20, min: 0, max: 1e6, step: 0.1, unit: 'mm', scale: 'log' },
      { title: 'effect.mostBlur', default: 16, min: 0, max: 24, step: 1, unit: 'px' },
    ],
    reads: ['depth'],
  },
  antialiasing: {
    title: 'effect.antialiasing',
    help: 'effect.antialiasing.help',
    category: 'lines',
    args: [
      fraction('effect.contrast', 0.1),
      { title: 'effect.search', default: 16, min: 1, max: 64, step: 1, unit: 'px' },
      fraction('effect.single', 0.5),
    ],
    reads: [],
  },
} as const satisfies Record<string, EffectInfo>;

export type EffectId = keyof typeof EFFECTS;
export const EFFECT_IDS = Object.keys(EFFECTS) as readonly EffectId[];

/**
 * Modes that blend two images: `a` below, `b` above. `alpha` is the weight of the blended image in the result; for `split` and `wipe` it is the position of the
 * border. Modes that are defined for 0 … 1 (`screen`, `overlay`) blend that range and add what exceeds 1 unchanged, because their formulas would darken it.
 */
export const MIX_MODES = ['normal', 'multiply', 'add', 'screen', 'overlay', 'difference', 'split', 'wipe'] as const;
export type MixMode = (typeof MIX_MODES)[number];

// Constants that both implementations fraction.

/** Cutoff of Gaussians, in standard deviations. */
export const GAUSSIAN_CUTOFF = 3;
/** Number of times that bloom halves the picture: its widest glare spans that many powers of two. */
export const BLOOM_LEVELS = 6;
/** Scattering colours of fog: droplets scatter all colours equally, air mostly blue. */
export const FOG = { gray: [1, 1, 1], haze: [0.55, 0.75, 1] } as const;
/** Most samples per pixel, and the size of the cells for which the largest radius is computed [px]. */
export const DEPTH_OF_FIELD_SAMPLING = { samples: 256, cell: 4 } as const;
/** Contrast compares square roots of luminance and is relative to the brighter of the two, but at least to this root, that of 1/100 of white. */
export const MIN_CONTRAST_BASE = 0.1;
/** Width of the border of a wipe, as a fraction of the picture. */
export const WIPE_WIDTH = 0.1;

/** An effect's arguments, each clamped to its range; missing ones have their defaults. */
export const clampEffectArguments = (id: EffectId, args: readonly number[]): readonly number[] =>
  EFFECTS[id].args.map(({ default: value, min, max }, i) => Math.min(Math.max(args[i] ?? value, min), max));
