import { NANOMETRE } from '../observer/standardObserver.ts';
import { FL2, FL11, HP1, LED_B3 } from '../tables/lamps.ts';
import { daylightSpectrum } from './daylight.ts';
import {
  DAYLIGHT,
  type LightSpectrum,
  type LineSpectrum,
  type SampledSpectrum,
  type ThermalSpectrum,
} from './lightSpectrum.ts';

/** A named spectrum with a short description. */
export interface LightPreset {
  /** What it is, for people. */
  readonly about: string;
  /** Its relative spectrum, at rest. */
  readonly spectrum: LightSpectrum;
}

const thermal = (temperature: number): ThermalSpectrum => ({ kind: 'thermal', temperature });
/** A lamp of the CIE tables, 380…780 nm in steps of 5 nm. */
const lamp = (values: readonly number[]): SampledSpectrum => ({
  kind: 'sampled',
  first: 380 * NANOMETRE,
  step: 5 * NANOMETRE,
  values,
});
/** Lines given as (wavelength [nm], relative radiance). */
const lines = (...all: readonly (readonly [nanometres: number, weight: number])[]): LineSpectrum => ({
  kind: 'lines',
  lines: all.map(([nanometres, weight]) => ({ wavelength: nanometres * NANOMETRE, weight })),
});

/**
 * Spectra of common lights. Wavelengths of lines are in air (below 200 nm in vacuum), from the NIST Atomic Spectra
 * Database, version 5; in air they are 0.03 % shorter. Relative strengths vary between lamps; these are typical.
 * @example
 * LIGHT_PRESETS.get('sodium')!.spectrum.kind; // 'lines'
 */
export const LIGHT_PRESETS: ReadonlyMap<string, LightPreset> = new Map([
  ['daylight', { about: 'a blackbody of 6504 K, white', spectrum: DAYLIGHT }],
  ['d65', { about: 'measured daylight, CIE D65 (300…830 nm)', spectrum: daylightSpectrum(6504) }],
  ['candle', { about: 'a blackbody of 1850 K', spectrum: thermal(1850) }],
  ['tungsten', { about: 'a light bulb, CIE A: a blackbody of 2856 K', spectrum: thermal(2856) }],
  ['blue-star', { about: 'a blackbody of 20,000 K', spectrum: thermal(20_000) }],
  ['fluorescent', { about: 'a cool white tube, CIE FL2 (380…780 nm)', spectrum: lamp(FL2) }],
  ['triphosphor', { about: 'a tube of three narrow bands, CIE FL11 (380…780 nm)', spectrum: lamp(FL11) }],
  ['led', { about: 'a white LED, CIE LED-B3 (380…780 nm)', spectrum: lamp(LED_B3) }],
  ['street-sodium', { about: 'high-pressure sodium, CIE HP1 (380…780 nm)', spectrum: lamp(HP1) }],
  ['sodium', { about: 'low-pressure sodium: the D lines, nearly alone', spectrum: lines([588.995, 2], [589.5924, 1]) }],
  [
    'mercury',
    {
      about: 'mercury vapour at medium pressure, with its ultraviolet',
      // Visible lines as measured of a clear lamp (H38HT-100, NIST Color Quality Scale 7.4), the others relative to 546 nm, rounded.
      spectrum: lines(
        [253.6517, 0.25],
        [313.1555, 0.55],
        [365.0153, 1],
        [404.6563, 0.44],
        [435.8328, 0.83],
        [546.0735, 1],
        [576.9598, 0.45],
        [579.0663, 0.45],
        [1013.975, 0.4],
      ),
    },
  ],
  [
    'hydrogen',
    {
      about: 'a glowing nebula: hydrogen from the ultraviolet Lyman α to the infrared Brackett α',
      // Recombination at 10,000 K, case B (opaque to the higher Lyman lines), relative to Hβ. Source:
      // Osterbrock & Ferland 2006, "Astrophysics of Gaseous Nebulae", table 4.4.
      spectrum: lines(
        [121.567, 25],
        [410.1734, 0.259],
        [434.0472, 0.468],
        [486.135, 1],
        [656.279, 2.86],
        [1093.81, 0.0904],
        [1281.807, 0.163],
        [1875.101, 0.339],
        [4051.2, 0.0805],
      ),
    },
  ],
]);
