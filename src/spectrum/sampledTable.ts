import { NANOMETRE, VISIBLE, WAVELENGTHS } from './cie1931.ts';
import { type DopplerTable, doppleredColors } from './dopplerTable.ts';
import { meanRadiance, type SampledSpectrum } from './lightSpectrum.ts';

/** The table of one sampled spectrum; its rows are over the whole shift D = D_in·D_out, evenly in log₂ D. */
export interface SampledTable extends DopplerTable {
  /** log₂ D of the first row, where the spectrum has gone into the infrared. There, as at the last row, all is dark. */
  readonly first: number;
  /** log₂ D from row to row. */
  readonly step: number;
}

/** 3 nm between two columns, less than for blackbodies: narrow bands show where the basis bends. */
const SAMPLED_COLUMNS = 289;
/** 3 nm between two rows too, */
const ROWS_PER_OCTAVE = 128;
/** but for spectra that reach far. */
const MOST_ROWS = 1024;

/** Row of a whole shift D, 0…rows − 1 in the middles of texels. D = 1 is a row, if light is seen at rest. */
export const shiftRowOf = ({ first, step, rows }: SampledTable, D: number): number =>
  Math.min(Math.max((Math.log2(D) - first) / step, 0), rows - 1);

/**
 * The table of a sampled spectrum of luminance 1 over D = D_in·D_out (`shiftRowOf`) and D_out (`columnOf`). Unlike that of blackbodies it
 * holds the luminance that is left, without the D⁴ of beaming: it is `seenColor` itself.
 */
export function sampledTable(spectrum: SampledSpectrum, layers: 3 | 4, columns = SAMPLED_COLUMNS): SampledTable {
  const longest = spectrum.first + spectrum.step * (spectrum.values.length - 1);
  const lowest = Math.log2(spectrum.first / VISIBLE[1]);
  const highest = Math.log2(longest / VISIBLE[0]);
  const step = Math.max(1 / ROWS_PER_OCTAVE, (highest - lowest) / (MOST_ROWS - 2));
  const [from, to] = [Math.floor(lowest / step), Math.ceil(highest / step)];
  const lights = Array.from({ length: to - from + 1 }, (_, row) => shiftedLight(spectrum, 2 ** ((from + row) * step)));
  return { ...doppleredColors(lights, layers, columns), first: from * step, step };
}

/** D⁵ S(Dλ)/D⁴ at each nanometre. */
const shiftedLight = (spectrum: SampledSpectrum, D: number) => ({
  radiance: WAVELENGTHS.map((wavelength) => D * meanRadiance(spectrum, D * wavelength, D * NANOMETRE)),
  H: 0,
});
