import { LIGHT_PRESETS } from '../spectrum/lightPresets.ts';
import type { LightSpectrum } from '../spectrum/lightSpectrum.ts';

/** Our own attribute or extra of a light: what its light is made of. */
export const SPECTRUM_HINT = 'slowlight:spectrum';

/** Temperatures of lights that are read [K]. */
const TEMPERATURES = [1, 1e9] as const;

/** A spectrum as files write it: the name of a preset, or a blackbody's temperature, `2856 K`; undefined where it is neither. */
export function spectrumFrom(written: string): LightSpectrum | undefined {
  const preset = LIGHT_PRESETS.get(written);
  if (preset) return preset.spectrum;
  const [, number] = /^\s*(\d[\d.]*(?:e\d+)?)\s*K\s*$/i.exec(written) ?? [];
  return number === undefined ? undefined : thermalSpectrum(Number(number));
}

/** A blackbody; undefined where the temperature [K] is none, or out of range. */
export const thermalSpectrum = (temperature: number): LightSpectrum | undefined =>
  temperature >= TEMPERATURES[0] && temperature <= TEMPERATURES[1] ? { kind: 'thermal', temperature } : undefined;

/** As `spectrumFrom` reads it; undefined of a spectrum that has no name. */
export function spectrumText(spectrum: LightSpectrum): string | undefined {
  if (spectrum.kind === 'thermal') return `${spectrum.temperature} K`;
  const text = JSON.stringify(spectrum);
  return [...LIGHT_PRESETS].find(([, preset]) => JSON.stringify(preset.spectrum) === text)?.[0];
}

/** What is said of a text that names no spectrum. */
export const unknownSpectrum = (written: string): string =>
  `${SPECTRUM_HINT} "${written.slice(0, 40)}" is neither a temperature, as "2856 K", nor one of ${[...LIGHT_PRESETS.keys()].join(', ')}; it is left out`;
