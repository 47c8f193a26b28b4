import { encodeSrgb } from './srgb.ts';

/** Steps of linear light that are tabulated; each is at most a twentieth of a byte. */
const STEPS = 2 ** 16;

let table: Uint8Array | undefined;

/** Linear light 0…1 → the nearest byte of sRGB, for whole pictures: by a table, within 0.03 of the exact curve before rounding. */
export function srgbByte(linear: number): number {
  table ??= Uint8Array.from({ length: STEPS + 1 }, (_, i) => Math.round(255 * encodeSrgb(i / STEPS)));
  return table[Math.round(Math.min(Math.max(linear, 0), 1) * STEPS)];
}
