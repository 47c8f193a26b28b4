import { random } from '../../src/math/random.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import type { Texture } from '../../src/scene/types.ts';

/** `#rrggbb` → sRGB bytes. */
export const rgb = (hex: string): [number, number, number] => [
  Number.parseInt(hex.slice(1, 3), 16),
  Number.parseInt(hex.slice(3, 5), 16),
  Number.parseInt(hex.slice(5, 7), 16),
];

/** `#rrggbb` → linear sRGB, as in materials (IEC 61966-2-1). */
export const linear = (hex: string): Vec3 => {
  const [r, g, b] = rgb(hex).map((byte) => {
    const v = byte / 255;
    return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
  });
  return [r, g, b];
};

/** `#rrggbb` times a factor, towards black (k < 1) or white (k > 1). */
export function tone(hex: string, k: number): string {
  const mixed = rgb(hex).map((v) => Math.round(k <= 1 ? v * k : v + (255 - v) * (k - 1)));
  return `#${mixed.map((v) => Math.max(0, Math.min(255, v)).toString(16).padStart(2, '0')).join('')}`;
}

/** A procedural texture; x to the right, y down, in pixels. */
export class Canvas {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8Array;

  constructor(width: number, height: number, background: string) {
    this.width = width;
    this.height = height;
    this.data = new Uint8Array(width * height * 4);
    this.rect(0, 0, width, height, background);
  }

  rect(x0: number, y0: number, x1: number, y1: number, color: string): this {
    const [r, g, b] = rgb(color);
    for (let y = Math.max(0, Math.round(y0)); y < Math.min(this.height, Math.round(y1)); y++)
      for (let x = Math.max(0, Math.round(x0)); x < Math.min(this.width, Math.round(x1)); x++)
        this.data.set([r, g, b, 255], 4 * (y * this.width + x));
    return this;
  }

  /** Every other of `fields` × `fields` squares, from the top left one on. */
  squares(left: number, top: number, fields: number, side: number, color: string): this {
    for (let j = 0; j < fields; j++)
      for (let i = j % 2; i < fields; i += 2) {
        const [x, y] = [left + i * side, top + j * side];
        this.rect(x, y, x + side, y + side, color);
      }
    return this;
  }

  /** Sets every pixel as a function of u (right) and v (up), 0 … 1. */
  shade(color: (u: number, v: number) => string): this {
    for (let y = 0; y < this.height; y++)
      for (let x = 0; x < this.width; x++) {
        const [r, g, b] = rgb(color((x + 0.5) / this.width, 1 - (y + 0.5) / this.height));
        this.data.set([r, g, b, 255], 4 * (y * this.width + x));
      }
    return this;
  }

  /** Adds noise: brightness varies by up to `amount` (0 … 1), in patches of `size` pixels. */
  grain(amount: number, size = 1, seed = 1): this {
    const next = random(seed);
    const columns = Math.ceil(this.width / size);
    const patches = Array.from(
      { length: columns * Math.ceil(this.height / size) },
      () => 1 + (next() * 2 - 1) * amount,
    );
    for (let i = 0; i < this.data.length; i++) {
      const pixel = i >> 2;
      const k =
        patches[Math.floor(Math.floor(pixel / this.width) / size) * columns + Math.floor((pixel % this.width) / size)];
      if ((i & 3) !== 3) this.data[i] = Math.max(0, Math.min(255, Math.round(this.data[i] * k)));
    }
    return this;
  }

  texture(name: string, options: Partial<Pick<Texture, 'filter' | 'wrapS' | 'wrapT'>> = {}): Texture {
    const { width, height, data } = this;
    return {
      name: `${name}.png`,
      width,
      height,
      data,
      colorSpace: 'srgb',
      filter: 'linear',
      wrapS: 'repeat',
      wrapT: 'repeat',
      ...options,
    };
  }
}

/** A checkerboard of 2 × 2 squares. */
export function checker(light: string, dark: string, name: string, fields = 2, cell = 32): Texture {
  const side = fields * cell;
  return new Canvas(side, side, dark).squares(0, 0, fields, cell, light).texture(name);
}

/** Running bond of `rows` courses; `columns` bricks in each. */
export function bricks(brick: string, mortar: string, name: string, columns = 4, rows = 8, cell = 32): Texture {
  const canvas = new Canvas(columns * cell, rows * (cell / 2), mortar);
  const next = random(7);
  for (let j = 0; j < rows; j++)
    for (let i = -1; i < columns; i++) {
      const x = (i + (j % 2) / 2) * cell;
      const y = j * (cell / 2);
      const color = tone(brick, 0.86 + 0.24 * next());
      canvas.rect(x + 1, y + 1, x + cell - 1, y + cell / 2 - 1, color);
      if (i === -1) canvas.rect(x + columns * cell + 1, y + 1, x + (columns + 1) * cell - 1, y + cell / 2 - 1, color);
    }
  return canvas.texture(name);
}

/** Overlapping rows of roof tiles. */
export function roofTiles(color: string, name: string): Texture {
  const size = 128;
  const canvas = new Canvas(size, size, color);
  const next = random(11);
  const [rows, columns] = [8, 8];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const [w, h] = [size / columns, size / rows];
      const x = i * w + ((j % 2) * w) / 2;
      const base = tone(color, 0.84 + 0.3 * next());
      for (const left of [x, x - size]) {
        canvas.rect(left, j * h, left + w - 1, (j + 1) * h - 2, base);
        canvas.rect(left, (j + 1) * h - 2, left + w, (j + 1) * h, tone(color, 0.5));
        canvas.rect(left, j * h, left + w - 1, j * h + 2, tone(color, 0.68));
      }
    }
  return canvas.texture(name);
}
