import type { JpegComponent, JpegFrame } from './frame.ts';

/** What the components of a picture are; with four, inverted as Adobe writes them. */
export type ColorEncoding = 'gray' | 'ycc' | 'rgb' | 'cmyk' | 'ycck';

/** In 16 bits, by sample: JFIF 1.02, "Conversion to and from RGB". */
const table = (factor: number): Int32Array =>
  Int32Array.from({ length: 256 }, (_, sample) => Math.round(65536 * factor * (sample - 128)));
const [RED, GREEN_BLUE, GREEN_RED, BLUE] = [1.402, -0.344136286, -0.714136286, 1.772].map(table);
const HALF = 1 << 15;

/** RGBA of the components' samples, of which a coarser one's are repeated. */
export function jpegColors({ width, height, components }: JpegFrame, encoding: ColorEncoding): Uint8Array {
  const data = new Uint8Array(4 * width * height);
  const across = Math.max(...components.map((component) => component.across));
  const down = Math.max(...components.map((component) => component.down));
  const rows = components.map((component) => rowReader(component, width, across, down));
  for (let y = 0; y < height; y++) {
    const samples = rows.map((rowAt) => rowAt(y));
    const [first, second = first, third = first] = samples;
    const row = data.subarray(4 * width * y, 4 * width * (y + 1));
    if (encoding === 'ycc' || encoding === 'ycck') setFromYcc(row, first, second, third);
    else setChannels(row, first, second, third);
    if (samples.length === 4) applyBlack(row, samples[3], encoding === 'ycck');
  }
  return data;
}

/** Reads rows of a component at the picture's size; a row is overwritten by the next. */
function rowReader(component: JpegComponent, width: number, across: number, down: number): (y: number) => Uint8Array {
  const { samples, stride } = component;
  const start = (y: number): number => Math.floor((y * component.down) / down) * stride;
  if (component.across === across) return (y) => samples.subarray(start(y), start(y) + width);
  const columns = Uint32Array.from({ length: width }, (_, x) => Math.floor((x * component.across) / across));
  const row = new Uint8Array(width);
  return (y) => {
    const first = start(y);
    for (let x = 0; x < width; x++) row[x] = samples[first + columns[x]];
    return row;
  };
}

function setChannels(row: Uint8Array, red: Uint8Array, green: Uint8Array, blue: Uint8Array): void {
  for (let x = 0, i = 0; x < red.length; x++, i += 4) {
    row[i] = red[x];
    row[i + 1] = green[x];
    row[i + 2] = blue[x];
    row[i + 3] = 255;
  }
}

function setFromYcc(row: Uint8Array, luma: Uint8Array, blueness: Uint8Array, redness: Uint8Array): void {
  for (let x = 0, i = 0; x < luma.length; x++, i += 4) {
    const [y, cb, cr] = [luma[x], blueness[x], redness[x]];
    row[i] = clamped(y + ((RED[cr] + HALF) >> 16));
    row[i + 1] = clamped(y + ((GREEN_BLUE[cb] + GREEN_RED[cr] + HALF) >> 16));
    row[i + 2] = clamped(y + ((BLUE[cb] + HALF) >> 16));
    row[i + 3] = 255;
  }
}

const clamped = (x: number): number => Math.max(0, Math.min(255, x));

/** Light that inks let through; `turned`: the colours are those of the inks. */
function applyBlack(row: Uint8Array, black: Uint8Array, turned: boolean): void {
  for (let x = 0; x < black.length; x++)
    for (let i = 4 * x; i < 4 * x + 3; i++) row[i] = Math.round(((turned ? 255 - row[i] : row[i]) * black[x]) / 255);
}
