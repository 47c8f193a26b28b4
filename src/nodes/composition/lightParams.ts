import type { ChoiceParam, ColorParam, NumberParam, TextParam } from '../../graph/nodeType.ts';
import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { LIGHT_PRESETS } from '../../spectrum/sources/lightPresets.ts';
import type { LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import { rootPrimPath } from '../geometry/primitives/definePrimitive.ts';

/** Name of the prim: `/name`. */
export const nameParam = (value: string): TextParam => ({
  kind: 'text',
  title: msg`Name`,
  help: msg`Name in the scene: letters, digits and _.`,
  default: value,
});

/** Colour of the light as reflected by a white surface at rest. */
export const lightColorParam: ColorParam = { kind: 'color', title: msg`Colour`, default: [1, 1, 1] };

export const brightnessParam = (title: LocalizedText, value: number): NumberParam => ({
  kind: 'number',
  title,
  help: msg`Full daylight is about 3.`,
  default: value,
  min: 0,
  max: 1e9,
  step: 0.1,
  slider: false,
});

const EMISSION_TITLES: Readonly<Record<string, Message>> = {
  daylight: msg`Daylight (6504 K)`,
  d65: msg`Daylight, measured (D65)`,
  candle: msg`Candle`,
  tungsten: msg`Light bulb`,
  'blue-star': msg`Blue star`,
  fluorescent: msg`Fluorescent tube`,
  triphosphor: msg`Triphosphor tube`,
  led: msg`White LED`,
  'street-sodium': msg`Sodium street light`,
  sodium: msg`Sodium lines`,
  mercury: msg`Mercury`,
  hydrogen: msg`Hydrogen`,
};

/** Emission spectrum preset; a connected spectrum takes precedence. */
export const emissionParam: ChoiceParam = {
  kind: 'choice',
  title: msg`Spectrum`,
  help: msg`The spectrum of the light at rest, which determines the colours after a Doppler shift. Daylight whose colour is that of a blackbody is treated as one.`,
  default: 'daylight',
  options: [...LIGHT_PRESETS.keys()].map((name) => ({ value: name, title: EMISSION_TITLES[name] ?? name })),
};

/**
 * Path and spectrum of a light; daylight has no spectrum, since its colour determines one
 * (spectrum/color/spectrumOfColor.ts).
 */
export function lightBase(name: string, node: string, preset: string, connected?: LightSpectrum) {
  const spectrum = connected ?? (preset === emissionParam.default ? undefined : LIGHT_PRESETS.get(preset)?.spectrum);
  return { path: rootPrimPath(name, node), ...(spectrum && { spectrum }) };
}
