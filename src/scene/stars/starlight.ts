import { fromHalf } from '../../math/half.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { blackbodyCurve, luminanceOf, rowOf } from '../../spectrum/thermalTable.ts';
import type { RenderSettings } from '../view.ts';

/**
 * Radiance of a blackbody of T [K] that is shifted by D, as linear sRGB over its luminance at rest: a blackbody of T·D, so Y(TD)/Y(T) times its colour.
 * Each by the settings' shares, as everything is: `dopplerMix` of the shift in colour and `beaming` of the D⁴ in brightness.
 */
export function starlight(T: number, D: number, settings: Pick<RenderSettings, 'dopplerMix' | 'beaming'>): Vec3 {
  const shift = D ** settings.dopplerMix;
  const seen = blackbody(T * shift);
  const gain = (seen.luminance / (blackbody(T).luminance * shift ** 4)) * D ** (4 * settings.beaming);
  return [seen.color[0] * gain, seen.color[1] * gain, seen.color[2] * gain];
}

/** Its linear sRGB at luminance 1, and its luminance over that of daylight's blackbody. A sky has thousands of stars for each picture: so from a curve. */
function blackbody(T: number): { readonly color: Vec3; readonly luminance: number } {
  curve ??= decodedCurve();
  const place = rowOf(curve, T);
  const i = Math.min(Math.floor(place), curve.rows - 2);
  const s = place - i;
  const { values } = curve;
  const at = (k: number): number => (1 - s) * values[4 * i + k] + s * values[4 * (i + 1) + k];
  return { color: [at(0), at(1), at(2)], luminance: luminanceOf(at(3), T) };
}

let curve: { readonly values: Float64Array; readonly rows: number } | undefined;

function decodedCurve() {
  const { data, rows } = blackbodyCurve();
  return { values: Float64Array.from(data, fromHalf), rows };
}
