import type { DataTexture } from 'three/webgpu';
import type { DopplerTable } from '../spectrum/dopplerTable.ts';
import { halfTexture } from './halfTexture.ts';
import type { SpectrumTable } from './spectrumTable.ts';

/** A table as shaders read it. */
export function spectrumTexture(table: DopplerTable): SpectrumTable & { readonly texture: DataTexture } {
  const { data, layers, columns, rows } = table;
  return { texture: halfTexture(new Uint16Array(data), columns, layers * rows), layers, columns, rows };
}
