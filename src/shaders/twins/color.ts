import { vec4 } from 'three/tsl';
import type { ToneMapping } from '../../spectrum/display/toneMap.ts';
import * as spectrum from '../../spectrum/index.ts';
import { dopplerTint } from '../color/dopplerTint.ts';
import { glowColor } from '../color/glowColor.ts';
import { linearSpectrumShift, twoWavelengthShift } from '../color/historicalShifts.ts';
import { toneMapAgx, toneMapLinear, toneMapNeutral } from '../color/toneMap.ts';
import { absolute, always } from './checks.ts';
import { casesOf, logUniform, vec3At } from './inputs.ts';
import type { Twin } from './twin.ts';

const dopplerTintTwin: Twin = {
  name: 'dopplerTint',
  texels: 2,
  outputs: 1,
  cases: (random) => [
    ...casesOf([{ name: 'D 1e-3 … 2000', gamma: 1 }], 300, () => [
      random(),
      random(),
      random(),
      logUniform(random, 1e-3, 2000),
      random(),
      0,
      0,
      0,
    ]),
    ...casesOf([{ name: 'D near 1', gamma: 1 }], 300, () => [
      random(),
      random(),
      random(),
      logUniform(random, 0.4, 3),
      1,
      0,
      0,
      0,
    ]),
    ...casesOf([{ name: 'D = 1', gamma: 1 }], 30, () => [random(), random(), random(), 1, 1, 0, 0, 0]),
  ],
  cpu: (input) => [...spectrum.dopplerTint(vec3At(input, 0), input[3], input[4]), 0],
  gpu: (texel) => [vec4(dopplerTint(texel(0).xyz, texel(0).w, texel(1).x), 0)],
  checks: [absolute('rgb', 0, 3, always(5e-5))],
};

const glowColorTwin: Twin = {
  name: 'glowColor',
  texels: 1,
  outputs: 1,
  cases: (random) =>
    casesOf([{ name: '300 … 40,000 K', gamma: 1 }], 300, () => [logUniform(random, 300, 40_000), 0, 0, 0]),
  cpu: (input) => [...spectrum.glowColor(input[0]), 0],
  gpu: (texel) => [vec4(glowColor(texel(0).x), 0)],
  checks: [absolute('rgb', 0, 3, always(2e-5))],
};

const toneMapTwin = (name: string, tone: ToneMapping, gpu: typeof toneMapNeutral): Twin => ({
  name,
  texels: 2,
  outputs: 1,
  cases: (random) =>
    casesOf([{ name: 'radiance to 1e6, exposure ±6 EV', gamma: 1 }], 600, () => {
      const level = logUniform(random, 1e-3, 1e6);
      return [random() * level, random() * level, random() * level - 1e-3, 0, 12 * random() - 6, 0, 0, 0];
    }),
  cpu: (input) => [...spectrum.toneMap(vec3At(input, 0), input[4], tone), 0],
  gpu: (texel) => [vec4(gpu(texel(0).xyz, texel(1).x), 0)],
  checks: [absolute('rgb', 0, 3, always(tone === 'agx' ? 5e-5 : 1e-5))],
});

const historicalTwin = (
  name: 'twoWavelengthShift' | 'linearSpectrumShift',
  cpu: typeof spectrum.twoWavelengthShift,
  gpu: typeof twoWavelengthShift,
  error: number,
): Twin => ({
  name,
  texels: 2,
  outputs: 1,
  cases: (random) =>
    casesOf([{ name: 'D 0.3 … 3', gamma: 1 }], 400, () => [
      ...[random(), random(), random(), logUniform(random, 0.3, 3)],
      ...[random(), 0, 0, 0],
    ]),
  cpu: (input) => [...cpu(vec3At(input, 0), input[3], input[4]), 0],
  gpu: (texel) => [vec4(gpu(texel(0).xyz, texel(0).w, texel(1).x), 0)],
  checks: [absolute('rgb', 0, 3, always(error))],
});

export const colorTwins: readonly Twin[] = [
  dopplerTintTwin,
  historicalTwin('twoWavelengthShift', spectrum.twoWavelengthShift, twoWavelengthShift, 1e-3),
  historicalTwin('linearSpectrumShift', spectrum.linearSpectrumShift, linearSpectrumShift, 1e-4),
  glowColorTwin,
  toneMapTwin('toneMapNeutral', 'neutral', toneMapNeutral),
  toneMapTwin('toneMapAgx', 'agx', toneMapAgx),
  toneMapTwin('toneMapLinear', 'linear', toneMapLinear),
];
