import type { ChoiceParam, ColorParam, NumberParam, TextParam } from '../../graph/nodeType.ts';
import { LIGHT_PRESETS } from '../../spectrum/lightPresets.ts';
import type { LightSpectrum } from '../../spectrum/lightSpectrum.ts';
import { pathOf } from '../geometry/primitive.ts';

/** What a thing is called in the scene: `/name`. */
export const nameParam = (value: string): TextParam => ({
  kind: 'text',
  title: 'param.name',
  help: 'param.name.help',
  default: value,
});

/** Of a white surface that it shines on, at rest. */
export const lightColor: ColorParam = { kind: 'color', title: 'param.lightColor', default: [1, 1, 1] };

export const brightness = (title: string, value: number): NumberParam => ({
  kind: 'number',
  title,
  help: 'param.brightness.help',
  default: value,
  min: 0,
  max: 1e9,
  step: 0.1,
  slider: false,
});

/** What light is made of; a spectrum that is connected comes before it. */
export const madeOf: ChoiceParam = {
  kind: 'choice',
  title: 'param.madeOf',
  help: 'param.madeOf.help',
  default: 'daylight',
  options: [...LIGHT_PRESETS.keys()].map((name) => ({ value: name, title: `light.${name}` })),
};

/** Path and spectrum of a light; without one where it is daylight, for then its colour tells (spectrum/lightColor.ts). */
export function lightOf(name: string, node: string, preset: string, given?: LightSpectrum) {
  const spectrum = given ?? (preset === madeOf.default ? undefined : LIGHT_PRESETS.get(preset)?.spectrum);
  return { path: pathOf(name, node), ...(spectrum && { spectrum }) };
}
