import { linearizationTable } from '../../../scene/materials/sampleTexture.ts';
import type { DomeLight } from '../../../scene/types.ts';

/** Linear sRGB of all directions: rows from the zenith down, columns around the zenith; 3 numbers per pixel. */
export interface Panorama {
  readonly width: number;
  readonly height: number;
  readonly rgb: Float32Array;
}

/** Size of the panoramas that are convolved. */
export const PREFILTER_SIZE = { width: 128, height: 64 } as const;

/** Roughnesses for which the dome is prefiltered, with the columns of the map that is convolved. */
export const SPECULAR_LOBES = [
  { roughness: 0.25, columns: 128 },
  { roughness: 0.5, columns: 64 },
  { roughness: 0.75, columns: 32 },
  { roughness: 1, columns: 32 },
] as const;

/** A dome's prefiltered radiance, one panorama for each of `SPECULAR_LOBES`, and as the last one irradiance/π by normal. */
export function prefilterDome(picture: NonNullable<DomeLight['texture']>): readonly Panorama[] {
  const whole = reducedDome(picture, PREFILTER_SIZE);
  const lobes = SPECULAR_LOBES.map(({ roughness, columns }) => convolve(halveTo(whole, columns), ggxLobe(roughness)));
  return [...lobes, convolve(halveTo(whole, 32), (cosine) => Math.max(cosine, 0))].map((map) =>
    resize(map, PREFILTER_SIZE),
  );
}

/** GGX about the mirrored direction for N = V = R, times the cosine (Karis 2013, "Real shading in Unreal Engine 4"). */
const ggxLobe = (roughness: number) => {
  const a2 = roughness ** 4;
  return (cosine: number): number => {
    // cos² of the half vector's angle, half that of the direction.
    const h2 = (1 + cosine) / 2;
    return Math.max(cosine, 0) * (a2 / (h2 * (a2 - 1) + 1)) ** 2;
  };
};

/** Means over blocks of the texture; the pixels of a smaller texture repeat. */
export function reducedDome(
  picture: NonNullable<DomeLight['texture']>,
  { width, height }: Pick<Panorama, 'width' | 'height'>,
): Panorama {
  const { data } = picture;
  const linear = linearizationTable(picture);
  const rgb = new Float32Array(3 * width * height);
  for (let y = 0; y < height; y++) {
    const [top, bottom] = blockOf(y, height, picture.height);
    for (let x = 0; x < width; x++) {
      const [left, right] = blockOf(x, width, picture.width);
      let [r, g, b] = [0, 0, 0];
      for (let v = top; v < bottom; v++)
        for (let i = 4 * (v * picture.width + left); i < 4 * (v * picture.width + right); i += 4) {
          r += linear[data[i]];
          g += linear[data[i + 1]];
          b += linear[data[i + 2]];
        }
      const count = (bottom - top) * (right - left);
      rgb.set([r / count, g / count, b / count], 3 * (y * width + x));
    }
  }
  return { width, height, rgb };
}

/** The range of `from` pixels that the i-th of `to` pixels covers; at least one. */
function blockOf(i: number, to: number, from: number): readonly [number, number] {
  const first = Math.floor((i * from) / to);
  return [first, Math.max(first + 1, Math.floor(((i + 1) * from) / to))];
}

/** Halves the map until it has at most `columns` columns; rows are weighted by their circumference on the sphere. */
function halveTo(map: Panorama, columns: number): Panorama {
  if (map.width <= columns) return map;
  const [width, height] = [map.width / 2, map.height / 2];
  const rgb = new Float32Array(3 * width * height);
  for (let y = 0; y < height; y++) {
    const weights = [0, 1].map((row) => Math.sin((Math.PI * (2 * y + row + 0.5)) / map.height));
    const whole = 2 * (weights[0] + weights[1]);
    for (let x = 0; x < width; x++)
      for (let k = 0; k < 3; k++) {
        const at = (row: number, column: number): number =>
          weights[row] * map.rgb[3 * ((2 * y + row) * map.width + 2 * x + column) + k];
        rgb[3 * (y * width + x) + k] = (at(0, 0) + at(0, 1) + at(1, 0) + at(1, 1)) / whole;
      }
  }
  return halveTo({ width, height, rgb }, columns);
}

/** Fraction of its maximum below which a lobe is cut off. */
const MIN_LOBE_WEIGHT = 1e-3;

/** The mean around each direction, weighted by `lobe` of the cosine of the angle between the two; the weights are the same for all pixels of a row. */
function convolve({ width, height, rgb }: Panorama, lobe: (cosine: number) => number): Panorama {
  const out = new Float32Array(rgb.length);
  const angle = (row: number): number => (Math.PI * (row + 0.5)) / height;
  const least = MIN_LOBE_WEIGHT * lobe(1);
  const weights = new Float64Array(width);
  for (let y = 0; y < height; y++) {
    const [c, s] = [Math.cos(angle(y)), Math.sin(angle(y))];
    let whole = 0;
    for (let v = 0; v < height; v++) {
      const [cv, sv] = [Math.cos(angle(v)), Math.sin(angle(v))];
      let far = 0;
      for (let d = 0; d < width; d++) {
        const value = lobe(c * cv + s * sv * Math.cos((2 * Math.PI * d) / width));
        weights[d] = value > least ? value * sv : 0;
        whole += weights[d];
        if (weights[d] > 0 && d <= width / 2) far = d + 1;
      }
      addRow(out, rgb, width, y, v, weights, far);
    }
    for (let i = 3 * y * width; i < 3 * (y + 1) * width; i++) out[i] /= whole;
  }
  return { width, height, rgb: out };
}

/** Adds row v of a panorama to row y of another; `weights` by distance in columns, 0 from `far` columns on. */
function addRow(
  out: Float32Array,
  rgb: Float32Array,
  width: number,
  y: number,
  v: number,
  weights: Float64Array,
  far: number,
): void {
  if (far === 0) return;
  const row = rgb.subarray(3 * v * width, 3 * (v + 1) * width);
  // Two copies, so that neighbours beyond the seam are contiguous.
  const ring = new Float32Array(6 * width);
  ring.set(row);
  ring.set(row, 3 * width);
  // The opposite column counts once.
  const first = far > width / 2 ? 1 - width / 2 : 1 - far;
  const last = Math.min(far - 1, width / 2);
  for (let x = 0; x < width; x++) {
    let [r, g, b] = [0, 0, 0];
    let from = 3 * (x + first < 0 ? x + first + width : x + first);
    for (let d = first; d <= last; d++, from += 3) {
      const weight = weights[d < 0 ? -d : d];
      r += weight * ring[from];
      g += weight * ring[from + 1];
      b += weight * ring[from + 2];
    }
    const at = 3 * (y * width + x);
    out[at] += r;
    out[at + 1] += g;
    out[at + 2] += b;
  }
}

/** Index of a pixel's first number: columns wrap, and rows beyond a pole continue on its other side. */
export function pixelOffset({ width, height }: Panorama, row: number, column: number): number {
  const beyond = row < 0 || row >= height;
  const y = row < 0 ? -1 - row : row >= height ? 2 * height - 1 - row : row;
  return 3 * (y * width + ((column + (beyond ? width / 2 : 0) + width) % width));
}

/** Bilinear, to a larger size. */
export function resize(map: Panorama, { width, height }: Pick<Panorama, 'width' | 'height'>): Panorama {
  if (map.width === width) return map;
  const rgb = new Float32Array(3 * width * height);
  for (let y = 0; y < height; y++) {
    const v = ((y + 0.5) * map.height) / height - 0.5;
    const row = Math.floor(v);
    for (let x = 0; x < width; x++) {
      const u = ((x + 0.5) * map.width) / width - 0.5;
      const column = Math.floor(u);
      const at = (j: number, i: number, k: number): number => map.rgb[pixelOffset(map, row + j, column + i) + k];
      const [s, t] = [u - column, v - row];
      for (let k = 0; k < 3; k++)
        rgb[3 * (y * width + x) + k] =
          (1 - t) * ((1 - s) * at(0, 0, k) + s * at(0, 1, k)) + t * ((1 - s) * at(1, 0, k) + s * at(1, 1, k));
    }
  }
  return { width, height, rgb };
}
