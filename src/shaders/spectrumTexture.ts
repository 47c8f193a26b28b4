import { ClampToEdgeWrapping, DataTexture, HalfFloatType, LinearFilter, RGBAFormat } from 'three/webgpu';
import type { DopplerTable } from '../spectrum/dopplerTable.ts';
import type { SpectrumTable } from './spectrumTable.ts';

/** A table as shaders read it. */
export function spectrumTexture(table: DopplerTable): SpectrumTable & { readonly texture: DataTexture } {
  const { data, layers, columns, rows } = table;
  const texture = new DataTexture(new Uint16Array(data), columns, layers * rows, RGBAFormat, HalfFloatType);
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.wrapS = ClampToEdgeWrapping;
  texture.wrapT = ClampToEdgeWrapping;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return { texture, layers, columns, rows };
}
