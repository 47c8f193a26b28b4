import type { DataTexture } from 'three/webgpu';
import { toHalf } from '../math/half.ts';
import { basisAt } from '../spectrum/bands.ts';
import { colorMatching, WAVELENGTHS } from '../spectrum/cie1931.ts';
import { toLinearSrgb } from '../spectrum/observerColor.ts';
import { halfTexture } from './halfTexture.ts';
import type { ObserverTable } from './lineColor.ts';

/** The eye and the basis of filters, nanometre by nanometre, as shaders read them. */
export function observerTexture(): ObserverTable & { readonly texture: DataTexture } {
  const eye = WAVELENGTHS.flatMap((wavelength) => [...toLinearSrgb(colorMatching(wavelength)), 1]);
  const basis = WAVELENGTHS.flatMap((wavelength) => [...basisAt(wavelength), 1]);
  const data = Uint16Array.from([...eye, ...basis], toHalf);
  return { texture: halfTexture(data, WAVELENGTHS.length, 2) };
}
