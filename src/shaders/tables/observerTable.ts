import { toHalf } from '../../math/half.ts';
import { toLinearSrgb } from '../../spectrum/color/observerColor.ts';
import { colorMatching, WAVELENGTHS } from '../../spectrum/observer/standardObserver.ts';
import { basisAt } from '../../spectrum/reflectance/spectralFilter.ts';
import type { HalfTexels } from './halfAtlas.ts';

/** The standard observer (linear sRGB) and the filter basis at every nanometre, as texels for lineColor.ts. */
export function observerTexels(): HalfTexels {
  const eye = WAVELENGTHS.flatMap((wavelength) => [...toLinearSrgb(colorMatching(wavelength)), 1]);
  const basis = WAVELENGTHS.flatMap((wavelength) => [...basisAt(wavelength), 1]);
  return { data: Uint16Array.from([...eye, ...basis], toHalf), width: WAVELENGTHS.length };
}
