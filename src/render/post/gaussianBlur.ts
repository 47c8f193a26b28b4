import { abs, ceil, cos, exp, float, floor, If, int, Loop, max, mix, select, sin, vec2, vec4 } from 'three/tsl';
import { GAUSSIAN_CUTOFF } from '../../scene/frameGraph/effects.ts';
import type { Float, Int, Vec4 } from '../../shaders/types.ts';
import { singleStep } from './effect.ts';

/** `gaussianBlur` of src/reference/post/effects/. */
export const gaussianBlur = singleStep((frame) => {
  const [sigma, degrees] = frame.args;
  const angle = degrees.mul(Math.PI / 180).toVar();
  const right = cos(angle).toVar();
  const down = sin(angle).negate().toVar();
  const isHorizontal = abs(right).greaterThanEqual(abs(down)).toVar();
  const exact = select(isHorizontal, down.div(right), right.div(down)).toVar();
  // The cosine of a right angle is not exactly 0.
  const slope = select(abs(exact).lessThan(1e-5), 0, exact).toVar();
  const [horizontal, vertical] = [vec2(1, 0), vec2(0, 1)];
  const forward = select(isHorizontal, horizontal, vertical).toVar();
  const sideward = select(isHorizontal, vertical, horizontal).toVar();
  const spacing = max(abs(right), abs(down)).reciprocal();
  const blurred = vec4(0).toVar();
  If(slope.equal(0), () => {
    blurred.assign(gaussianMean(sigma, spacing, (k) => frame.image.at(frame.pixel.add(forward.mul(float(k))))));
  }).Else(() => {
    const between = (k: Int): Vec4 => {
      const offset = float(k).mul(slope).toVar();
      const lower = floor(offset).toVar();
      const pixel = frame.pixel
        .add(forward.mul(float(k)))
        .add(sideward.mul(lower))
        .toVar();
      return mix(frame.image.at(pixel), frame.image.at(pixel.add(sideward)), offset.sub(lower));
    };
    blurred.assign(gaussianMean(sigma, spacing, between));
  });
  return blurred;
});

/** The mean of the taps −r … r, weighted by a Gaussian and by `likeness`. */
export function gaussianMean(
  sigma: Float,
  spacing: Float,
  tap: (k: Int) => Vec4,
  likeness: (k: Int) => Float = () => float(1),
): Vec4 {
  const step = spacing.div(max(sigma, 1e-3)).toVar();
  const reach = int(ceil(float(GAUSSIAN_CUTOFF).div(step).sub(1e-3))).toVar();
  const sum = vec4(0).toVar();
  const total = float(0).toVar();
  Loop({ start: reach.negate(), end: reach, type: 'int', condition: '<=' }, ({ i: k }: { i: Int }) => {
    const distance = float(k).mul(step).toVar();
    const weight = exp(distance.mul(distance).mul(-0.5)).mul(likeness(k)).toVar();
    sum.addAssign(tap(k).mul(weight));
    total.addAssign(weight);
  });
  return sum.div(total);
}
