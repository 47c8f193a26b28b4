import { abs, clamp, dot, exp2, float, If, log2, max, select, vec3, vec4 } from 'three/tsl';
import { lineColor, type ObserverTable } from '../shaders/lineColor.ts';
import { filteredColor, luminanceOf, type SpectrumTable, thermalColors } from '../shaders/spectrumTable.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { ENDS } from '../spectrum/bands.ts';
import { DAYLIGHT } from '../spectrum/lightSpectrum.ts';
import { SCATTERED_COLOR, SCATTERED_PART } from '../spectrum/scatteredLight.ts';
import type { DaylightTable } from './daylightTable.ts';
import { type Filter, type LineSource, NO_SHIFT, type Optics, RADIANCE, type ThermalSource } from './radiance.ts';

/** Shifts that colours follow: beyond the first all is dark, beyond the second they change no more. */
const SHIFTS = [1e-3, 1e6] as const;

export interface SpectralTables {
  readonly blackbodies: SpectrumTable;
  /** The same for light that was daylight at rest, where light and filter are shifted together. */
  readonly daylight: DaylightTable;
  readonly observer: ObserverTable;
}

interface Shift {
  /** D, by the share of it that colours follow. */
  readonly mixed: Float;
  /** D^power, by the share that brightness follows. */
  brightness(power: number): Float;
}

/**
 * Colours by spectra, from the table of blackbodies. Daylight that met a resting surface is summed in bands, and turned into what is seen of it once.
 * Light that came shifted is turned by itself: it is a blackbody of T·D_in·D_out seen through two filters, the surface's shifted by D_out and its own by both.
 * Their product is taken channel by channel of what is seen, relative to the bare blackbody: exact where either is neutral (docs/adr/0010-spectra.md).
 * Light of lines is turned line by line, exactly; of that of a sky the scattered part has a table of its own. The table has four layers where some surface tells of its ultraviolet or infrared; `glowing`: some shines by its temperature.
 */
export const spectral =
  ({ blackbodies, daylight: ofDay, observer }: SpectralTables, glowing: boolean): Optics =>
  (D, uniforms) => {
    const own = blackbodies.layers === 4;
    const shiftOf = (D: Float): Shift => {
      const log = log2(max(D, 1e-20)).toVar();
      const mixed = clamp(exp2(log.mul(uniforms.dopplerMix)), ...SHIFTS).toVar();
      return { mixed, brightness: (power) => exp2(log.mul(uniforms.beaming.mul(power))) };
    };
    const out = shiftOf(D);
    const daylight = vec4(0).toVar();
    /** What is scattered, as surfaces send it, and as the sky itself is seen. */
    const scattered = vec4(0).toVar();
    const blue = float(0).toVar();
    const turned = vec3(0).toVar();
    const ofColor = (rgb: Vec3, shift: Float): Filter =>
      own ? vec4(rgb, dot(rgb, select(shift.lessThan(1), vec3(...ENDS.uv), vec3(...ENDS.ir)))) : vec4(rgb, 0);

    const unshifted = (filter: Filter, { temperature, luminance }: ThermalSource): Vec3 => {
      const T = temperature.mul(out.mixed).toVar();
      const colors = thermalColors(blackbodies, T, out.mixed);
      return filteredColor(colors, filter).mul(gain(colors.H, T, luminance, out.mixed));
    };

    /** Of the light of a sky. */
    const parts = (light: Vec3): { readonly rest: Vec3; readonly scattered: Float } => {
      const share = max(dot(light, vec3(...SCATTERED_PART)), 0).toVar();
      return { rest: light.sub(vec3(...SCATTERED_COLOR).mul(share)).toVar(), scattered: share };
    };

    const shifted = (
      light: Vec3,
      share: Filter,
      shift: Float,
      from: ThermalSource | undefined,
      ofSky?: Float,
    ): Vec3 => {
      const whole = clamp(out.mixed.mul(shift), ...SHIFTS).toVar();
      const T = whole.mul(from?.temperature ?? DAYLIGHT.temperature).toVar();
      const surface = thermalColors(blackbodies, T, out.mixed);
      const bare = filteredColor(surface, vec4(1)).toVar();
      const source = from
        ? { colors: thermalColors(blackbodies, T, whole), gain: gain(surface.H, T, from.luminance, whole) }
        : ofDay.at(whole);
      const through = filteredColor(source.colors, ofColor(light, whole));
      // No channel lets through more than the brightest band.
      const most = max(light.x, max(light.y, light.z));
      const passed = clamp(through.mul(bare).div(bare.mul(bare).add(1e-9)), 0, most);
      const arrived = passed.mul(source.gain);
      return filteredColor(surface, share).mul(
        ofSky ? arrived.add(ofDay.scattered(whole).ofDaylight.mul(ofSky)) : arrived,
      );
    };

    /** Of light that came to a filter shifted by `D`. */
    const lines = ({ each }: LineSource, filter: Filter, shift: Float | undefined): Vec3 => {
      const sum = vec3(0).toVar();
      each((wavelength, radiance) => {
        const surface = (shift ? wavelength.div(shift) : wavelength).toVar();
        sum.addAssign(lineColor(observer, surface, surface.div(out.mixed), filter, own).mul(radiance));
      });
      return sum;
    };

    return {
      filter: (rgb, invisible) =>
        own && invisible ? vec4(rgb, select(D.lessThan(1), invisible.x, invisible.y)) : ofColor(rgb, D),
      send: (light, share, { D, source }, power) => {
        const shift = D && shiftOf(D);
        if (source && 'each' in source) {
          const seen = lines(source, share.mul(vec4(light, light.y)), shift?.mixed);
          turned.addAssign(shift ? seen.mul(shift.brightness(power)) : seen);
          return;
        }
        const thermal = source && 'temperature' in source ? source : undefined;
        const sky = source && 'scatters' in source ? parts(light) : undefined;
        const [k, f] = [(sky?.rest ?? light).toVar(), share.toVar()];
        const send = () => {
          const sent = f.mul(ofColor(k, out.mixed));
          if (thermal) turned.addAssign(unshifted(sent, thermal));
          else daylight.addAssign(sent);
          if (sky) scattered.addAssign(f.mul(sky.scattered));
        };
        if (!D || !shift) return send();
        const turn = () => {
          turned.addAssign(shifted(k, f, shift.mixed, thermal, sky?.scattered).mul(shift.brightness(power)));
        };
        if (thermal) turn();
        else If(abs(D.sub(1)).greaterThan(NO_SHIFT), turn).Else(send);
      },
      emit: (light, source) => {
        if (!source) daylight.addAssign(ofColor(light, out.mixed));
        else if ('scatters' in source) {
          const sky = parts(light);
          daylight.addAssign(ofColor(sky.rest, out.mixed));
          blue.addAssign(sky.scattered);
        } else if ('each' in source) turned.addAssign(lines(source, vec4(light, light.y), undefined));
        else turned.addAssign(unshifted(ofColor(light, out.mixed), source));
      },
      glow: ({ luminance, heat }) => {
        if (!glowing) return;
        If(luminance.greaterThan(0), () => {
          const temperature = exp2(heat).mul(DAYLIGHT.temperature).toVar();
          const atRest = luminanceOf(thermalColors(blackbodies, temperature, float(1)).H, temperature);
          turned.addAssign(unshifted(ofColor(vec3(luminance), out.mixed), { temperature, luminance: atRest }));
        });
      },
      radiate: (T, radiance) => {
        const seenAt = out.mixed.mul(T).toVar();
        const colors = thermalColors(blackbodies, seenAt, float(1));
        const brightness = gain(colors.H, seenAt, float(1), out.mixed);
        turned.addAssign(filteredColor(colors, vec4(1)).mul(brightness).mul(radiance));
      },
      seen: () => {
        const color = daylight.xyz.add(scattered.xyz.add(blue).mul(vec3(...SCATTERED_COLOR))).toVar();
        If(abs(D.sub(1)).greaterThan(NO_SHIFT), () => {
          const { colors, gain } = ofDay.at(out.mixed);
          const sky = ofDay.scattered(out.mixed);
          const sent = filteredColor(colors, scattered).mul(sky.ofDaylight).add(sky.seen.mul(blue));
          color.assign(filteredColor(colors, daylight).mul(gain).add(sent));
        });
        return color.add(turned).mul(out.brightness(RADIANCE));
      },
    };
  };

/** Y(T)/D⁴ of a blackbody that is seen at T, over its luminance at rest: what a shift by D leaves of brightness besides beaming. */
const gain = (H: Float, T: Float, atRest: Float, D: Float): Float => {
  const square = D.mul(D).toVar();
  return luminanceOf(H, T).div(square.mul(square).mul(atRest));
};
