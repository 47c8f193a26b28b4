import { fitStill, type StillPixels } from '../../scene/frameGraph/still.ts';
import { FloatImage } from './effects/effectInput.ts';

/** A still resampled to the size of the picture; see `StillFit`. */
export function stillImage(still: StillPixels, width: number, height: number): FloatImage {
  const { scale, reach, offset } = fitStill(still, width, height);
  return FloatImage.of(width, height, 3, (px, py) => {
    const [x, y] = [scale * px + offset[0], scale * py + offset[1]];
    const sum = [0, 0, 0];
    if (x < -0.5 || x > still.width - 0.5) return sum;
    let total = 0;
    for (const [row, high] of tent(y, reach, still.height))
      for (const [column, wide] of tent(x, reach, still.width)) {
        const i = 3 * (row * still.width + column);
        for (let k = 0; k < 3; k++) sum[k]! += high * wide * still.pixels[i + k]!;
        total += high * wide;
      }
    return sum.map((value) => value / total);
  });
}

/** The pixels of 0 … n − 1 within `reach` of a position, with tent weights: 1 at the position, 0 at the distance `reach`. */
function tent(position: number, reach: number, n: number): [pixel: number, weight: number][] {
  const first = Math.max(Math.ceil(position - reach), 0);
  const last = Math.min(Math.floor(position + reach), n - 1);
  return Array.from({ length: last - first + 1 }, (_, i) => [first + i, 1 - Math.abs(first + i - position) / reach]);
}
