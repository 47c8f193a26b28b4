/** Linear light 0…1 → encoded 0…1 (sRGB, IEC 61966-2-1); the input is clamped. */
export function encodeSrgb(linear: number): number {
  const x = Math.min(Math.max(linear, 0), 1);
  // 1.055 x^(1/2.4) − 0.055, in a form in which white is exactly 1.
  return x <= 0.0031308 ? 12.92 * x : 1 - 1.055 * (1 - x ** (1 / 2.4));
}

/** The inverse of `encodeSrgb` on 0…1. */
export const decodeSrgb = (encoded: number): number =>
  encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
