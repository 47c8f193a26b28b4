import type { RenderSettings } from '../../scene/view/view.ts';
import { toLinearSrgb } from '../../spectrum/color/observerColor.ts';
import { colorMatching, VISIBLE } from '../../spectrum/observer/standardObserver.ts';
import { reflectanceAt, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { linesOf } from '../../spectrum/sources/lightSpectrum.ts';
import { eachLine, isDark, NO_LIGHT, type RadianceLine, type SampledRadiance, timesValues } from './sampledRadiance.ts';
import type { SourceSpectrum } from './sourceSpectrum.ts';
import type { Sensor, SpectralContext } from './spectralContext.ts';
import { Wavelengths } from './wavelengths.ts';

/** The shares of log D that reach wavelengths and brightness; physical where both are 1. */
type DopplerSettings = Pick<RenderSettings, 'dopplerMix' | 'beaming'>;

/**
 * An eye that asks for light at `count` wavelengths, a power of 2, spread over what it sees and closest where it sees best. `shift` in 0 … 1 moves
 * each within its step; the mean over all shifts is the integral over the wavelength.
 */
export function spectralSensor(shares: DopplerSettings, count: number, shift: number): Sensor {
  const { wavelengths, red, green, blue } = wavelengthSet(count, shift);
  return {
    context: new WavelengthContext(wavelengths, shares),
    color({ values, lines }) {
      let [r, g, b] = [0, 0, 0];
      for (let i = 0; i < values.length; i++) {
        r += red[i] * values[i];
        g += green[i] * values[i];
        b += blue[i] * values[i];
      }
      for (const { wavelength, value } of lines) {
        const seen = toLinearSrgb(colorMatching(wavelength));
        r += seen[0] * value;
        g += seen[1] * value;
        b += seen[2] * value;
      }
      return [r, g, b];
    },
  };
}

/**
 * Light at wavelengths of one frame. What arrives with the shift D was emitted at D λ and has D⁵ of its radiance per wavelength
 * (L_λ′(λ) = D⁵ L_λ(Dλ), docs/physics.md §6.1). The shares m of colours and b of beaming make this D^m λ, and D^m D^(4b): D⁵ for m = b = 1, and
 * of whatever is seen D^(4b) over all wavelengths. Lines come as they are, for the eye to see: none is ever hit by chance.
 */
class WavelengthContext implements SpectralContext {
  private readonly wavelengths: Wavelengths;
  private readonly doppler: DopplerSettings;

  constructor(wavelengths: Wavelengths, shares: DopplerSettings) {
    this.wavelengths = wavelengths;
    this.doppler = shares;
  }

  emitted({ spectrum, filter }: SourceSpectrum): SampledRadiance {
    if (blocksAll(filter)) return NO_LIGHT;
    const lines =
      spectrum.kind === 'lines'
        ? linesOf(spectrum).map(({ wavelength, weight }) => ({ wavelength, value: weight }))
        : NO_LIGHT.lines;
    return this.filtered({ values: this.wavelengths.radiance(spectrum), lines }, filter);
  }

  filtered(light: SampledRadiance, filter: SpectralFilter): SampledRadiance {
    if (isDark(light)) return light;
    const pass = ({ wavelength, value }: RadianceLine): RadianceLine => ({
      wavelength,
      value: value * reflectanceAt(filter, wavelength),
    });
    return { values: this.wavelengths.filtered(light.values, filter), lines: eachLine(light.lines, pass) };
  }

  shifted(D: number): SpectralContext {
    const shift = D ** this.doppler.dopplerMix;
    return shift === 1 ? this : new WavelengthContext(this.wavelengths.scaled(shift), this.doppler);
  }

  received(light: SampledRadiance, D: number, power: number): SampledRadiance {
    if (D === 1 || isDark(light)) return light;
    const { dopplerMix, beaming } = this.doppler;
    const [shift, gain] = [D ** dopplerMix, D ** (power * beaming)];
    const move = ({ wavelength, value }: RadianceLine): RadianceLine => ({
      wavelength: wavelength / shift,
      value: value * gain,
    });
    return { values: timesValues(light.values, shift * gain), lines: eachLine(light.lines, move) };
  }
}

const blocksAll = ({ rgb: [r, g, b], uv, ir, residual: rest }: SpectralFilter): boolean =>
  r === 0 && g === 0 && b === 0 && uv === 0 && ir === 0 && !rest?.share;

/** Wavelengths that the eye asks at, and what it sees of radiance 1 at each, by their step: linear sRGB [m]. */
interface WavelengthSet {
  readonly wavelengths: Wavelengths;
  readonly red: readonly number[];
  readonly green: readonly number[];
  readonly blue: readonly number[];
}

/** All combs together have so many wavelengths; to sum over them all is as good as to integrate. */
const WAVELENGTH_STRATA = 4096;
const wavelengthSets = new Map<number, WavelengthSet>();

/** One of the FINEST/count combs of `count` wavelengths each. They are kept, for at rest everything is seen through them. */
function wavelengthSet(count: number, shift: number): WavelengthSet {
  const first = Math.floor((shift * WAVELENGTH_STRATA) / count);
  const key = first * WAVELENGTH_STRATA + count;
  const known = wavelengthSets.get(key);
  if (known) return known;
  const teeth = Array.from({ length: count }, (_, i) =>
    sampleWavelength((first + 0.5) / WAVELENGTH_STRATA + i / count),
  );
  const seen = teeth.map(({ wavelength, density }) => {
    const step = 1 / (count * density);
    return toLinearSrgb(colorMatching(wavelength)).map((value) => value * step);
  });
  const [red, green, blue] = [0, 1, 2].map((k) => seen.map((rgb) => rgb[k]));
  const made = { wavelengths: new Wavelengths(teeth.map(({ wavelength }) => wavelength)), red, green, blue };
  wavelengthSets.set(key, made);
  return made;
}

/** Density sech²((λ − middle)/width) between the ends of the visible. Source: Radziszewski et al. 2009, "An improved technique for full spectral rendering", J. WSCG 17. */
const SAMPLING_DENSITY = { middle: 538e-9, width: 1 / 0.0072e9 } as const;
const [LOWEST, HIGHEST] = VISIBLE.map((end) => Math.tanh((end - SAMPLING_DENSITY.middle) / SAMPLING_DENSITY.width));

/** The wavelength [m] below which is the part u of the density, and the density there [1/m]. */
function sampleWavelength(u: number): { readonly wavelength: number; readonly density: number } {
  const t = LOWEST + (HIGHEST - LOWEST) * u;
  return {
    wavelength: SAMPLING_DENSITY.middle + SAMPLING_DENSITY.width * Math.atanh(t),
    density: (1 - t * t) / (SAMPLING_DENSITY.width * (HIGHEST - LOWEST)),
  };
}
