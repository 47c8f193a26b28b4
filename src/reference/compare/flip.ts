import { radians } from '../../math/angle.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { fromXyz, lab, toXyz } from './colorSpaces.ts';
import { alongColumns, alongRows, type ConvolutionKernel, kernelOf } from './convolve.ts';
import type { RgbImage } from './rgbImage.ts';

/**
 * ꟻLIP, the perceived difference of two pictures that are shown alternately: per pixel, 0 none … 1 the largest possible.
 * ΔE = ΔE_c^(1 − ΔE_f): the colour difference after contrast sensitivity filters, increased by the difference of edges and points.
 * Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild, "ꟻLIP: A Difference Evaluator for Alternating
 * Images", Proc. ACM CGIT 3 (2020) 15; equations and constants of its section 4.
 */

/** For a screen 0.7 m wide with 3840 pixels, viewed from 0.7 m (section 4.1). */
export const PIXELS_PER_DEGREE = radians(0.7 * (3840 / 0.7));

/** Both pictures: linear sRGB as displayed, 0 … 1. Symmetric. */
export function flip(a: RgbImage, b: RgbImage, pixelsPerDegree = PIXELS_PER_DEGREE): Float32Array {
  const color = colorDifference(a, b, pixelsPerDegree);
  const feature = featureDifference(luminances(a), luminances(b), a.width, a.height, pixelsPerDegree);
  return color.map((difference, i) => difference ** (1 - feature[i]));
}

// ── Colour (4.1) ───────────────────────────────────────────────────────────────────────────────────────────────────

interface Gaussian {
  /** Weight, and width [degrees²], of a·√(π/b)·exp(−π²x²/b), x in degrees. */
  readonly a: number;
  readonly b: number;
}
/** Contrast sensitivity of the achromatic, red–green and blue–yellow channels: table 1. */
const LIGHT_DARK: readonly Gaussian[] = [{ a: 1, b: 0.0047 }];
const RED_GREEN: readonly Gaussian[] = [{ a: 1, b: 0.0053 }];
const BLUE_YELLOW: readonly Gaussian[] = [
  { a: 34.1, b: 0.04 },
  { a: 13.5, b: 0.025 },
];
const WIDEST = 0.04;

/** Exponent that expands small differences; differences below `KNEE` times the largest are mapped to 0 … `KNEE_VALUE`. */
const COLOR_EXPONENT = 0.7;
const KNEE = 0.4;
const KNEE_VALUE = 0.95;
/** The largest difference in the gamut: between green and blue. */
const LARGEST = difference(perceived([0, 1, 0]), perceived([0, 0, 1])) ** COLOR_EXPONENT;

function colorDifference(a: RgbImage, b: RgbImage, pixelsPerDegree: number): Float32Array {
  const [filteredA, filteredB] = [filteredOpponents(a, pixelsPerDegree), filteredOpponents(b, pixelsPerDegree)];
  return Float32Array.from({ length: a.width * a.height }, (_, i) =>
    redistribute(difference(perceivedAt(filteredA, i), perceivedAt(filteredB, i)) ** COLOR_EXPONENT),
  );
}

/** Y, X − Y and Y − Z, with X, Y, Z divided by those of white: YCxCz up to constants, which filters of sum 1 preserve. */
type Opponents = readonly [Float32Array, Float32Array, Float32Array];

function filteredOpponents(picture: RgbImage, pixelsPerDegree: number): Opponents {
  const { width, height } = picture;
  const [y, redGreen, blueYellow] = opponents(picture);
  const filtered = (plane: Float32Array, parts: readonly Gaussian[]) =>
    sumOfGaussians(plane, width, height, parts, pixelsPerDegree);
  return [filtered(y, LIGHT_DARK), filtered(redGreen, RED_GREEN), filtered(blueYellow, BLUE_YELLOW)];
}

function opponents({ rgb }: RgbImage): Opponents {
  const pixels = rgb.length / 3;
  const planes: Opponents = [new Float32Array(pixels), new Float32Array(pixels), new Float32Array(pixels)];
  for (let i = 0; i < pixels; i++) {
    const [x, y, z] = toXyz([rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]]);
    planes[0][i] = y;
    planes[1][i] = x - y;
    planes[2][i] = y - z;
  }
  return planes;
}

/** Filters in two dimensions by a sum of separable Gaussians; radius: three standard deviations of the widest of all. */
function sumOfGaussians(
  plane: Float32Array,
  width: number,
  height: number,
  parts: readonly Gaussian[],
  pixelsPerDegree: number,
): Float32Array {
  const radius = Math.ceil(3 * Math.sqrt(WIDEST / (2 * Math.PI ** 2)) * pixelsPerDegree);
  const shape = ({ b }: Gaussian, x: number) => Math.exp(-((Math.PI * x) ** 2) / (b * pixelsPerDegree ** 2));
  const mass = (part: Gaussian) => {
    let sum = 0;
    for (let x = -radius; x <= radius; x++) sum += shape(part, x);
    return part.a * Math.sqrt(Math.PI / part.b) * sum ** 2;
  };
  const total = parts.reduce((sum, part) => sum + mass(part), 0);
  const out = new Float32Array(plane.length);
  for (const part of parts) {
    const kernel = kernelOf(radius, (x) => shape(part, x));
    const weight = mass(part) / total;
    const filtered = alongColumns(alongRows(plane, width, height, kernel), width, height, kernel);
    for (let i = 0; i < out.length; i++) out[i] += weight * filtered[i];
  }
  return out;
}

function perceivedAt([light, redGreen, blueYellow]: Opponents, i: number): Vec3 {
  const y = light[i];
  const [r, g, b] = fromXyz([redGreen[i] + y, y, y - blueYellow[i]]);
  return perceived([clamp(r), clamp(g), clamp(b)]);
}

const clamp = (x: number): number => Math.min(Math.max(x, 0), 1);

/** L*a*b* with the Hunt effect: darker colours are less colourful (4.1.2). */
function perceived(rgb: Vec3): Vec3 {
  const [L, a, b] = lab(toXyz(rgb));
  return [L, 0.01 * L * a, 0.01 * L * b];
}

/** HyAB: |ΔL| + √(Δa² + Δb²), which is valid for large differences too (4.1.3). */
function difference(p: Vec3, q: Vec3): number {
  return Math.abs(p[0] - q[0]) + Math.hypot(p[1] - q[1], p[2] - q[2]);
}

/** Maps 0 … largest to 0 … 1, piecewise linear, so that rare large differences take little of the range (4.1.4). */
function redistribute(value: number): number {
  const knee = KNEE * LARGEST;
  return value < knee
    ? (KNEE_VALUE / knee) * value
    : KNEE_VALUE + ((value - knee) / (LARGEST - knee)) * (1 - KNEE_VALUE);
}

// ── Edges and points (4.2) ─────────────────────────────────────────────────────────────────────────────────────────

/** Width of a just visible edge [degrees]. */
const FEATURE_WIDTH = 0.082;
const FEATURE_EXPONENT = 0.5;

function luminances({ rgb }: RgbImage): Float32Array {
  return Float32Array.from(
    { length: rgb.length / 3 },
    (_, i) => toXyz([rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]])[1],
  );
}

/** ((1/√2) · max(edge difference, point difference))^½ */
function featureDifference(
  a: Float32Array,
  b: Float32Array,
  width: number,
  height: number,
  pixelsPerDegree: number,
): Float32Array {
  const [ofA, ofB] = [features(a, width, height, pixelsPerDegree), features(b, width, height, pixelsPerDegree)];
  return Float32Array.from(a, (_, i) => {
    const edge = Math.abs(ofA.edges[i] - ofB.edges[i]);
    const point = Math.abs(ofA.points[i] - ofB.points[i]);
    return (Math.max(edge, point) / Math.SQRT2) ** FEATURE_EXPONENT;
  });
}

/** Lengths of the vectors of first derivatives (edges) and of second derivatives (points) in x and y of the Gaussian-smoothed picture. */
function features(plane: Float32Array, width: number, height: number, pixelsPerDegree: number) {
  const deviation = 0.5 * FEATURE_WIDTH * pixelsPerDegree;
  const radius = Math.ceil(3 * deviation);
  const gaussian = (x: number) => Math.exp(-(x * x) / (2 * deviation ** 2));
  const smooth = kernelOf(radius, gaussian);
  const both = (derivative: ConvolutionKernel) => {
    const x = alongColumns(alongRows(plane, width, height, derivative), width, height, smooth);
    const y = alongColumns(alongRows(plane, width, height, smooth), width, height, derivative);
    return x.map((value, i) => Math.hypot(value, y[i]));
  };
  return {
    edges: both(kernelOf(radius, (x) => -x * gaussian(x))),
    points: both(kernelOf(radius, (x) => (x ** 2 / deviation ** 2 - 1) * gaussian(x))),
  };
}
