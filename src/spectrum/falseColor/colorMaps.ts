/** sRGB, 0 … 255 each. */
export type Rgb8 = readonly [r: number, g: number, b: number];
/** A colour for each number 0 … 1; the input is clamped. */
export type ColorMap = (value: number) => Rgb8;

/**
 * Every fifth of the 256 colours of magma, sRGB in hexadecimal; the interpolation between them is accurate to 1/255. Perceptually uniform from dark
 * to bright, also in grey. Source: S. van der Walt & N. Smith, matplotlib 1.5 (2015), CC0.
 */
export const magma = colorMapFrom(
  '00000402020b0504160907200e0b2b140e361a104221114e29115a311165390f6e420f754a107952137c5a167e6219806a1c81721f817922828128' +
    '81892881912b81992d80a1307eaa337db2357bba3878c23b75ca3e72d2426fd9466be04c67e75263ec5860f1605df4695cf7725cf97b5dfb8560fc' +
    '8e64fd9869fea16efeaa74feb47bfebd82fec68afecf92fed89afde2a3fdebacfcf4b6fcfdbf',
);

/** Viridis, from blue to yellow, in the same form. Source: as magma. */
export const viridis = colorMapFrom(
  '44015446085c471063481769481d6f482475472a7a46307e453781433d844142873f48893d4e8a3a538b38598c355e8d33638d31688e2e6d8e2c71' +
    '8e2a768e297b8e27808e25848e23898e218e8d20928c1f978b1e9c891fa18821a58524aa8328ae802eb37c35b7793dbc7446c06f50c46a5ac86465' +
    'cb5e70cf577cd25089d54895d840a2da37b0dd2fbddf26cae11fd8e219e5e419f1e51dfde725',
);

/**
 * From blue over grey to red, perceptually uniform on both sides. Source: K. Moreland, "Diverging Color Maps for Scientific Visualization"
 * (ISVC 2009), its table of 33 colours.
 */
export const coolWarm = colorMapFrom(
  '3b4cc0445acc4d68d75775e16282ea6c8ef1779af782a5fb8db0fe98b9ffa3c2ffaec9fdb8d0f9c2d5f4ccd9eed5dbe6dddddde5d8d1ecd3c5f1ccb9' +
    'f5c4adf7bba0f7b194f7a687f49a7bf18d6fec7f63e57058de604dd55042cb3e38c0282fb40426',
);

/** A map through colours at equal steps, given in hexadecimal. */
function colorMapFrom(text: string): ColorMap {
  const colors = (text.match(/.{6}/g) ?? []).map((hex) => Number.parseInt(hex, 16));
  const last = colors.length - 1;
  return (value) => {
    const at = Math.min(Math.max(value, 0), 1) * last;
    const step = Math.min(Math.floor(at), last - 1);
    const channel = (shift: number) => {
      const [low, high] = [(colors[step]! >> shift) & 255, (colors[step + 1]! >> shift) & 255];
      return Math.round(low + (high - low) * (at - step));
    };
    return [channel(16), channel(8), channel(0)];
  };
}
