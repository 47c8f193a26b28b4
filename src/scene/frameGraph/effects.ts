import type { Vec3 } from '../../math/vec3.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
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
  readonly title: LocalizedText;
  readonly default: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly unit?: string;
  readonly scale?: 'linear' | 'log';
}

export type EffectCategory = 'blur' | 'lens' | 'distance' | 'lines' | 'color';

export interface EffectInfo {
  readonly title: LocalizedText;
  readonly help: LocalizedText;
  readonly category: EffectCategory;
  /** arg1 … arg4; at most four. */
  readonly args: readonly EffectArgument[];
  readonly reads: readonly EffectChannel[];
}

const fraction = (title: LocalizedText, value: number): EffectArgument => ({
  title,
  default: value,
  min: 0,
  max: 1,
  step: 0.01,
});
const metres = (title: LocalizedText, value: number): EffectArgument => ({
  title,
  default: value,
  min: 0,
  max: 1e9,
  step: 0.1,
  unit: 'm',
  scale: 'log',
});

/** What distant things fade into, where an effect does not take its own: the sky in the same direction, or a colour, linear sRGB. Its brightness is the effect's argument. */
export type FogColor = 'sky' | Vec3;

export const EFFECTS = {
  'gaussian-blur': {
    title: msg`Gaussian blur`,
    help: msg`Blurs along one direction; two of them, horizontal and vertical, blur evenly. No light is lost at the edges.`,
    category: 'blur',
    args: [
      { title: msg`Width (σ)`, default: 4, min: 0, max: 20, step: 0.1, unit: 'px' },
      { title: msg`Direction`, default: 0, min: 0, max: 180, step: 1, unit: '°' },
    ],
    reads: [],
  },
  'bilateral-filter': {
    title: msg`Bilateral filter`,
    help: msg`Smooths noise, such as that of ambient occlusion, but not across the edges of objects.`,
    category: 'blur',
    args: [
      { title: msg`Width (σ)`, default: 3, min: 0, max: 8, step: 0.1, unit: 'px' },
      { title: msg`Range of distances`, default: 0.02, min: 0, max: 1, step: 0.001 },
      { title: msg`Range of normals`, default: 15, min: 0, max: 180, step: 1, unit: '°' },
    ],
    reads: ['depth', 'normal'],
  },
  'sky-background': {
    title: msg`Sky background`,
    help: msg`Fills the background with a clear sky; distant objects fade into it. It is at rest in the world and has no Doppler shift.`,
    category: 'distance',
    args: [
      { title: msg`Brightness`, default: 1, min: 0, max: 1e6, step: 0.01, scale: 'log' },
      { title: msg`Gradient`, default: SKY_SHAPE.curve, min: 0.05, max: 4, step: 0.05 },
      metres(msg`Fades at (0: never)`, 0),
      fraction(msg`Opacity`, 1),
    ],
    reads: ['depth', 'event', 'direction'],
  },
  sharpen: {
    title: msg`Sharpen`,
    help: msg`Makes edges steeper; without overshoot there are no halos.`,
    category: 'lines',
    args: [
      { title: msg`Strength`, default: 0.5, min: 0, max: 4, step: 0.05 },
      { title: msg`Overshoot`, default: 0, min: 0, max: 1, step: 0.05 },
    ],
    reads: [],
  },
  bloom: {
    title: msg`Bloom`,
    help: msg`Light scattered by a lens or an eye. Conserves the total light; there is no threshold.`,
    category: 'lens',
    args: [fraction(msg`Scattered light`, 0.05), fraction(msg`Spread`, 0.7)],
    reads: [],
  },
  edge: {
    title: msg`Edges`,
    help: msg`Draws lines where luminance changes, at silhouettes and at creases.`,
    category: 'lines',
    args: [
      { title: msg`By light`, default: 0, min: 0, max: 10, step: 0.1 },
      { title: msg`By distance`, default: 2, min: 0, max: 100, step: 0.1 },
      { title: msg`By normals`, default: 1, min: 0, max: 10, step: 0.1 },
      fraction(msg`Picture opacity`, 1),
    ],
    reads: ['depth', 'normal'],
  },
  vignette: {
    title: msg`Vignette`,
    help: msg`Darkens towards the corners by a power of the cosine of the off-axis angle: 4 is a thin lens.`,
    category: 'lens',
    args: [
      fraction(msg`Strength`, 1),
      { title: msg`Power`, default: 4, min: 0, max: 16, step: 0.5 },
      { title: msg`Corner angle (0: camera)`, default: 0, min: 0, max: 89, step: 1, unit: '°' },
    ],
    reads: [],
  },
  fog: {
    title: msg`Fog`,
    help: msg`Fog at rest in the world: attenuates by the path that the light has travelled there, not by the apparent distance.`,
    category: 'distance',
    args: [
      { ...metres(msg`Mean free path`, 100), min: 1e-3 },
      { title: msg`Brightness`, default: 0.5, min: 0, max: 1e6, step: 0.01, scale: 'log' },
      fraction(msg`Grey to haze`, 0.5),
      fraction(msg`Over the sky`, 1),
    ],
    reads: ['depth', 'event', 'direction'],
  },
  'hue-shift': {
    title: msg`Hue shift`,
    help: msg`Turns the hues, and strengthens or weakens them; the luminance stays. It has nothing to do with the Doppler effect.`,
    category: 'color',
    args: [
      { title: msg`Angle`, default: 60, min: -180, max: 180, step: 1, unit: '°' },
      { title: msg`Saturation`, default: 1, min: 0, max: 4, step: 0.05 },
    ],
    reads: [],
  },
  'observer-marks': {
    title: msg`Observer and light rings`,
    help: msg`In a picture from outside: where the observer is, how far he comes while light goes from one ring to the next, and rings on which all is that he sees that many seconds old.`,
    category: 'lines',
    args: [
      { title: msg`Rings every`, default: 1, min: 1e-12, max: 1e9, step: 0.1, unit: 's', scale: 'log' },
      fraction(msg`Opacity of the rings`, 0.7),
      { title: msg`Size of the observer`, default: 6, min: 0, max: 40, step: 1, unit: 'px' },
    ],
    reads: ['depth', 'direction'],
  },
  'lens-grid': {
    title: msg`Test grid`,
    help: msg`Lines of equal height and bearing through whatever lens the picture has, those of the horizon and of the direction ahead twice as thick, and the border of the part that is safe to use. For dome masters the zenith is in the middle. Place it after Tone Map.`,
    category: 'lines',
    args: [
      { title: msg`Lines every`, default: 15, min: 1, max: 90, step: 1, unit: '°' },
      fraction(msg`Safe part (0: no border)`, 0.9),
      fraction(msg`Opacity`, 0.8),
      { title: msg`Width of the lines`, default: 1.5, min: 0.5, max: 20, step: 0.5, unit: 'px' },
    ],
    reads: [],
  },
  'depth-of-field': {
    title: msg`Depth of field`,
    help: msg`A thin lens carried by the observer: focuses by the distance of an event in the observer’s frame.`,
    category: 'lens',
    args: [
      { ...metres(msg`In focus at`, 5), min: 1e-3 },
      { title: msg`Aperture`, default: 20, min: 0, max: 1e6, step: 0.1, unit: 'mm', scale: 'log' },
      { title: msg`Maximum blur`, default: 16, min: 0, max: 24, step: 1, unit: 'px' },
    ],
    reads: ['depth'],
  },
  antialiasing: {
    title: msg`Antialiasing`,
    help: msg`Smooths jagged edges in a finished picture. Place it after Tone Map.`,
    category: 'lines',
    args: [
      fraction(msg`Minimum contrast`, 0.1),
      { title: msg`Search along edges`, default: 16, min: 1, max: 64, step: 1, unit: 'px' },
      fraction(msg`Spread single pixels`, 0.5),
    ],
    reads: [],
  },
} as const satisfies Record<string, EffectInfo>;

export type EffectId = keyof typeof EFFECTS;
export const EFFECT_IDS = Object.keys(EFFECTS) as readonly EffectId[];

/**
 * Modes that blend two images: `a` below, `b` above. `alpha` is the weight of the blended image in the result; for `split` and `wipe` it is the position of the
 * border, for `inset` the share of the width and height that `b`, made smaller, takes in the lower right corner. Modes that are defined for 0 … 1 (`screen`, `overlay`) blend that range and add what exceeds 1 unchanged, because their formulas would darken it.
 */
export const MIX_MODES = [
  'normal',
  'multiply',
  'add',
  'screen',
  'overlay',
  'difference',
  'split',
  'wipe',
  'inset',
] as const;
export type MixMode = (typeof MIX_MODES)[number];

// Constants that both implementations share.

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
/** How the observer and the rings about him are drawn: lines [px], linear colours, and share of opacity behind surfaces. */
export const OBSERVER_MARKS = {
  ringWidth: 1.5,
  ring: [1, 0.62, 0.1],
  /** Rings are left out where they are closer than the first, and full from the second [px]. */
  ringGap: [5, 12],
  /** Beyond the first they fade, up to the second: numbers of rings. */
  farthest: [9, 12],
  arrowWidth: 2.5,
  /** Length of the arrow's barbs over the observer's size, and tan of their angle to the shaft. */
  barb: { length: 2, slope: 0.5 },
  arrow: [1, 1, 1],
  body: [0.1, 0.75, 1],
  border: 1.5,
  edge: [0.01, 0.02, 0.04],
  hidden: 0.4,
} as const;
/** Test grid: linear colours of its lines and of the border, and how far apart lines must be to be seen at all, and fully [px]. */
export const LENS_GRID = { line: [0.75, 0.85, 1], border: [1, 0.3, 0.02], gap: [5, 12] } as const;
/** Of an inset: its distance from the edges of the picture and its border [px of 1080 rows], and samples per pixel along each axis. */
export const INSET = { margin: 24, border: 3, color: [0.02, 0.02, 0.02], samples: 4 } as const;
/** Width of the border of a wipe, as a fraction of the picture. */
export const WIPE_WIDTH = 0.1;

/** An effect's arguments, each clamped to its range; missing ones have their defaults. */
export const clampEffectArguments = (id: EffectId, args: readonly number[]): readonly number[] =>
  EFFECTS[id].args.map(({ default: value, min, max }, i) => Math.min(Math.max(args[i] ?? value, min), max));
