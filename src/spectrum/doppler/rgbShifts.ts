import type { Vec3 } from '../../math/vec3.ts';
import { dopplerTint } from './dopplerTint.ts';
import { linearSpectrumShift, twoWavelengthShift } from './historicalShifts.ts';

/** Colour modes without spectra: light is linear sRGB, and a Doppler shift by D^mix changes its colour, without the D⁴ of beaming. */
export const RGB_SHIFTS = {
  approximate: dopplerTint,
  'two-wavelengths': twoWavelengthShift,
  'linear-spectrum': linearSpectrumShift,
} as const satisfies Readonly<Record<string, (rgb: Vec3, D: number, mix: number) => Vec3>>;
/** Shifts below this change no pixel, and most surfaces are at rest: colours are left as they are at rest. */
export const MIN_SHIFT = 1e-5;

/** Modes whose shift of a sum is not the sum of the shifts: what each light sends to a surface or to the eye is shifted by itself. */
export const SHIFTS_EACH_LIGHT: readonly RgbColorMode[] = ['two-wavelengths'];
export type RgbColorMode = keyof typeof RGB_SHIFTS;
export const RGB_COLOR_MODES = Object.keys(RGB_SHIFTS) as readonly RgbColorMode[];
