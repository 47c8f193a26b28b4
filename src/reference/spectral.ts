import type { RenderSettings } from '../scene/view.ts';
import { type Bands, reflectanceAt } from '../spectrum/bands.ts';
import { colorMatching, VISIBLE } from '../spectrum/cie1931.ts';
import { linesOf } from '../spectrum/lightSpectrum.ts';
import { toLinearSrgb } from '../spectrum/observerColor.ts';
import { DARK, eachLine, isDark, type Light, type Line, timesValues } from './light.ts';
import type { Shine } from './shine.ts';
import type { Eye, Sight } from './sight.ts';
import { Wavelengths } from './wavelengths.ts';

/** The shares of log D that reach wavelengths and brightness; physical where both are 1. */
type Shares = Pick<RenderSettings, 'dopplerMix' | 'beaming'>;

/**
 * An eye that asks for light at `count` wavelengths, a power of 2, spread over what it sees and closest where it sees best. `shift` in 0 … 1 moves
 * each within its step; the mean over all shifts is the integral over the wavelength.
 */
export function spectralEye(shares: Shares, count: number, shift: number): Eye {
  const { wavelengths, red, green, blue } = comb(count, shift);
  return {
    sight: new SpectralSight(wavelengths, shares),
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
 * (L_λ′(λ) = D⁵ L_λ(Dλ), physics.md). The shares m of colours and b of beaming make this D^m λ, and D^m D^(4b): D⁵ for m = b = 1, and
 * of whatever is seen D^(4b) over all wavelengths. Lines come as they are, for the eye to see: none is ever hit by chance.
 */
class SpectralSight implements Sight {
  private readonly wavelengths: Wavelengths;
  private readonly shares: Shares;

  constructor(wavelengths: Wavelengths, shares: Shares) {
    this.wavelengths = wavelengths;
    this.shares = shares;
  }

  shining({ spectrum, filter }: Shine): Light {
    if (isOpaque(filter)) return DARK;
    const lines =
      spectrum.kind === 'lines'
        ? linesOf(spectrum).map(({ wavelength, weight }) => ({ wavelength, value: weight }))
        : DARK.lines;
    return this.filtered({ values: this.wavelengths.radiance(spectrum), lines }, filter);
  }

  filtered(light: Light, filter: Bands): Light {
    if (isDark(light)) return light;
    const pass = ({ wavelength, value }: Line): Line => ({
      wavelength,
      value: value * reflectanceAt(filter, wavelength),
    });
    return { values: this.wavelengths.filtered(light.values, filter), lines: eachLine(light.lines, pass) };
  }

  through(D: number): Sight {
    const shift = D ** this.shares.dopplerMix;
    return shift === 1 ? this : new SpectralSight(this.wavelengths.times(shift), this.shares);
  }

  arrived(light: Light, D: number, power: number): Light {
    if (D === 1 || isDark(light)) return light;
    const { dopplerMix, beaming } = this.shares;
    const [shift, gain] = [D ** dopplerMix, D ** (power * beaming)];
    const move = ({ wavelength, value }: Line): Line => ({ wavelength: wavelength / shift, value: value * gain });
    return { values: timesValues(light.values, shift * gain), lines: eachLine(light.lines, move) };
  }
}

const isOpaque = ({ rgb: [r, g, b], uv, ir, rest }: Bands): boolean =>
  r === 0 && g === 0 && b === 0 && uv === 0 && ir === 0 && !rest?.share;

/** Wavelengths that the eye asks at, and what it sees of radiance 1 at each, by their step: linear sRGB [m]. */
interface Comb {
  readonly wavelengths: Wavelengths;
  readonly red: readonly number[];
  readonly green: readonly number[];
  readonly blue: readonly number[];
}

/** All combs together have so many wavelengths; to sum over them all is as good as to integrate. */
const FINEST = 4096;
const combs = new Map<number, Comb>();

/** One of the FINEST/count combs of `count` wavelengths each. They are kept, for at rest everything is seen through them. */
function comb(count: number, shift: number): Comb {
  const first = Math.floor((shift * FINEST) / count);
  const key = first * FINEST + count;
  const known = combs.get(key);
  if (known) return known;
  const teeth = Array.from({ length: count }, (_, i) => tooth((first + 0.5) / FINEST + i / count));
  const seen = teeth.map(({ wavelength, density }) => {
    const step = 1 / (count * density);
    return toLinearSrgb(colorMatching(wavelength)).map((value) => value * step);
  });
  const [red, green, blue] = [0, 1, 2].map((k) => seen.map((rgb) => rgb[k]));
  const made = { wavelengths: new Wavelengths(teeth.map(({ wavelength }) => wavelength)), red, green, blue };
  combs.set(key, made);
  return made;
}

/** Density sech²((λ − middle)/width) between the ends of the visible. Source: Radziszewski et al. 2009, "An improved technique for full spectral rendering", J. WSCG 17. */
const SEEN = { middle: 538e-9, width: 1 / 0.0072e9 } as const;
const [LOWEST, HIGHEST] = VISIBLE.map((end) => Math.tanh((end - SEEN.middle) / SEEN.width));

/** The wavelength [m] below which is the part u of the density, and the density there [1/m]. */
function tooth(u: number): { readonly wavelength: number; readonly density: number } {
  const t = LOWEST + (HIGHEST - LOWEST) * u;
  return {
    wavelength: SEEN.middle + SEEN.width * Math.atanh(t),
    density: (1 - t * t) / (SEEN.width * (HIGHEST - LOWEST)),
  };
}
