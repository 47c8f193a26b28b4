import { abs, clamp, dot, exp2, float, If, log2, max, select, vec3, vec4 } from 'three/tsl';
import { lineColor, type ObserverTable } from '../shaders/lineColor.ts';
import { filteredColor, luminanceOf, type SpectrumTable, thermalColors } from '../shaders/spectrumTable.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { ENDS } from '../spectrum/bands.ts';
import { DAYLIGHT } from '../spectrum/lightSpectrum.ts';
import {
  beamed,
  type Filter,
  type LineSource,
  NO_SHIFT,
  type Optics,
  RADIANCE,
  type ThermalSource,
} from './radiance.ts';

/** Shifts that colours follow: beyond the first all is dark, beyond the second they change no more. */
const SHIFTS = [1e-3, 1e6] as const;
const DAY: ThermalSource = { temperature: float(DAYLIGHT.temperature), luminance: float(1) };

/**
 * Colours by spectra, from the table of blackbodies. Daylight that met a resting surface is summed in bands, and turned into what is seen of it once.
 * Light that came shifted is turned by itself: it is a blackbody of T·D_in·D_out seen through two filters, the surface's shifted by D_out and its own by both.
 * Their product is taken channel by channel of what is seen, relative to the bare blackbody: exact where either is neutral (docs/adr/0010-spectra.md).
 * Light of lines is turned line by line, exactly. The table has four layers where some surface tells of its ultraviolet or infrared; `glowing`: some shines by its temperature.
 */
export const spectral =
  (table: SpectrumTable, observer: ObserverTable, glowing: boolean): Optics =>
  (D, uniforms) => {
    const mix = (shift: Float): Float =>
      clamp(exp2(log2(max(shift, 1e-20)).mul(uniforms.dopplerMix)), ...SHIFTS).toVar();
    const out = mix(D);
    const daylight = vec4(0).toVar();
    const turned = vec3(0).toVar();
    const ofColor = (rgb: Vec3, shift: Float): Filter => {
      if (table.layers === 3) return vec4(rgb, 0);
      return vec4(rgb, dot(rgb, select(shift.lessThan(1), vec3(...ENDS.uv), vec3(...ENDS.ir))));
    };

    const unshifted = (filter: Filter, { temperature, luminance }: ThermalSource): Vec3 => {
      const T = temperature.mul(out).toVar();
      const colors = thermalColors(table, T, out);
      return filteredColor(colors, filter).mul(gain(colors.H, T, luminance, out));
    };

    const shifted = (light: Vec3, share: Filter, D: Float, { temperature, luminance }: ThermalSource): Vec3 => {
      const whole = clamp(out.mul(mix(D)), ...SHIFTS).toVar();
      const T = temperature.mul(whole).toVar();
      const surface = thermalColors(table, T, out);
      const bare = filteredColor(surface, vec4(1)).toVar();
      const through = filteredColor(thermalColors(table, T, whole), ofColor(light, whole));
      // No channel lets through more than the brightest band.
      const most = max(light.x, max(light.y, light.z));
      const source = clamp(through.mul(bare).div(bare.mul(bare).add(1e-9)), 0, most);
      return filteredColor(surface, share)
        .mul(source)
        .mul(gain(surface.H, T, luminance, whole));
    };

    /** Of light that came to a filter shifted by `D`. */
    const lines = ({ each }: LineSource, filter: Filter, D: Float | undefined): Vec3 => {
      const sum = vec3(0).toVar();
      const own = table.layers === 4;
      each((wavelength, radiance) => {
        const surface = (D ? wavelength.div(mix(D)) : wavelength).toVar();
        sum.addAssign(lineColor(observer, surface, surface.div(out), filter, own).mul(radiance));
      });
      return sum;
    };

    return {
      filter: (rgb, own) =>
        own && table.layers === 4 ? vec4(rgb, select(D.lessThan(1), own.x, own.y)) : ofColor(rgb, D),
      send: (light, share, { D, source }, power) => {
        if (source && 'each' in source) {
          const seen = lines(source, share.mul(vec4(light, light.y)), D);
          turned.addAssign(D ? seen.mul(beamed(D, power, uniforms)) : seen);
          return;
        }
        if (!D) {
          const sent = share.mul(ofColor(light, out));
          if (source) turned.addAssign(unshifted(sent, source));
          else daylight.addAssign(sent);
          return;
        }
        const [k, f] = [light.toVar(), share.toVar()];
        const turn = () => {
          turned.addAssign(shifted(k, f, D, source ?? DAY).mul(beamed(D, power, uniforms)));
        };
        if (source) turn();
        else
          If(abs(D.sub(1)).greaterThan(NO_SHIFT), turn).Else(() => {
            daylight.addAssign(f.mul(ofColor(k, out)));
          });
      },
      emit: (light, source) => {
        if (!source) daylight.addAssign(ofColor(light, out));
        else if ('each' in source) turned.addAssign(lines(source, vec4(light, light.y), undefined));
        else turned.addAssign(unshifted(ofColor(light, out), source));
      },
      glow: ({ luminance, heat }) => {
        if (!glowing) return;
        If(luminance.greaterThan(0), () => {
          const temperature = exp2(heat).mul(DAYLIGHT.temperature).toVar();
          const atRest = luminanceOf(thermalColors(table, temperature, float(1)).H, temperature);
          turned.addAssign(unshifted(ofColor(vec3(luminance), out), { temperature, luminance: atRest }));
        });
      },
      radiate: (T, radiance) => {
        const seenAt = out.mul(T).toVar();
        const colors = thermalColors(table, seenAt, float(1));
        turned.addAssign(
          filteredColor(colors, vec4(1))
            .mul(gain(colors.H, seenAt, float(1), out))
            .mul(radiance),
        );
      },
      seen: () => {
        const color = daylight.xyz.toVar();
        If(abs(D.sub(1)).greaterThan(NO_SHIFT), () => {
          color.assign(unshifted(daylight, DAY));
        });
        return color.add(turned).mul(beamed(D, RADIANCE, uniforms));
      },
    };
  };

/** Y(T)/D⁴ of a blackbody that is seen at T, over its luminance at rest: what a shift by D leaves of brightness besides beaming. */
const gain = (H: Float, T: Float, atRest: Float, D: Float): Float => {
  const square = D.mul(D).toVar();
  return luminanceOf(H, T).div(square.mul(square).mul(atRest));
};
