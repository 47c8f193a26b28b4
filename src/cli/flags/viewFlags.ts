import type { Command } from 'commander';
import { Option } from 'commander';
import type { Vec3 } from '../../math/vec3.ts';
import { METERING_MODES, type MeteringMode } from '../../nodes/pictures/metering.ts';
import type { Scene } from '../../scene/types.ts';
import type { ColorMode, Solver, View } from '../../scene/view/bufferSettings.ts';
import { DEFAULT_SETTINGS, type RenderSettings } from '../../scene/view/view.ts';
import { TONE_MAPPINGS, type ToneMapping } from '../../spectrum/display/toneMap.ts';
import {
  parseBeta,
  parseDamping,
  parseFov,
  parseFraction,
  parseIterations,
  parseNotNegative,
  parseNumber,
  parsePositive,
  parseVec3,
} from './parse.ts';

/** Where the observer is, how fast, and where it looks. */
export interface ObserverFlags {
  readonly camera?: string;
  readonly beta?: Vec3;
  readonly position?: Vec3;
  readonly lookAt?: Vec3;
  readonly fov?: number;
  readonly c?: number;
}

export function addObserverFlags(command: Command): Command {
  return command
    .option(
      '--camera <prim>',
      "the scene's camera to look through (default: its first; without one, a view of the whole scene)",
    )
    .option(
      '--beta <x,y,z>',
      "the observer's velocity in units of c, world axes (default: the camera's own)",
      parseBeta,
    )
    .option('--position <x,y,z>', 'where the observer is [m]', parseVec3)
    .option('--look-at <x,y,z>', 'look along target − position, world axes [m]', parseVec3)
    .option('--fov <degrees>', "vertical field of view in the observer's frame", parseFov)
    .addOption(speedOfLightOption());
}

export const speedOfLightOption = (): Option =>
  new Option('--c <m/s>', "speed of light (default: what the scene's author suggests, else 299792458)").argParser(
    parsePositive,
  );

/** [m/s]: what the user says, else the scene's author, else nature. */
export const speedOfLight = (scene: Scene, flag: number | undefined): number =>
  flag ?? scene.hints.speedOfLight ?? DEFAULT_SETTINGS.speedOfLight;

/** How the picture is made. */
export interface SettingFlags {
  readonly view: View;
  readonly lightDelay: boolean;
  readonly aberration: boolean;
  readonly colors: ColorMode;
  readonly dopplerMix: number;
  readonly beaming: number;
  readonly shadows: boolean;
  readonly exposure: number;
  readonly metering: MeteringMode;
  readonly tone: ToneMapping;
  readonly solver: Solver;
  readonly iterations: number;
  readonly damping: number;
  readonly antialiasing: boolean;
  readonly grid: boolean;
  readonly occlusionRadius?: number;
}

const views: readonly View[] = ['light-cone', 'simultaneity', 'galilean'];
const solvers: readonly Solver[] = ['exact', 'newton'];
const colorModes: readonly ColorMode[] = ['spectral', 'approximate'];

export const viewOption = (): Option =>
  new Option(
    '--view <name>',
    'light-cone: what is seen; simultaneity: where things are at one instant of the observer; galilean: c = ∞',
  )
    .choices(views)
    .default('light-cone');

export function addSettingFlags(command: Command): Command {
  const { dopplerMix, beaming, exposure, iterations, damping } = DEFAULT_SETTINGS;
  return command
    .addOption(viewOption())
    .option('--no-light-delay', 'as if light were instantaneous')
    .option('--no-aberration', "directions of the world's frame, not the observer's")
    .addOption(
      new Option('--colors <how>', 'how a Doppler shift turns colours: by spectra, or by a simple tint, for comparison')
        .choices(colorModes)
        .default(DEFAULT_SETTINGS.colors),
    )
    .option('--doppler-mix <0…1>', 'how much of the Doppler shift reaches the colours', parseFraction, dopplerMix)
    .option('--beaming <0…1>', 'how much of it reaches the brightness', parseFraction, beaming)
    .option('--no-shadows', 'suns and lamps throw none, for comparison')
    .option(
      '--exposure <EV>',
      'added to what the metering sets: the picture is 2^EV times as bright',
      parseNumber,
      exposure,
    )
    .addOption(
      new Option(
        '--metering <how>',
        "what sets the exposure. automatic: the picture's light; resting-eye: what somebody at rest there would have, so that beaming is seen as it is; manual: --exposure alone",
      )
        .choices(METERING_MODES)
        .default('automatic'),
    )
    .addOption(
      new Option(
        '--tone <curve>',
        'neutral keeps colours and softens what is very bright; agx rolls all of it off, as film does; linear cuts it off',
      )
        .choices(TONE_MAPPINGS)
        .default(DEFAULT_SETTINGS.tone),
    )
    .addOption(new Option('--solver <name>', 'how emission events are found').choices(solvers).default('exact'))
    .option('--iterations <n>', 'steps of the Newton solver', parseIterations, iterations)
    .option('--damping <k>', 'step length of the Newton solver, 0 < k ≤ 1', parseDamping, damping)
    .option('--no-antialiasing', 'every pixel shows what is at its centre, for comparison; in place of --samples')
    .option('--grid', 'draw the reference grid on the ground, which relativity does not bend', false)
    .option(
      '--occlusion-radius <m>',
      "of raster: how far from a point something can hide its sky; 0: nothing does (default: a quarter of the scene's size)",
      parseNotNegative,
    );
}

/** The settings before metering, as the page has them. */
export function renderSettings(flags: SettingFlags, speedOfLight: number): RenderSettings {
  const { view, lightDelay, aberration, colors, dopplerMix, beaming, shadows, exposure } = flags;
  const { tone, solver, iterations, damping, antialiasing, grid, occlusionRadius } = flags;
  return {
    view,
    lightDelay,
    aberration,
    colors,
    dopplerMix,
    beaming,
    shadows,
    exposure,
    tone,
    solver,
    iterations,
    damping,
    antialiasing,
    grid,
    ...(occlusionRadius !== undefined && { occlusionRadius }),
    speedOfLight,
  };
}
