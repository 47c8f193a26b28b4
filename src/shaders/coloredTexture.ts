import type { DataTexture } from 'three/webgpu';
import { type ColoredLight, coloredTable } from '../spectrum/filterPairs.ts';
import type { ColoredTables } from './coloredTable.ts';
import { halfTexture } from './halfTexture.ts';

/** The tables of these lights, one at least, as shaders read them. */
export function coloredTexture(
  lights: readonly ColoredLight[],
  layers: 3 | 4,
): ColoredTables & { readonly texture: DataTexture } {
  const tables = lights.map((light) => coloredTable(light, layers));
  const [{ data, columns: steps }] = tables;
  const all = new Uint16Array(data.length * tables.length);
  tables.forEach((table, i) => {
    all.set(table.data, i * data.length);
  });
  return { texture: halfTexture(all, steps, steps * layers * tables.length), layers, steps, count: tables.length };
}
