import type { Vec3 } from '../../math/vec3.ts';
import { type BlackbodyCurve, blackbodyCurve, blackbodyLuminance, rowOf } from '../../spectrum/doppler/thermalTable.ts';

/**
 * Linear sRGB of a blackbody of T [K] at luminance 1, and its luminance relative to daylight. Interpolated from a
 * table, since a sky evaluates thousands per frame.
 */
export function blackbody(T: number): { readonly color: Vec3; readonly luminance: number } {
  curve ??= blackbodyCurve();
  const place = rowOf(curve, T);
  const i = Math.min(Math.floor(place), curve.rows - 2);
  const s = place - i;
  const { values } = curve;
  const at = (k: number): number => (1 - s) * values[4 * i + k] + s * values[4 * (i + 1) + k];
  return { color: [at(0), at(1), at(2)], luminance: blackbodyLuminance(at(3), T) };
}

let curve: BlackbodyCurve | undefined;
