import { NANOMETRE, VISIBLE } from '../../spectrum/observer/standardObserver.ts';
import { basisAt, residualAt, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT, type LightSpectrum, spectralRadiance } from '../../spectrum/sources/lightSpectrum.ts';

/** Increasing wavelengths of one frame [m], with spectra and filters evaluated at them. */
export class Wavelengths {
  readonly values: readonly number[];
  /** Cached S(λ) of daylight, the spectrum of most sources. */
  private daylight: readonly number[] | undefined;
  private responses: BasisSamples | undefined;

  constructor(values: readonly number[]) {
    this.values = values;
  }

  /** All wavelengths multiplied by s. */
  scaled(s: number): Wavelengths {
    const values = this.values.slice();
    for (let i = 0; i < values.length; i++) values[i] *= s;
    return new Wavelengths(values);
  }

  /** S(λ) [1/m]; empty for line spectra, since no sampled wavelength hits a line. */
  radiance(spectrum: LightSpectrum): readonly number[] {
    if (spectrum.kind === 'lines') return [];
    if (spectrum !== DAYLIGHT) return radiances(this.values, spectrum);
    this.daylight ??= radiances(this.values, DAYLIGHT);
    return this.daylight;
  }

  /** Applies a filter to values at these wavelengths. */
  filtered(values: readonly number[], { rgb: [r, g, b], uv, ir, residual: rest }: SpectralFilter): readonly number[] {
    if (values.length === 0) return values;
    this.responses ??= basisSamplesAt(this.values);
    const { begin, end, red, green, blue } = this.responses;
    const result = values.slice();
    for (let i = 0; i < begin; i++) result[i] *= uv;
    for (let i = begin; i < end; i++) result[i] *= r * red[i] + g * green[i] + b * blue[i];
    for (let i = end; i < result.length; i++) result[i] *= ir;
    if (rest) for (let i = 0; i < result.length; i++) result[i] += values[i] * residualAt(rest, this.values[i]);
    return result;
  }
}

function radiances(
  wavelengths: readonly number[],
  spectrum: Exclude<LightSpectrum, { kind: 'lines' }>,
): readonly number[] {
  const result = wavelengths.slice();
  for (let i = 0; i < result.length; i++) result[i] = spectralRadiance(spectrum, result[i]);
  return result;
}

/** A filter's coefficients at increasing wavelengths: `uv` applies before index `begin`, `ir` from `end` on, the basis functions in between. */
interface BasisSamples {
  readonly begin: number;
  readonly end: number;
  readonly red: readonly number[];
  readonly green: readonly number[];
  readonly blue: readonly number[];
}

/** The basis functions, which are linear between whole nanometres, tabulated over the visible range for lookup without a search. */
const TABLE = Array.from({ length: 471 }, (_, i) => basisAt(VISIBLE[0] + i * NANOMETRE));
const [RED, GREEN, BLUE] = [0, 1, 2].map((k) => Float64Array.from(TABLE, (basis) => basis[k]));

function basisSamplesAt(wavelengths: readonly number[]): BasisSamples {
  const [red, green, blue] = [wavelengths.slice(), wavelengths.slice(), wavelengths.slice()];
  let [begin, end] = [0, 0];
  for (let i = 0; i < wavelengths.length; i++) {
    if (wavelengths[i] < VISIBLE[0]) begin = i + 1;
    if (wavelengths[i] > VISIBLE[1]) break;
    end = i + 1;
    const position = Math.max((wavelengths[i] - VISIBLE[0]) / NANOMETRE, 0);
    const k = Math.min(Math.floor(position), RED.length - 2);
    const t = position - k;
    red[i] = RED[k] + (RED[k + 1] - RED[k]) * t;
    green[i] = GREEN[k] + (GREEN[k + 1] - GREEN[k]) * t;
    blue[i] = BLUE[k] + (BLUE[k + 1] - BLUE[k]) * t;
  }
  return { begin, end, red, green, blue };
}
