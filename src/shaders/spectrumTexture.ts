import { ClampToEdgeWrapping, DataTexture, HalfFloatType, LinearFilter, RGBAFormat } from 'three/webgpu';
import type { DopplerTable } from '../spectrum/dopplerTable.ts';
import type { SpectrumTable } from './spectrumTable.ts';

/** A table as shaders read it. */
export function spectrumTexture(table: DopplerTable): SpectrumTable & { readonly texture: DataTexture } {
  const { columns, rows } = table;
  const texture = new DataTexture(withBeyond(table), columns, 4 * rows, RGBAFormat, HalfFloatType);
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.wrapS = ClampToEdgeWrapping;
  texture.wrapT = ClampToEdgeWrapping;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return { texture, columns, rows };
}

/** The layers, the fourth with C_uv in the columns where D < 1. */
function withBeyond({ data, columns, rows }: DopplerTable): Uint16Array<ArrayBuffer> {
  const made = new Uint16Array(data);
  const layer = 4 * rows * columns;
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < (columns - 1) / 2; column++) {
      const at = 4 * (row * columns + column);
      for (let k = 0; k < 3; k++) made[at + 3 * layer + k] = data[at + (k + 1) * layer + 3];
    }
  return made;
}
