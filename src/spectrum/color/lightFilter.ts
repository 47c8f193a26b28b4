import { IDENTITY, invert, type Mat3, multiply, transform, transpose } from '../../math/mat3.ts';
import { add, dot, sub, type Vec3 } from '../../math/vec3.ts';
import { filterFromRgb, type SpectralFilter, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import type { LightSpectrum } from '../sources/lightSpectrum.ts';
import { LUMINANCE_WEIGHTS, observedColor } from './observerColor.ts';

/**
 * The filter k before a blackbody for which a white surface at rest shows the linear sRGB `color`; in daylight k is `color` itself.
 * Bands in which the blackbody has almost no light (blue of embers) stay neutral. Lines and sampled spectra have their own colour:
 * only the luminance of `color` is used. docs/physics.md §7.7.
 * @example
 * lightFilter([1, 0.5, 0.25], DAYLIGHT).rgb; // [1, 0.5, 0.25]
 */
export function lightFilter(color: Vec3, spectrum: LightSpectrum): SpectralFilter {
  const gray = dot(LUMINANCE_WEIGHTS, color);
  if (spectrum.kind !== 'thermal') return filterFromRgb([gray, gray, gray]);
  return filterFromRgb(solveNearNeutral(bandMatrix(spectrum), color, gray));
}

const matrices = new WeakMap<LightSpectrum, Mat3>();

/** Columns: the colours that r, g and b alone show in the light at rest. Cached, because a sky needs it for every ray. */
function bandMatrix(spectrum: LightSpectrum): Mat3 {
  const known = matrices.get(spectrum);
  if (known) return known;
  const band = (rgb: Vec3) => observedColor(filterFromRgb(rgb), WHITE_FILTER, spectrum, 1, 1);
  const [red, green, blue] = [band([1, 0, 0]), band([0, 1, 0]), band([0, 0, 1])];
  const matrix = [0, 1, 2].flatMap((i) => [red[i], green[i], blue[i]]);
  matrices.set(spectrum, matrix);
  return matrix;
}

/** Tikhonov parameter ε: a band with a smaller share of the light hardly influences the solution. */
const DAMPING = 0.05;

/**
 * k ≥ 0 with C k = color, by iterated Tikhonov regularization started from grey: k += (CᵀC + ε²)⁻¹ Cᵀ(color − C k). Components with large
 * singular values σ are solved to (ε/σ)⁸, those with small ones stay grey. Source: Engl, Hanke and Neubauer 1996, "Regularization of Inverse Problems", §5.
 */
function solveNearNeutral(C: Mat3, color: Vec3, gray: number): Vec3 {
  const Ct = transpose(C);
  const damped = multiply(Ct, C).map((value, i) => value + DAMPING ** 2 * IDENTITY[i]);
  const step = multiply(invert(damped) ?? IDENTITY, Ct);
  let k: Vec3 = [gray, gray, gray];
  for (let i = 0; i < 4; i++) k = add(k, transform(step, sub(color, transform(C, k))));
  return [Math.max(k[0], 0), Math.max(k[1], 0), Math.max(k[2], 0)];
}
