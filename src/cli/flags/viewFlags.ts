import type { Command } from 'commander';
import { Option } from 'commander';
import type { Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import {
  pickSettings,
  RENDERER_SETTINGS,
  type RendererSettings,
  SETTING_NAMES,
  type SettingName,
  settingNamed,
  type ValuesOf,
} from '../../scene/settings/settings.ts';
import type { Scene } from '../../scene/types.ts';
import { LENS_CHOICES, type LensChoice, USUAL_LENS } from '../../scene/view/lenses/lensChoice.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { localized } from '../terminal/language.ts';
import {
  parseAperture,
  parseBeta,
  parseDomeTilt,
  parseFov,
  parseNumber,
  parsePositive,
  parseVec3,
  parseWithin,
} from './parse.ts';

/** How one who rides on a moving camera goes from sample to sample. */
const CAMERA_PATHS = ['smooth', 'straight'] as const;
type CameraPath = (typeof CAMERA_PATHS)[number];

/** Where the observer is and how he moves. */
export interface StandpointFlags {
  readonly camera?: string;
  readonly cameraPath: CameraPath;
  readonly beta?: Vec3;
  readonly position?: Vec3;
  readonly c?: number;
}

export interface ObserverFlags extends StandpointFlags {
  readonly lookAt?: Vec3;
  readonly fov?: number;
  readonly lens?: LensChoice;
  /** [°] */
  readonly aperture?: number;
  /** [°] */
  readonly domeTilt?: number;
  /** [m] */
  readonly eyeSeparation?: number;
}

export const addStandpointFlags = (command: Command): Command =>
  command
    .option(
      '--camera <prim>',
      localized(msg`prim path of the camera (default: the scene's first; if it has none, a view of the whole scene)`),
    )
    .addOption(
      new Option(
        '--camera-path <path>',
        localized(
          msg`through the samples of a moving camera: smooth, so that the velocity does not jump at them, or in straight lines`,
        ),
      )
        .choices(CAMERA_PATHS)
        .default('smooth'),
    )
    .option(
      '--beta <x,y,z>',
      localized(msg`the observer's velocity in units of c, world axes (default: the camera's)`),
      parseBeta,
    )
    .option('--position <x,y,z>', localized(msg`position of the observer, world frame [m]`), parseVec3);

export const addObserverFlags = (command: Command): Command =>
  addStandpointFlags(command)
    .option(
      '--look-at <x,y,z>',
      localized(msg`direction of the camera: from its position towards this point, world axes [m]`),
      parseVec3,
    )
    .option('--fov <degrees>', localized(msg`vertical field of view in the observer's frame`), parseFov)
    .addOption(
      new Option(
        '--lens <name>',
        localized(
          msg`how directions are shown: perspective; equirectangular, 360° around; fisheye, ahead in the middle; dome, a dome master: the zenith in the middle, ahead at the bottom; cube, 3 × 2 faces; cube-strip, six in a row; stereo, 360° for two eyes, the left one’s picture above (default: perspective)`,
        ),
      ).choices(Object.keys(LENS_CHOICES)),
    )
    .option(
      '--aperture <degrees>',
      localized(msg`of fisheye and dome: the angle across the circle (default: ${USUAL_LENS.aperture})`),
      parseAperture,
    )
    .option(
      '--dome-tilt <degrees>',
      localized(msg`of dome: by how much the dome is tilted towards the front (default: ${USUAL_LENS.domeTilt})`),
      parseDomeTilt,
    )
    .option(
      '--eye-separation <m>',
      localized(
        msg`of stereo: the distance of the eyes, in the observer's frame [m] (default: ${USUAL_LENS.eyeSeparation})`,
      ),
      parsePositive,
    )
    .addOption(speedOfLightOption());

export const observerTimeOption = (): Option =>
  new Option(
    '--time <s>',
    localized(msg`world time of the observer's event [s] (default: suggested by the scene, else its start)`),
  ).argParser(parseNumber);

export const speedOfLightOption = (): Option =>
  new Option(
    '--c <m/s>',
    localized(msg`speed of light (default: suggested by the scene, else ${SPEED_OF_LIGHT})`),
  ).argParser(parsePositive);

/** [m/s]: by the flag, else the scene's hint, else 299 792 458. */
export const speedOfLight = (scene: Scene, flag: number | undefined): number =>
  flag ?? scene.hints.speedOfLight ?? SPEED_OF_LIGHT;

export type SettingFlags = ValuesOf<SettingName>;

export function addSettingFlags(command: Command): Command {
  for (const name of SETTING_NAMES) command.addOption(settingOption(name));
  return command;
}

/** `lightDelay` → `light-delay` */
export const flagName = (name: string): string => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** `lightDelay`, default true: `--no-light-delay`; `dopplerMix`: `--doppler-mix <0…1>`. */
export function settingOption(name: SettingName): Option {
  const setting = settingNamed(name);
  const { value } = setting.flag;
  const help = localized(setting.flag.help);
  const flag = flagName(name);
  if (setting.kind === 'boolean')
    return setting.default ? new Option(`--no-${flag}`, help) : new Option(`--${flag}`, help).default(false);
  const option = new Option(`--${flag} <${value}>`, help);
  if (setting.kind === 'choice') return option.choices(Object.keys(setting.options)).default(setting.default);
  option.argParser(setting.range ? parseWithin(setting.range) : parseNumber);
  return setting.default === undefined ? option : option.default(setting.default);
}

/** The renderer's settings before metering. */
export const renderSettings = (flags: SettingFlags, speedOfLight: number): RenderSettings => ({
  ...(pickSettings(RENDERER_SETTINGS, flags) as RendererSettings),
  speedOfLight,
});
