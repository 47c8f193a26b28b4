import { degrees, radians } from '../../math/angle.ts';
import { length, type Vec3 } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import type { FalseColorScale } from '../../spectrum/falseColor/falseColor.ts';
import { RENDERER_SETTINGS, settingNamed } from '../settings/settings.ts';
import type { FisheyeLens } from './lenses/fisheyeLens.ts';
import type { Lens } from './lenses/lenses.ts';
import type { RenderSettings, ViewPoint } from './view.ts';

// Header metadata of picture files, named as in docs/conventions.md. It describes the picture only, not the machine or the files that it comes from.

/** The observer's event and lens, so that the picture can be reproduced. */
export function observerMetadata(
  { t, position, u, vantage, lens }: ViewPoint,
  speedOfLight: number,
): Record<string, string> {
  const beta = velocity(u);
  return {
    worldTime: `${t} s`,
    speedOfLight: `${speedOfLight} m/s`,
    observerPosition: `${vector(position)} m`,
    observerBeta: vector(beta),
    observerSpeed: `${length(beta)} c`,
    ...(vantage && { vantage: `${vector(vantage)} m` }),
    ...lensMetadata(lens),
  };
}

/** The same, with the display settings. `settings` include the metered exposure. */
export function pictureMetadata(view: ViewPoint, settings: RenderSettings): Record<string, string> {
  const { falseColors, outside, capture } = settings;
  const showsLight = falseColors === undefined || falseColors.kind === 'band';
  return {
    Software: 'Slowlight',
    ...observerMetadata(view, settings.speedOfLight),
    ...settingsMetadata(settings, showsLight),
    ...(outside && { outsideCamera: `${vector(outside.place)} m from the ${outside.follows ? 'observer' : 'origin'}` }),
    ...(capture && { capture: `moved by ${capture.maxError} px at most` }),
    ...(falseColors && { falseColors: falseColorRange(falseColors) }),
  };
}

/** Its field of view, or what a panoramic lens is. */
function lensMetadata(lens: Lens): Record<string, string> {
  switch (lens.kind) {
    case 'perspective':
      return { fieldOfView: `${degrees(lens.fovY)} degrees` };
    case 'equirectangular':
      return { lens: lens.kind };
    case 'fisheye':
      return {
        lens: `${lens.kind} of ${degrees(lens.aperture)} degrees, its axis ${degrees(lens.elevation)} degrees up`,
      };
    case 'cube':
      return { lens: `${lens.kind} ${lens.layout}` };
    case 'stereo':
      return { lens: `${lens.kind}, left eye above right eye, ${lens.separation} m apart` };
  }
}

/** The lens of a fisheye or dome whose header has this `lens`; undefined for all others. */
export function fisheyeOfMetadata(text: string): FisheyeLens | undefined {
  const found = /^fisheye of ([\d.]+) degrees, its axis (-?[\d.]+) degrees up$/.exec(text);
  const [aperture, elevation] = [Number(found?.[1]), Number(found?.[2])];
  if (!(aperture > 0 && aperture <= 360 && Math.abs(elevation) <= 180)) return undefined;
  return { kind: 'fisheye', aperture: radians(aperture), elevation: radians(elevation) };
}

/** The settings with a `header` entry, as far as its `when` applies. */
function settingsMetadata(settings: RenderSettings, showsLight: boolean): Record<string, string> {
  const told = RENDERER_SETTINGS.flatMap((name) => {
    const { header, default: usual } = settingNamed(name);
    const value = settings[name];
    if (!header || (header.when === 'light' && !showsLight) || (header.when === 'changed' && value === usual))
      return [];
    const text = typeof value === 'boolean' ? (value ? 'on' : 'off') : String(value);
    return [{ place: header.place, entry: [name, header.unit ? `${text} ${header.unit}` : text] as const }];
  });
  return Object.fromEntries(told.sort((a, b) => a.place - b.place).map(({ entry }) => entry));
}

const UNITS = { doppler: '', 'emission-time': ' s', radiance: '', band: ' m' } as const;
const falseColorRange = ({ kind, from, to }: FalseColorScale): string =>
  `${kind} from ${from}${UNITS[kind]} to ${to}${UNITS[kind]}`;
const vector = (v: Vec3): string => v.join(' ');
