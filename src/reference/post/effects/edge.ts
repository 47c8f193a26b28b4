import { dot } from '../../../math/vec3.ts';
import { relativeLuminance } from '../../../scene/view/metering.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

const SIDES = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;

/**
 * Lines where luminance changes (its Sobel gradient divided by its mean), at depth discontinuities, on the near side (the second difference of 1/d,
 * which is linear across a plane, divided by 1/d), and where normals change. arg1 … arg3: the strength of each; arg4: 0 outputs white lines on black,
 * 1 draws black lines on the picture.
 */
export function edge(
  frame: GBufferReader,
  [light = 0, depth = 0, normal = 0, under = 0]: readonly number[],
): FloatImage {
  return frame.image.map((x, y) => {
    const strength = light * lightEdge(frame, x, y) + depth * depthEdge(frame, x, y) + normal * normalEdge(frame, x, y);
    const line = Math.min(Math.max(strength, 0), 1);
    return frame.image.at(x, y).map((value) => line + under * (value * (1 - line) - line));
  });
}

function lightEdge({ image }: GBufferReader, x: number, y: number): number {
  const L = (i: number, j: number): number => {
    const [r, g, b] = image.at(x + i, y + j);
    return relativeLuminance(r!, g!, b!);
  };
  const column = (i: number): number => L(i, -1) + 2 * L(i, 0) + L(i, 1);
  const row = (j: number): number => L(-1, j) + 2 * L(0, j) + L(1, j);
  const mean = (column(-1) + 2 * column(0) + column(1)) / 16;
  return Math.hypot(column(1) - column(-1), row(1) - row(-1)) / 8 / (mean + 1e-4);
}

function depthEdge(frame: GBufferReader, x: number, y: number): number {
  if (!frame.isCovered(x, y)) return 0;
  const inverse = (i: number, j: number): number => (frame.isCovered(i, j) ? 1 / frame.depth(i, j) : 0);
  const here = inverse(x, y);
  const bend = (i: number, j: number): number => 2 * here - inverse(x + i, y + j) - inverse(x - i, y - j);
  return Math.max(bend(1, 0), bend(0, 1), 0) / here;
}

/** The mean of (1 − n·n₀)/2 over the four neighbours. */
function normalEdge(frame: GBufferReader, x: number, y: number): number {
  if (!frame.isCovered(x, y)) return 0;
  const turned = SIDES.map(([i, j]) =>
    frame.isCovered(x + i, y + j) ? (1 - dot(frame.normal(x, y), frame.normal(x + i, y + j))) / 2 : 0,
  );
  return turned.reduce((a, b) => a + b) / 4;
}
