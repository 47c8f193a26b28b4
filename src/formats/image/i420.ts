/**
 * A picture as films hold it: Y′ of every pixel, then C_B and C_R of every 2 × 2, in limited range. Y′ = 0.2126 R′ + 0.7152 G′ + 0.0722 B′,
 * C_B = (B′ − Y′)/1.8556, C_R = (R′ − Y′)/1.5748; 16 + 219 Y′, 128 + 224 C (ITU-R BT.709-6, 3 and 4). `rgba`: 8 bits each, as a screen has them; width and height
 * are even.
 */
export function i420(width: number, height: number, rgba: Uint8Array): Uint8Array<ArrayBuffer> {
  const pixels = width * height;
  const out = new Uint8Array((3 * pixels) / 2);
  for (let i = 0; i < pixels; i++) out[i] = Math.round(16 + (219 / 255) * luma(rgba, 4 * i));
  const chroma = 224 / 255 / 4;
  for (let y = 0, at = pixels; y < height; y += 2)
    for (let x = 0; x < width; x += 2, at++) {
      let [blue, red] = [0, 0];
      for (const i of [y * width + x, y * width + x + 1, (y + 1) * width + x, (y + 1) * width + x + 1]) {
        const light = luma(rgba, 4 * i);
        blue += rgba[4 * i + 2]! - light;
        red += rgba[4 * i]! - light;
      }
      out[at] = Math.round(128 + (chroma * blue) / 1.8556);
      out[at + pixels / 4] = Math.round(128 + (chroma * red) / 1.5748);
    }
  return out;
}

const luma = (rgba: Uint8Array, i: number): number => 0.2126 * rgba[i]! + 0.7152 * rgba[i + 1]! + 0.0722 * rgba[i + 2]!;
