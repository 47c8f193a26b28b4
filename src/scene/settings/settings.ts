import { type LocalizedText, msg } from '../../messages/message.ts';
import type { ToneMapping } from '../../spectrum/display/toneMap.ts';
import { DEFAULT_CONE_SLOPE } from '../views/sliceToCone.ts';
import { VIEW_HELP, VIEW_TITLES } from '../views/views.ts';
import type { ChoiceSetting, Setting } from './setting.ts';

const CONSOLE = ['relativity-console'] as const;
const RASTERIZERS = ['relativity-rasterize', 'rasterize'] as const;

/** The settings of a picture, in the order of the flags. Values are plain data, so that documents, flags and sockets can hold them. */
export const SETTINGS = {
  view: {
    kind: 'choice',
    title: msg`View`,
    help: VIEW_HELP.control,
    default: 'light-cone',
    options: VIEW_TITLES,
    nodes: CONSOLE,
    flag: { value: 'name', help: VIEW_HELP.flag },
    perBuffer: true,
    header: { place: 0, when: 'always' },
  },
  /** λ of the events ct′ = −λr′ of the observer's frame: 0, his moment, to 1, his past light cone. Its own view only. */
  coneSlope: {
    kind: 'number',
    title: msg`From slice to cone`,
    help: msg`0: everything at your own instant. 1: everything as long ago as its light took to you. Between, as long ago as this share of that time.`,
    default: DEFAULT_CONE_SLOPE,
    range: { min: 0, max: 1 },
    control: { min: 0, max: 1, step: 0.01 },
    nodes: CONSOLE,
    onlyWhen: { param: 'view', is: 'slice-to-cone' },
    flag: { value: '0…1', help: msg`of the view slice-to-cone: 0 your own instant, 1 what is seen` },
    perBuffer: true,
    header: { place: 1, when: 'changed' },
  },
  /** The view whose contours are drawn over the picture, of its first G-buffer's scene, for the same observer; with `coneSlope`, and nothing omitted of what is seen. */
  ghost: {
    kind: 'choice',
    title: msg`Ghost`,
    help: msg`Contours of another view over the picture: where things are, over where they are seen, or the other way round.`,
    default: 'none',
    physical: 'none',
    options: { none: msg`None`, ...VIEW_TITLES },
    nodes: CONSOLE,
    flag: { value: 'view', help: msg`of raster: draw the contours of another view over the picture` },
    header: { place: 8, when: 'changed' },
  },
  /** Whether what happens before the observer's world time t, and after it, is drawn apart. In pictures of the past light cone only a ghost's contours are. */
  pastFuture: {
    kind: 'boolean',
    title: msg`Past and future`,
    help: msg`Draws apart what is in the world’s past and in its future, by its clocks, in slices of your own time and in their ghosts.`,
    default: false,
    physical: false,
    nodes: CONSOLE,
    flag: {
      help: msg`of raster: in slices of the observer's time, draw apart what is in the world's past and in its future`,
    },
    header: { place: 9, when: 'changed' },
  },
  /** Off: every point is shown at the observer's world time, as if light were instantaneous. Light-cone view only. */
  lightDelay: {
    kind: 'boolean',
    title: msg`Light delay`,
    help: msg`Moving objects are seen where they were when the light left them.`,
    default: true,
    physical: true,
    nodes: CONSOLE,
    onlyWhen: { param: 'view', is: 'light-cone' },
    flag: { help: msg`as if light arrived instantaneously` },
    perBuffer: true,
    header: { place: 1, when: 'changed' },
  },
  /** Off: directions are those of the world frame instead of the observer's. Light-cone view only. */
  aberration: {
    kind: 'boolean',
    title: msg`Aberration`,
    help: msg`The directions of light depend on your velocity.`,
    default: true,
    physical: true,
    nodes: CONSOLE,
    onlyWhen: { param: 'view', is: 'light-cone' },
    flag: { help: msg`use directions of the world frame instead of the observer's` },
    perBuffer: true,
    header: { place: 2, when: 'changed' },
  },
  /** `spectral`: light has spectra, and Doppler shift acts on wavelengths. the others: light is linear sRGB, and a shift changes its three channels (rgbShifts.ts). */
  colors: {
    kind: 'choice',
    title: msg`Colours`,
    help: msg`Spectral: light has spectra, and Doppler shift acts on wavelengths. The others are for comparison: a simple tint, and the methods of two earlier programs.`,
    default: 'spectral',
    options: {
      spectral: msg`Spectral`,
      approximate: msg`Approximate`,
      'two-wavelengths': msg`Two wavelengths (historical)`,
      'linear-spectrum': msg`Linear spectrum (historical)`,
    },
    nodes: ['relativity-rasterize'],
    flag: {
      value: 'how',
      help: msg`how Doppler shifts change colours: by spectra, or for comparison by a simple tint or the methods of two earlier programs`,
    },
    perBuffer: true,
    header: { place: 3, when: 'light' },
  },
  /** Fraction of log D that is applied to colours, 0 … 1. */
  dopplerMix: {
    kind: 'number',
    title: msg`Doppler mix`,
    help: msg`How strongly the Doppler shift affects colours.`,
    default: 1,
    physical: 1,
    range: { min: 0, max: 1 },
    control: { min: 0, max: 1, step: 0.01 },
    nodes: ['relativity-rasterize'],
    flag: { value: '0…1', help: msg`strength of the Doppler shift of colours` },
    perBuffer: true,
    header: { place: 6, when: 'changed' },
  },
  /** Fraction of log D⁴ that is applied to brightness, 0 … 1. */
  beaming: {
    kind: 'number',
    title: msg`Beaming`,
    help: msg`How strongly light is brighter ahead and darker behind.`,
    default: 1,
    physical: 1,
    range: { min: 0, max: 1 },
    control: { min: 0, max: 1, step: 0.01 },
    nodes: ['relativity-rasterize'],
    flag: { value: '0…1', help: msg`strength of the effect of the Doppler shift on brightness` },
    perBuffer: true,
    header: { place: 7, when: 'changed' },
  },
  /** Whether distant and local lights cast shadows. The reference renderer always has them. */
  shadows: {
    kind: 'boolean',
    title: msg`Shadows`,
    help: msg`Suns and lamps cast shadows, each from where the object was when the light passed it.`,
    default: true,
    nodes: ['deferred-lighting'],
    flag: { help: msg`no shadows of suns and lamps, for comparison` },
  },
  /** Exposure [EV]: light is multiplied by 2^exposure. */
  exposure: {
    kind: 'number',
    title: msg`Exposure`,
    help: msg`Added to the metered exposure. Each stop doubles the brightness.`,
    default: 0,
    control: { min: -10, max: 10, step: 0.1, unit: 'EV' },
    nodes: ['tone-map'],
    flag: {
      value: 'EV',
      help: msg`exposure compensation, added to the metered exposure: the picture is 2^EV times as bright`,
    },
    header: { place: 4, when: 'light', unit: 'EV' },
  },
  /**
   * What determines the exposure. `automatic`: the picture's luminance. `resting-eye`: that luminance without the effect of the observer's velocity, so that
   * beaming is visible. `manual`: the user alone.
   */
  metering: {
    kind: 'choice',
    title: msg`Metering`,
    help: msg`Automatic follows the picture’s luminance, as an eye does. Resting eye uses the exposure of an observer at rest here, so that the headlight effect is visible. Manual is set by you alone.`,
    default: 'automatic',
    options: {
      automatic: msg`Automatic`,
      'resting-eye': msg`Resting eye`,
      manual: msg`Manual`,
    },
    nodes: ['tone-map'],
    flag: {
      value: 'how',
      help: msg`automatic: exposure from the picture's light; resting-eye: the exposure of an observer at rest at the same place, so that beaming shows its true strength; manual: --exposure alone`,
    },
    beforeRendering: true,
  },
  /** Tone curve from exposed light to display values. */
  tone: {
    kind: 'choice',
    title: msg`Tone curve`,
    help: msg`Neutral keeps colours and compresses only very bright light; AgX compresses all light, as film does; Linear clips.`,
    default: 'neutral',
    options: { neutral: msg`Neutral`, agx: msg`AgX`, linear: msg`Linear` },
    nodes: ['tone-map'],
    flag: {
      value: 'curve',
      help: msg`tone curve: neutral keeps colours and compresses highlights; agx rolls off like film; linear clips`,
    },
    header: { place: 5, when: 'light' },
  } satisfies ChoiceSetting<ToneMapping>,
  solver: {
    kind: 'choice',
    title: msg`Solver`,
    help: msg`Exact: closed form or bisection. Newton: the iterative method, for comparison, in what is seen and in simultaneity.`,
    default: 'exact',
    options: { exact: msg`Exact`, newton: msg`Newton` },
    nodes: CONSOLE,
    onlyWhen: { param: 'view', is: ['light-cone', 'simultaneity'] },
    flag: {
      value: 'name',
      help: msg`solver for events on the light cone or in the slice of simultaneity; newton: for comparison`,
    },
    perBuffer: true,
  },
  /** Newton iterations per vertex. */
  iterations: {
    kind: 'number',
    title: msg`Iterations`,
    help: msg`More are more accurate, and slower.`,
    default: 8,
    range: { min: 1, max: 64, integer: true },
    control: { min: 1, max: 32, step: 1, integer: true },
    nodes: CONSOLE,
    onlyWhen: { param: 'solver', is: 'newton' },
    flag: { value: 'n', help: msg`iterations of the Newton solver` },
    perBuffer: true,
  },
  /** Newton step length, 0 < k ≤ 1. */
  damping: {
    kind: 'number',
    title: msg`Damping`,
    help: msg`Smaller steps diverge less easily.`,
    default: 1,
    range: { above: 0, max: 1 },
    control: { min: 0.05, max: 1, step: 0.05 },
    nodes: CONSOLE,
    onlyWhen: { param: 'solver', is: 'newton' },
    flag: { value: 'k', help: msg`step length of the Newton solver, 0 < k ≤ 1` },
    perBuffer: true,
  },
  /** Off: one sample at each pixel's centre. On: FXAA or temporal antialiasing, and accumulated samples at rest. */
  antialiasing: {
    kind: 'boolean',
    title: msg`Antialiasing`,
    help: msg`Smooth edges, stable in motion; a still picture becomes finer over time. Off: every pixel shows what is at its centre.`,
    default: true,
    nodes: RASTERIZERS,
    flag: { help: msg`one sample at the centre of every pixel, for comparison; excludes --samples` },
  },
  /** Whether the reference grid is drawn on the ground, unaffected by relativity. */
  grid: {
    kind: 'boolean',
    title: msg`Reference grid`,
    help: msg`A grid on the ground that is not affected by relativity.`,
    default: false,
    nodes: RASTERIZERS,
    flag: { help: msg`draw the reference grid on the ground, which is not affected by relativity` },
  },
  /** Radius of ambient occlusion in the rasterizer [m]; 0: none. Absent: a quarter of the scene's radius. */
  occlusionRadius: {
    kind: 'number',
    range: { min: 0 },
    flag: {
      value: 'm',
      help: msg`of raster: radius of ambient occlusion [m]; 0: none (default: a quarter of the scene's size)`,
    },
  },
} as const satisfies Readonly<Record<string, Setting>>;

type Settings = typeof SETTINGS;
export type SettingName = keyof Settings;
export const SETTING_NAMES = Object.keys(SETTINGS) as readonly SettingName[];
/** A setting by name, without the type of its value. */
export const settingNamed = (name: SettingName): Setting => SETTINGS[name];

export type SettingValue<Name extends SettingName> = Settings[Name] extends {
  readonly options: Readonly<Record<infer Value, LocalizedText>>;
}
  ? Value
  : Settings[Name] extends { readonly kind: 'boolean' }
    ? boolean
    : number;
/** Names of the settings whose entry extends `Like`. */
type NamesLike<Like> = { [Name in SettingName]: Settings[Name] extends Like ? Name : never }[SettingName];
/** Names of the settings that are parameters of a node type. */
export type SettingOfNode<Id extends string> = {
  [Name in SettingName]: Settings[Name] extends { readonly nodes: readonly (infer Node)[] }
    ? Id extends Node
      ? Name
      : never
    : never;
}[SettingName];
type WithDefault = NamesLike<{ readonly default: unknown }>;

/** Values of the named settings; those without a default are optional. */
export type ValuesOf<Names extends SettingName> = {
  readonly [Name in keyof Settings as Name extends Names & WithDefault ? Name : never]: SettingValue<Name>;
} & {
  readonly [Name in keyof Settings as Name extends Exclude<Names, WithDefault> ? Name : never]?: SettingValue<Name>;
};
/** The settings that renderers read. */
export type RendererSettings = ValuesOf<Exclude<SettingName, NamesLike<{ readonly beforeRendering: true }>>>;
export const RENDERER_SETTINGS = SETTING_NAMES.filter(
  (name) => !settingNamed(name).beforeRendering,
) as readonly (keyof RendererSettings)[];

type PerBuffer = NamesLike<{ readonly perBuffer: true }>;
/** The settings that a G-buffer is rendered with. */
export interface BufferSettings extends ValuesOf<PerBuffer> {
  /** [m/s] */
  readonly speedOfLight: number;
}
export const BUFFER_SETTINGS: readonly (keyof BufferSettings)[] = [
  ...(SETTING_NAMES.filter((name) => settingNamed(name).perBuffer) as PerBuffer[]),
  'speedOfLight',
];

/** How the GPU finds events on the light cone and in the slice of simultaneity: in closed form, or by Newton's iteration for comparison (docs/physics.md §4.11, §5.6). */
export type Solver = SettingValue<'solver'>;
export type ColorMode = SettingValue<'colors'>;
export type MeteringMode = SettingValue<'metering'>;

/** The values of these settings in an object. */
export const pickSettings = <Name extends string>(
  names: readonly Name[],
  from: { readonly [K in Name]?: unknown },
): Readonly<Record<string, unknown>> =>
  Object.fromEntries(names.filter((name) => from[name] !== undefined).map((name) => [name, from[name]]));
