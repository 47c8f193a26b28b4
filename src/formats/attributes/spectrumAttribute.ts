import { listed, type Message, msg } from '../../messages/message.ts';
import { LIGHT_PRESETS } from '../../spectrum/sources/lightPresets.ts';
import type { LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';

/** Slowlight's attribute or extra of a light: its spectrum. */
export const SPECTRUM_ATTRIBUTE = 'slowlight:spectrum';

/** Accepted colour temperatures [K]. */
const TEMPERATURE_RANGE = [1, 1e9] as const;

/** A spectrum as files write it: the name of a preset, or a blackbody's temperature, `2856 K`; undefined where it is neither. */
export function parseSpectrum(written: string): LightSpectrum | undefined {
  const preset = LIGHT_PRESETS.get(written);
  if (preset) return preset.spectrum;
  const [, number] = /^\s*(\d[\d.]*(?:e\d+)?)\s*K\s*$/i.exec(written) ?? [];
  return number === undefined ? undefined : thermalSpectrum(Number(number));
}

/** A blackbody; undefined where the temperature [K] is none, or out of range. */
export const thermalSpectrum = (temperature: number): LightSpectrum | undefined =>
  temperature >= TEMPERATURE_RANGE[0] && temperature <= TEMPERATURE_RANGE[1]
    ? { kind: 'thermal', temperature }
    : undefined;

/** As `parseSpectrum` reads it; undefined of a spectrum that has no name. */
export function formatSpectrum(spectrum: LightSpectrum): string | undefined {
  if (spectrum.kind === 'thermal') return `${spectrum.temperature} K`;
  const text = JSON.stringify(spectrum);
  return [...LIGHT_PRESETS].find(([, preset]) => JSON.stringify(preset.spectrum) === text)?.[0];
}

/** Message for an unknown spectrum. */
export const unknownSpectrumMessage = (written: string): Message =>
  msg`${SPECTRUM_ATTRIBUTE} "${written.slice(0, 40)}" is neither a temperature, as "2856 K", nor one of ${listed([...LIGHT_PRESETS.keys()])}; it is left out`;
