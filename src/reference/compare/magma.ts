/**
 * Every fifth of the 256 colours of magma, sRGB, as hexadecimal text; between them they are interpolated, true to 1/255. From dark to
 * bright evenly to the eye, in grey too. Source: S. van der Walt & N. Smith, matplotlib 1.5 (2015), dedicated to the public (CC0).
 */
const COLORS =
  '00000402020b0504160907200e0b2b140e361a104221114e29115a311165390f6e420f754a107952137c5a167e6219806a1c81721f817922828128' +
  '81892881912b81992d80a1307eaa337db2357bba3878c23b75ca3e72d2426fd9466be04c67e75263ec5860f1605df4695cf7725cf97b5dfb8560fc' +
  '8e64fd9869fea16efeaa74feb47bfebd82fec68afecf92fed89afde2a3fdebacfcf4b6fcfdbf';
const STEPS = COLORS.length / 6 - 1;

export type Color = readonly [r: number, g: number, b: number];

/** The colour of 0 … 1, 0 … 255 each; what lies outside is clamped. */
export function magma(value: number): Color {
  const at = Math.min(Math.max(value, 0), 1) * STEPS;
  const step = Math.min(Math.floor(at), STEPS - 1);
  const channel = (k: number) => {
    const [low, high] = [byteAt(step, k), byteAt(step + 1, k)];
    return Math.round(low + (high - low) * (at - step));
  };
  return [channel(0), channel(1), channel(2)];
}

const byteAt = (step: number, k: number): number =>
  Number.parseInt(COLORS.slice(6 * step + 2 * k, 6 * step + 2 * k + 2), 16);
