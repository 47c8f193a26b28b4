import type { ChoiceParam, ColorParam, NumberParam, TextParam } from '../../graph/nodeType.ts';
import { LIGHT_PRESETS } from '../../spectrum/sources/lightPresets.ts';
import type { LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import { rootPrimPath } from '../geometry/primitives/definePrimitive.ts';

/** Name of the prim: `/name`. */
export const nameParam = (value: string): TextParam => ({
  kind: 'text',
  title: 'param.name',
  help: 'param.name.help',
  default: value,
});

/** Colour of the light as reflected by a white surface at rest. */
export const lightColorParam: ColorParam = { kind: 'color', title: 'param.lightColor', default: [1, 1, 1] };

export const brightnessParam = (title: string, value: number): NumberParam => ({
  kind: 'number',
  title,
  help: 'param.brightness.help',
  default: value,
  min: 0,
  max: 1e9,
  step: 0.1,
  slider: false,
});

/** Emission spectrum preset; a connected spectrum takes precedence. */
export const emissionParam: ChoiceParam = {
  kind: 'choice',
  title: 'param.madeOf',
  help: 'param.madeOf.help',
  default: 'daylight',
  options: [...LIGHT_PRESETS.keys()].map((name) => ({ value: name, title: `light.${name}` })),
};

/**
 * Path and spectrum of a light; daylight has no spectrum, since its colour determines one
 * (spectrum/color/spectrumOfColor.ts).
 */
export function lightBase(name: string, node: string, preset: string, connected?: LightSpectrum) {
  const spectrum = connected ?? (preset === emissionParam.default ? undefined : LIGHT_PRESETS.get(preset)?.spectrum);
  return { path: rootPrimPath(name, node), ...(spectrum && { spectrum }) };
}
