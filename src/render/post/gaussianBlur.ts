import { abs, ceil, cos, exp, float, floor, If, int, Loop, max, mix, select, sin, vec2, vec4 } from 'three/tsl';
import { GAUSSIAN_CUTOFF } from '../../scene/frameGraph/effects.ts';
import type { Float, Int, Vec4 } from '../../shaders/types.ts';
import { singleStep } from './effect.ts';

/** `gaussianBlur` of reference/effects/. */
export const gaussianBlur = singleStep((frame) => {
  const [sigma, degrees] = frame.args;
  const angle = degrees.mul(Math.PI / 180).toVar();
  const right = cos(angle).toVar();
  const down = sin(angle).negate().toVar();
  const across = abs(right).greaterThanEqual(abs(down)).toVar();
  const exact = select(across, down.div(right), right.div(down)).toVar();
  // What the cosine of a right angle falls short of 0.
  const slope = select(abs(exact).lessThan(1e-5), 0, exact).toVar();
  const [along, aside] = [vec2(1, 0), vec2(0, 1)];
  const forward = select(across, along, aside).toVar();
  const sideward = select(across, aside, along).toVar();
  const spacing = max(abs(right), abs(down)).reciprocal();
  const blurred = vec4(0).toVar();
  If(slope.equal(0), () => {
    blurred.assign(gaussianMean(sigma, spacing, (k) => frame.image.at(frame.pixel.add(forward.mul(float(k))))));
  }).Else(() => {
    const between = (k: Int): Vec4 => {
      const off = float(k).mul(slope).toVar();
      const near = floor(off).toVar();
      const pixel = frame.pixel
        .add(forward.mul(float(k)))
        .add(sideward.mul(near))
        .toVar();
      return mix(frame.image.at(pixel), frame.image.at(pixel.add(sideward)), off.sub(near));
    };
    blurred.assign(gaussianMean(sigma, spacing, between));
  });
  return blurred;
});

/** The mean of what is found at the taps −r … r, under a Gaussian; `likeness` weighs each once more. */
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
    const away = float(k).mul(step).toVar();
    const weight = exp(away.mul(away).mul(-0.5)).mul(likeness(k)).toVar();
    sum.addAssign(tap(k).mul(weight));
    total.addAssign(weight);
  });
  return sum.div(total);
}
