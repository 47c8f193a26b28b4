import { int, Loop } from 'three/tsl';
import type * as gpu from '../../shaders/types.ts';
import type { SampledSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import {
  type LightSpectrum,
  linesOf,
  type SpectralLine,
  spectralRadiance,
} from '../../spectrum/sources/lightSpectrum.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import type { LineSource } from './radiance.ts';

/** Lights with more lines are reduced to this number. */
const MAX_LINES = 32;

/** The lines of all line lights, one texel each: (wavelength [nm], radiance, 0, 0). Sampled spectra are approximated by close lines. */
export class LineTable {
  private readonly table: FloatTable;
  private readonly places = new Map<LightSpectrum, readonly [first: number, count: number]>();

  /** `table`: where the texels are stored. */
  constructor(table: FloatTable) {
    this.table = table;
  }

  /** Where a spectrum's lines are, added on first use. */
  add(spectrum: LightSpectrum): readonly [first: number, count: number] {
    const cached = this.places.get(spectrum);
    if (cached) return cached;
    const lines = mergeLines(spectrum);
    const part = this.table.part(lines.length);
    lines.forEach(({ wavelength, weight }, i) => {
      part.set([1e9 * wavelength, weight, 0, 0], i);
    });
    const place = [part.first, lines.length] as const;
    this.places.set(spectrum, place);
    return place;
  }

  source(first: gpu.Float, count: gpu.Float): LineSource {
    return {
      each: (visit) =>
        Loop({ start: int(0), end: int(count), type: 'int', condition: '<' }, ({ i }) => {
          const line = this.table.texel(int(first).add(int(i))).toVar();
          visit(line.x.mul(1e-9), line.y);
        }),
    };
  }
}

/** At most MAX_LINES lines, each at the centroid of the lines that it replaces. */
function mergeLines(spectrum: LightSpectrum): readonly SpectralLine[] {
  if (spectrum.kind === 'thermal') return [];
  const lines = spectrum.kind === 'lines' ? linesOf(spectrum) : samplesOf(spectrum);
  if (lines.length <= MAX_LINES) return lines;
  const rising = [...lines].sort((a, b) => a.wavelength - b.wavelength);
  const [minWavelength, maxWavelength] = [rising[0].wavelength, rising[rising.length - 1].wavelength];
  const sums = Array.from({ length: MAX_LINES }, () => ({ weight: 0, moment: 0 }));
  for (const { wavelength, weight } of rising) {
    const sum =
      sums[
        Math.min(
          MAX_LINES - 1,
          Math.floor((MAX_LINES * (wavelength - minWavelength)) / (maxWavelength - minWavelength)),
        )
      ];
    sum.weight += weight;
    sum.moment += weight * wavelength;
  }
  return sums.flatMap(({ weight, moment }) => (weight > 0 ? [{ wavelength: moment / weight, weight }] : []));
}

const samplesOf = (spectrum: SampledSpectrum): readonly SpectralLine[] =>
  spectrum.values.map((_, i) => {
    const wavelength = spectrum.first + i * spectrum.step;
    return { wavelength, weight: spectralRadiance(spectrum, wavelength) * spectrum.step };
  });
