import { radians } from '../../../math/angle.ts';
import { dot } from '../../../math/vec3.ts';
import { FloatImage, type GBufferReader } from './effectInput.ts';
import { gaussianWeights } from './gaussianBlur.ts';

/**
 * A Gaussian along rows, then along columns, that does not blur across edges: each neighbour's weight is multiplied by
 * exp(−½ (Δd/(ρ d))²) exp(−(1 − n·n₀)/α²) with the apparent distances d and the normals n; between sky and surfaces it is 0. Intended for noise of
 * ambient occlusion. arg1: σ [px]; arg2: ρ, 0 ignores distances; arg3: α [°], 0 ignores normals. With both 0 it is the Gaussian.
 * Source: Tomasi & Manduchi 1998; separated as by Pham & van Vliet 2005.
 */
export function bilateralFilter(
  frame: GBufferReader,
  [sigma = 0, depthRange = 0, normalRange = 0]: readonly number[],
): FloatImage {
  const edgeWeight = createEdgeWeight(frame, depthRange, radians(normalRange));
  const weights = gaussianWeights(sigma, 1);
  const reach = weights.length >> 1;
  const along = (from: FloatImage, dx: number, dy: number): FloatImage =>
    from.map((x, y) => {
      const sum = [0, 0, 0];
      let total = 0;
      for (let k = -reach; k <= reach; k++) {
        const weight = weights[k + reach]! * edgeWeight(x, y, x + k * dx, y + k * dy);
        from.at(x + k * dx, y + k * dy).forEach((value, c) => {
          sum[c]! += weight * value;
        });
        total += weight;
      }
      return sum.map((value) => value / total);
    });
  return along(along(frame.image, 1, 0), 0, 1);
}

/** Returns the edge-stopping weight of two pixels, 0 … 1. */
function createEdgeWeight(frame: GBufferReader, depthRange: number, normalRange: number) {
  const { width, height } = frame.image;
  if (depthRange <= 0 && normalRange <= 0) return () => 1;
  const there = FloatImage.of(width, height, 1, (x, y) => [frame.isCovered(x, y) ? 1 : 0]);
  return (x: number, y: number, i: number, j: number): number => {
    const [here, other] = [there.at(x, y)[0], there.at(i, j)[0]];
    if (here !== other) return 0;
    if (!here) return 1;
    const d = frame.depth(x, y);
    const far = depthRange > 0 ? (frame.depth(i, j) - d) / (depthRange * d) : 0;
    const turned = normalRange > 0 ? (1 - dot(frame.normal(x, y), frame.normal(i, j))) / normalRange ** 2 : 0;
    return Math.exp(-0.5 * far * far - turned);
  };
}
