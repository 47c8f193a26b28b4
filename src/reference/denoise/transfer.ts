/**
 * The transfer function of the network for light of high dynamic range, 0 … 65504 to 0 … 1: steps of equal size look equally large.
 * Source: devices/common/color.h of Open Image Denoise 2, fitted to PU21 (Mantiuk & Azimi 2021).
 */
const [A, B, C, D, E, F, G] = [
  1.41283765e3, 1.64593172, 4.31384981e-1, -2.94139609e-3, 1.92653254e-1, 6.26026094e-3, 9.98620152e-1,
];
const [LINEAR_END, POWER_END] = [1.5794576e-6, 3.22087631e-2];
const [ENCODED_LINEAR_END, ENCODED_POWER_END] = [2.23151711e-3, 3.70974749e-1];
const BRIGHTEST = 65504;

const perceived = (y: number): number => {
  if (y <= LINEAR_END) return A * y;
  return y <= POWER_END ? B * y ** C + D : E * Math.log(y + F) + G;
};

const RANGE = perceived(BRIGHTEST);

export const encodeLight = (y: number): number => perceived(Math.min(Math.max(y, 0), BRIGHTEST)) / RANGE;

export function decodeLight(encoded: number): number {
  const x = encoded * RANGE;
  if (x <= ENCODED_LINEAR_END) return x / A;
  return x <= ENCODED_POWER_END ? ((x - D) / B) ** (1 / C) : Math.exp((x - G) / E) - F;
}
