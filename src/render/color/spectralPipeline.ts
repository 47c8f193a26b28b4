import { abs, clamp, dot, exp2, float, If, log2, max, select, vec3, vec4 } from 'three/tsl';
import { lineColor } from '../../shaders/color/lineColor.ts';
import type { SkyPartNodes } from '../../shaders/color/skyParts.ts';
import type { HalfTable } from '../../shaders/tables/halfAtlas.ts';
import {
  type BandColors,
  coloredColors,
  filteredColor,
  luminanceOf,
  type SpectrumTable,
  thermalColors,
} from '../../shaders/tables/spectrumTable.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { SHIFT_LIMIT } from '../../spectrum/doppler/dopplerTable.ts';
import type { FilteredBlackbody } from '../../spectrum/doppler/filterPairs.ts';
import { MIN_SHIFT } from '../../spectrum/doppler/rgbShifts.ts';
import { BASIS_ENDS } from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import type { DaylightTable } from './daylightTable.ts';
import { overlapSum } from './overlapSum.ts';
import {
  type BeamingPower,
  type ColorPipeline,
  type LineSource,
  RADIANCE_POWER,
  type SpectralFilterNodes,
  type ThermalSource,
} from './radiance.ts';
import { decomposeSky, skySums } from './skySums.ts';

/** Range of shifts that colours follow: below it everything is dark, above it colours no longer change. */
const SHIFT_RANGE = [1e-3, 1e6] as const;

export interface SpectralTables {
  readonly blackbodies: SpectrumTable;
  /** The same for light that was daylight at rest, where light and filter are shifted together. */
  readonly daylight: DaylightTable;
  /** The coloured lights; and the table of each of them. */
  readonly lights: readonly FilteredBlackbody[];
  readonly colored: (light: number) => SpectrumTable;
  readonly observer: () => HalfTable;
}

/** What a scene contains. */
export interface SpectralOptions {
  /** Surfaces that glow by their temperature. */
  readonly glowing: boolean;
  /** A sky that may be red, and not only blue. */
  readonly reddenedSky: boolean;
  /** The whole shift applies to colours and brightness. */
  readonly fullShift: boolean;
}

interface FrequencyShift {
  /** D, as far as colours follow it (`dopplerMix`). */
  readonly mixed: Float;
  /** D^power, as far as brightness follows it (`beaming`). */
  brightness(power: BeamingPower): Float;
}

/**
 * Colours by spectra, from the table of blackbodies (docs/adr/0010-spectra.md). Daylight that is reflected by a resting surface is summed in bands, and
 * converted to colours once; for coloured lights the overlaps of the bands are summed too, because two filters in a row are no filter of the three bands.
 * Light that arrives shifted is converted by itself: it is a blackbody of T·D_in·D_out, seen through the surface's filter shifted by D_out; coloured lights
 * have tables of their own. Line spectra are converted line by line. The light of a sky is summed for each of the lights that it is composed of; if it
 * arrives shifted, it is converted channel by channel, relative to white daylight. The table has four layers if some surface specifies its ultraviolet or
 * infrared.
 */
export const spectralPipeline =
  (
    { blackbodies, daylight: daylightTable, lights, colored: coloredTables, observer }: SpectralTables,
    { glowing, reddenedSky, fullShift: wholeShift }: SpectralOptions,
  ): ColorPipeline =>
  (D, uniforms) => {
    const hasInvisible = blackbodies.layers === 4;
    const shiftOf = (D: Float): FrequencyShift => {
      if (wholeShift) return fullFrequencyShift(D);
      const log = log2(max(D, 1e-20)).toVar();
      const mixed = clamp(exp2(log.mul(uniforms.dopplerMix)), ...SHIFT_RANGE).toVar();
      return { mixed, brightness: (power) => exp2(log.mul(uniforms.beaming.mul(power))) };
    };
    const out = shiftOf(D);
    const daylight = vec4(0).toVar();
    const sky = skySums(reddenedSky, daylightTable);
    const sum = vec3(0).toVar();
    const overlapping = overlapSum();
    const ofColor = (rgb: Vec3, shift: Float): SpectralFilterNodes =>
      hasInvisible
        ? vec4(rgb, dot(rgb, select(shift.lessThan(1), vec3(...BASIS_ENDS.uv), vec3(...BASIS_ENDS.ir))))
        : vec4(rgb, 0);

    const unshifted = (filter: SpectralFilterNodes, { temperature, luminance }: ThermalSource): Vec3 => {
      const T = temperature.mul(out.mixed).toVar();
      const colors = thermalColors(blackbodies, T, out.mixed);
      return filteredColor(colors, filter).mul(gain(colors.G, T, luminance, out.mixed));
    };

    const parts = (light: Vec3): SkyPartNodes => decomposeSky(light, reddenedSky);

    /** Light of a blackbody behind a coloured filter that arrives shifted. */
    const filteredTwice = (
      light: number,
      k: Vec3,
      reflectance: SpectralFilterNodes,
      shift: Float,
      thermalSource?: ThermalSource,
    ): Vec3 => {
      const whole = clamp(out.mixed.mul(shift), ...SHIFT_RANGE).toVar();
      const T = whole.mul(thermalSource?.temperature ?? DAYLIGHT.temperature).toVar();
      const [seen, G] = [vec3(0).toVar(), float(0).toVar()];
      const add = (colors: BandColors, strength: Float): void => {
        seen.assign(filteredColor(colors, reflectance).mul(strength));
        G.assign(colors.G);
      };
      If(whole.greaterThan(1 / SHIFT_LIMIT).and(whole.lessThan(SHIFT_LIMIT)), () => {
        add(coloredColors(coloredTables(light), whole, out.mixed), max(k.x, max(k.y, k.z)));
      }).Else(() => {
        // Outside this range only one end of the light's own filter is visible.
        const end = select(whole.lessThan(1), dot(k, vec3(...BASIS_ENDS.uv)), dot(k, vec3(...BASIS_ENDS.ir)));
        add(thermalColors(blackbodies, T, out.mixed), end);
      });
      return seen.mul(gain(G, T, thermalSource?.luminance ?? float(1), whole));
    };

    /** The same for light that reaches a surface unshifted. */
    const filteredAtRest = (
      light: number,
      k: Vec3,
      reflectance: SpectralFilterNodes,
      { temperature, luminance }: ThermalSource,
    ): Vec3 => {
      const colors = daylightTable.colored(light, lights[light], out.mixed);
      const strength = gain(colors.G, temperature.mul(out.mixed), luminance, out.mixed);
      return filteredColor(colors, reflectance).mul(strength.mul(max(k.x, max(k.y, k.z))));
    };

    /** Neutral light that arrives shifted. */
    const neutral = (
      strength: Float,
      reflectance: SpectralFilterNodes,
      shift: Float,
      thermalSource: ThermalSource | undefined,
    ): Vec3 => {
      const whole = clamp(out.mixed.mul(shift), ...SHIFT_RANGE).toVar();
      const T = whole.mul(thermalSource?.temperature ?? DAYLIGHT.temperature).toVar();
      const colors = thermalColors(blackbodies, T, out.mixed);
      return filteredColor(colors, reflectance).mul(
        gain(colors.G, T, thermalSource?.luminance ?? float(1), whole).mul(strength),
      );
    };

    /** Light of any colour that arrives shifted; `luminances`: those of the other lights of a sky. */
    const pictured = (
      light: Vec3,
      reflectance: SpectralFilterNodes,
      shift: Float,
      thermalSource?: ThermalSource,
      luminances: readonly Float[] = [],
    ): Vec3 => {
      const whole = clamp(out.mixed.mul(shift), ...SHIFT_RANGE).toVar();
      const T = whole.mul(thermalSource?.temperature ?? DAYLIGHT.temperature).toVar();
      const surface = thermalColors(blackbodies, T, out.mixed);
      const bare = filteredColor(surface, vec4(1)).toVar();
      const source = thermalSource
        ? { colors: thermalColors(blackbodies, T, whole), gain: gain(surface.G, T, thermalSource.luminance, whole) }
        : daylightTable.at(whole);
      const through = filteredColor(source.colors, ofColor(light, whole));
      // No channel transmits more than the brightest band.
      const maxBand = max(light.x, max(light.y, light.z));
      const passed = clamp(through.mul(bare).div(bare.mul(bare).add(1e-9)), 0, maxBand);
      const arrived = luminances.reduce<Vec3>(
        (wholeShift, luminance, light) => wholeShift.add(daylightTable.skyOverDaylight(light, whole).mul(luminance)),
        passed.mul(source.gain),
      );
      return filteredColor(surface, reflectance).mul(arrived);
    };

    /** Lines that reach a filter shifted by `shift`. */
    const lines = ({ each }: LineSource, filter: SpectralFilterNodes, shift: Float | undefined): Vec3 => {
      const sum = vec3(0).toVar();
      each((wavelength, radiance) => {
        const surface = (shift ? wavelength.div(shift) : wavelength).toVar();
        sum.addAssign(lineColor(observer(), surface, surface.div(out.mixed), filter, hasInvisible).mul(radiance));
      });
      return sum;
    };

    return {
      filter: (rgb, invisible) =>
        hasInvisible && invisible ? vec4(rgb, select(D.lessThan(1), invisible.x, invisible.y)) : ofColor(rgb, D),
      addReflected: (light, reflectance, { D, source, colored }, power) => {
        const shift = D && shiftOf(D);
        if (source && 'each' in source) {
          const seen = lines(source, reflectance.mul(vec4(light, light.y)), shift?.mixed);
          sum.addAssign(shift ? seen.mul(shift.brightness(power)) : seen);
          return;
        }
        const thermal = source && 'temperature' in source ? source : undefined;
        const ofSky = source && 'scatters' in source ? parts(light) : undefined;
        const [k, f] = [(ofSky?.rest ?? light).toVar(), reflectance.toVar()];
        const send = () => {
          daylight.addAssign(f.mul(ofColor(k, out.mixed)));
          if (ofSky) sky.addReflected(f, ofSky.luminances);
          if (typeof colored === 'number') overlapping.add(k, f);
        };
        const turned = (shift: Float): Vec3 => {
          if (typeof colored === 'number') return filteredTwice(colored, k, f, shift, thermal);
          return colored ? pictured(k, f, shift, thermal, ofSky?.luminances) : neutral(k.x, f, shift, thermal);
        };
        const atRest = () => {
          if (!thermal) send();
          else if (typeof colored === 'number') sum.addAssign(filteredAtRest(colored, k, f, thermal));
          else sum.addAssign(unshifted(f.mul(ofColor(k, out.mixed)), thermal));
        };
        const turn = (shift: FrequencyShift) => {
          sum.addAssign(turned(shift.mixed).mul(shift.brightness(power)));
        };
        if (!D || !shift) atRest();
        else If(abs(D.sub(1)).greaterThan(MIN_SHIFT), () => turn(shift)).Else(atRest);
      },
      addEmitted: (light, source) => {
        if (!source) daylight.addAssign(ofColor(light, out.mixed));
        else if ('scatters' in source) {
          const { rest, luminances } = parts(light);
          daylight.addAssign(ofColor(rest, out.mixed));
          sky.addEmitted(luminances);
        } else if ('each' in source) sum.addAssign(lines(source, vec4(light, light.y), undefined));
        else sum.addAssign(unshifted(ofColor(light, out.mixed), source));
      },
      addGlow: ({ luminance, log2Temperature }) => {
        if (!glowing) return;
        If(luminance.greaterThan(0), () => {
          const temperature = exp2(log2Temperature).mul(DAYLIGHT.temperature).toVar();
          const atRest = luminanceOf(thermalColors(blackbodies, temperature, float(1)).G, temperature);
          sum.addAssign(unshifted(ofColor(vec3(luminance), out.mixed), { temperature, luminance: atRest }));
        });
      },
      addBlackbody: (T, radiance) => {
        const seenAt = out.mixed.mul(T).toVar();
        const colors = thermalColors(blackbodies, seenAt, float(1));
        const brightness = gain(colors.G, seenAt, float(1), out.mixed);
        sum.addAssign(filteredColor(colors, vec4(1)).mul(brightness).mul(radiance));
      },
      total: () => {
        const color = daylight.xyz.add(sky.atRest()).toVar();
        if (overlapping.any) color.subAssign(overlapping.atRest());
        If(abs(D.sub(1)).greaterThan(MIN_SHIFT), () => {
          const { colors, gain } = daylightTable.at(out.mixed);
          const banded = filteredColor(colors, daylight).toVar();
          if (overlapping.any) banded.subAssign(overlapping.shifted(() => daylightTable.overlaps(out.mixed)));
          color.assign(banded.mul(gain).add(sky.shifted(out.mixed)));
        });
        return color.add(sum).mul(out.brightness(RADIANCE_POWER));
      },
    };
  };

function fullFrequencyShift(D: Float): FrequencyShift {
  const square = D.mul(D).toVar();
  return {
    mixed: clamp(D, ...SHIFT_RANGE).toVar(),
    brightness: (power) => (power === RADIANCE_POWER ? square.mul(square) : square),
  };
}

/** Y(T)/D⁴ of a blackbody that is seen at T, over its luminance at rest: the factor of brightness that a shift by D leaves besides beaming. */
const gain = (G: Float, T: Float, atRest: Float, D: Float): Float => {
  const square = D.mul(D).toVar();
  return luminanceOf(G, T).div(square.mul(square).mul(atRest));
};
