import { SKY_SHAPE } from '../lights/skyGradient.ts';

/*
 * Effects over a finished picture: what they are called, which numbers they take, and what of the G-buffer they read. What each one does is written
 * twice: in f64 in reference/effects/, which is the truth, and for GPUs in render/effects/. All of them take and give linear light without an
 * upper end; beyond its edges a picture goes on as its mirror image, so that what blurs it neither loses light there nor gains any.
 */

/** What an effect may know of a pixel beside its colour. */
export type EffectChannel =
  /** Apparent distance |Δx′| [m], and whether anything is there. */
  | 'depth'
  /** Unit normal in the surface's rest frame. */
  | 'normal'
  /** World place of the event that is seen, from the observer [m]; its length is what its light has travelled in the world's frame. */
  | 'event'
  /** Direction in which the world is seen there: unit, world frame. */
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
  /** arg1 … arg4: four at most. */
  readonly args: readonly EffectArgument[];
  readonly reads: readonly EffectChannel[];
}

const share = (title: string, value: number): EffectArgument => ({
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
      share('effect.opacity', 1),
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
    args: [share('effect.scattered', 0.05), share('effect.spread', 0.7)],
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
      share('effect.edgeUnder', 1),
    ],
    reads: ['depth', 'normal'],
  },
  vignette: {
    title: 'effect.vignette',
    help: 'effect.vignette.help',
    category: 'lens',
    args: [
      share('effect.strength', 1),
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
      share('effect.haze', 0.5),
      share('effect.overSky', 1),
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
      share('effect.contrast', 0.1),
      { title: 'effect.search', default: 16, min: 1, max: 64, step: 1, unit: 'px' },
      share('effect.single', 0.5),
    ],
    reads: [],
  },
} as const satisfies Record<string, EffectInfo>;

export type EffectId = keyof typeof EFFECTS;
export const EFFECT_IDS = Object.keys(EFFECTS) as readonly EffectId[];

/**
 * Two pictures into one: `a` below, `b` above. `alpha` is the share of the blended picture in the result; for `split` and `wipe` it is the place of the border.
 * Modes that are made for 0 … 1 (`screen`, `overlay`) blend what lies there and add what is above 1 as it is: their formulas would darken brighter light.
 */
export const MIX_MODES = ['normal', 'multiply', 'add', 'screen', 'overlay', 'difference', 'split', 'wipe'] as const;
export type MixMode = (typeof MIX_MODES)[number];

// What nobody turns, and both twins need.

/** A Gaussian is cut off at so many standard deviations. */
export const GAUSSIAN_CUTOFF = 3;
/** How many times bloom halves the picture: its widest glare is that many powers of two across. */
export const BLOOM_LEVELS = 6;
/** Of fog: droplets scatter all colours alike, air the blue ones. */
export const FOG = { gray: [1, 1, 1], haze: [0.55, 0.75, 1] } as const;
/** At most so many places of the lens are looked through for each pixel; and the cells in which the widest blur is looked up [px]. */
export const DEPTH_OF_FIELD_SAMPLING = { samples: 256, cell: 4 } as const;
/** Contrast is of what eyes make of light, its root, over the brighter of the two; but over that of 1/100 of white where both are darker. */
export const MIN_CONTRAST_BASE = 0.1;
/** How wide the border of a wipe is, as a share of the picture. */
export const WIPE_WIDTH = 0.1;

/** The numbers of an effect, each held to its range; the default's where one is missing. */
export const clampEffectArguments = (id: EffectId, args: readonly number[]): readonly number[] =>
  EFFECTS[id].args.map(({ default: value, min, max }, i) => Math.min(Math.max(args[i] ?? value, min), max));
