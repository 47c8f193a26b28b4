import type { RenderSettings } from '../../scene/view/view.ts';
import { toLinearSrgb } from '../../spectrum/color/observerColor.ts';
import { colorMatching, VISIBLE } from '../../spectrum/observer/standardObserver.ts';
import { reflectanceAt, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { linesOf } from '../../spectrum/sources/lightSpectrum.ts';
import { eachLine, isDark, NO_LIGHT, type RadianceLine, type SampledRadiance, timesValues } from './sampledRadiance.ts';
import type { SourceSpectrum } from './sourceSpectrum.ts';
import type { Sensor, SpectralContext } from './spectralContext.ts';
import { Wavelengths } from './wavelengths.ts';

/** Factors of log D for wavelengths and for brightness; physical if both are 1. */
type DopplerSettings = Pick<RenderSettings, 'dopplerMix' | 'beaming'>;

/**
 * A sensor that samples light at `count` wavelengths, a power of 2, over the visible range, densest where vision is most sensitive. `shift` in 0 … 1
 * moves each wavelength within its stratum; the mean over all shifts is the integral over the wavelength. docs/physics.md §7.11.
 */
export function spectralSensor(settings: DopplerSettings, count: number, shift: number): Sensor {
  const { wavelengths, red, green, blue } = wavelengthSet(count, shift);
  return {
    context: new WavelengthContext(wavelengths, settings),
    color({ values, lines }) {
      let [r, g, b] = [0, 0, 0];
      for (let i = 0; i < values.length; i++) {
        r += red[i] * values[i];
        g += green[i] * values[i];
        b += blue[i] * values[i];
      }
      for (const { wavelength, value } of lines) {
        const response = toLinearSrgb(colorMatching(wavelength));
        r += response[0] * value;
        g += response[1] * value;
        b += response[2] * value;
      }
      return [r, g, b];
    },
  };
}

/**
 * Light at wavelengths of one frame. Light that arrives with the shift D was emitted at D λ, and its radiance per wavelength is multiplied by D⁵
 * (L_λ′(λ) = D⁵ L_λ(Dλ), docs/physics.md §6.1). The settings m (`dopplerMix`) and b (`beaming`) change this to D^m λ and D^m D^(4b): D⁵ for
 * m = b = 1, and D^(4b) of the integrated radiance. Lines are passed on separately, because no sampled wavelength would ever hit one.
 */
class WavelengthContext implements SpectralContext {
  private readonly wavelengths: Wavelengths;
  private readonly doppler: DopplerSettings;

  constructor(wavelengths: Wavelengths, settings: DopplerSettings) {
    this.wavelengths = wavelengths;
    this.doppler = settings;
  }

  emitted({ spectrum, filter }: SourceSpectrum): SampledRadiance {
    if (blocksAll(filter)) return NO_LIGHT;
    const lines =
      spectrum.kind === 'lines'
        ? linesOf(spectrum).map(({ wavelength, weight }) => ({ wavelength, value: weight }))
        : NO_LIGHT.lines;
    return this.filtered({ values: this.wavelengths.radiance(spectrum), lines }, filter);
  }

  together(light: SampledRadiance): SampledRadiance {
    return light;
  }

  filtered(light: SampledRadiance, filter: SpectralFilter): SampledRadiance {
    if (isDark(light)) return light;
    const pass = ({ wavelength, value }: RadianceLine): RadianceLine => ({
      wavelength,
      value: value * reflectanceAt(filter, wavelength),
    });
    return { values: this.wavelengths.filtered(light.values, filter), lines: eachLine(light.lines, pass) };
  }

  absorbed(light: SampledRadiance, filter: SpectralFilter, x: number): SampledRadiance {
    if (isDark(light)) return light;
    const passed = light.values.map((value, i) => value * reflectanceAt(filter, this.samples[i]) ** x);
    const pass = ({ wavelength, value }: RadianceLine): RadianceLine => ({
      wavelength,
      value: value * reflectanceAt(filter, wavelength) ** x,
    });
    return { values: passed, lines: eachLine(light.lines, pass) };
  }

  get samples(): readonly number[] {
    return this.wavelengths.values;
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

/** The sampled wavelengths, and the sensor's response to radiance 1 at each times the wavelength step: linear sRGB [m]. */
interface WavelengthSet {
  readonly wavelengths: Wavelengths;
  readonly red: readonly number[];
  readonly green: readonly number[];
  readonly blue: readonly number[];
}

/** Number of wavelengths in all combs together; the sum over all of them is as good as the integral. */
const WAVELENGTH_STRATA = 4096;
const wavelengthSets = new Map<number, WavelengthSet>();

/** One of the WAVELENGTH_STRATA/count combs of `count` wavelengths each; cached, since all light at rest is sampled with them. */
function wavelengthSet(count: number, shift: number): WavelengthSet {
  const first = Math.floor((shift * WAVELENGTH_STRATA) / count);
  const key = first * WAVELENGTH_STRATA + count;
  const cached = wavelengthSets.get(key);
  if (cached) return cached;
  const samples = Array.from({ length: count }, (_, i) =>
    sampleWavelength((first + 0.5) / WAVELENGTH_STRATA + i / count),
  );
  const response = samples.map(({ wavelength, density }) => {
    const step = 1 / (count * density);
    return toLinearSrgb(colorMatching(wavelength)).map((value) => value * step);
  });
  const [red, green, blue] = [0, 1, 2].map((k) => response.map((rgb) => rgb[k]));
  const set = { wavelengths: new Wavelengths(samples.map(({ wavelength }) => wavelength)), red, green, blue };
  wavelengthSets.set(key, set);
  return set;
}

/** Density sech²((λ − middle)/width) over the visible range. Source: Radziszewski et al. 2009, "An improved technique for full spectral rendering", J. WSCG 17. */
const SAMPLING_DENSITY = { middle: 538e-9, width: 1 / 0.0072e9 } as const;
const [LOWEST, HIGHEST] = VISIBLE.map((end) => Math.tanh((end - SAMPLING_DENSITY.middle) / SAMPLING_DENSITY.width));

/** The wavelength [m] at the quantile u of the density, and the density there [1/m]. */
function sampleWavelength(u: number): { readonly wavelength: number; readonly density: number } {
  const t = LOWEST + (HIGHEST - LOWEST) * u;
  return {
    wavelength: SAMPLING_DENSITY.middle + SAMPLING_DENSITY.width * Math.atanh(t),
    density: (1 - t * t) / (SAMPLING_DENSITY.width * (HIGHEST - LOWEST)),
  };
}
