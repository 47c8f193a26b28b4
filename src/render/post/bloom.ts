import { abs, ceil, clamp, floor, mix, step, vec2, vec4 } from 'three/tsl';
import { BLOOM_LEVELS } from '../../scene/frameGraph/effects.ts';
import type { Float, Vec2, Vec4 } from '../../shaders/types.ts';
import type { Effect, EffectStep } from './effect.ts';
import type { EffectContext, EffectImage } from './effectContext.ts';

/** Offsets of the texels that read a texel when upsampling. */
const UPSAMPLE_OFFSETS = [-1, 0, 1, 2];
const levels = Array.from({ length: BLOOM_LEVELS }, (_, k) => k + 1);
const levelImage = (frame: EffectContext, k: number): EffectImage =>
  k === 0 ? frame.image : frame.stepImage(`half ${k}`);

/** `bloom` of src/reference/post/effects/. */
export const bloom: Effect = [
  ...levels.map(
    (k): EffectStep => ({
      name: `half ${k}`,
      downscale: 2 ** k,
      color: (frame) => downsample(frame, levelImage(frame, k - 1), k > 1),
    }),
  ),
  ...levels
    .slice(0, -1)
    .reverse()
    .map(
      (k): EffectStep => ({ name: `wide ${k}`, downscale: 2 ** k, color: (frame) => blend(frame, k, frame.args[1]) }),
    ),
  { name: 'result', downscale: 1, color: (frame) => blend(frame, 0, frame.args[0]) },
];

/** Level k, mixed with a fraction of the wider levels. */
function blend(frame: EffectContext, k: number, fraction: Float): Vec4 {
  const wide = k + 1 === BLOOM_LEVELS ? levelImage(frame, BLOOM_LEVELS) : frame.stepImage(`wide ${k + 1}`);
  return mix(levelImage(frame, k).at(frame.pixel), upsample(frame, wide), fraction);
}

/** (colour, μ/4ᵏ), from the 4 × 4 texels that read this one when upsampling. `measured`: they have a μ other than 1. */
function downsample(frame: EffectContext, from: EffectImage, measured: boolean): Vec4 {
  const sum = vec4(0).toVar();
  for (const j of UPSAMPLE_OFFSETS)
    for (const i of UPSAMPLE_OFFSETS) {
      const fine = frame.pixel.mul(2).add(vec2(i, j)).toVar();
      const texel = from.at(fine).toVar();
      const weights = upsampleWeights(fine, frame.pixel, from.size).toVar();
      const weight = measured ? weights.x.mul(weights.y).mul(texel.w) : weights.x.mul(weights.y);
      sum.addAssign(vec4(texel.rgb, 1).mul(weight));
    }
  return vec4(sum.rgb.div(sum.w), sum.w.div(4));
}

/** Weight of the texel `coarse` in the texel `fine` when upsampling, along each axis: ¾ of the one above it, ¼ of the next one within the image. */
function upsampleWeights(fine: Vec2, coarse: Vec2, size: Vec2): Vec2 {
  const own = floor(fine.div(2)).toVar();
  const aside = own.add(fine.sub(own.mul(2)).mul(2).sub(1));
  const next = clamp(aside, vec2(0), ceil(size.div(2)).sub(1));
  const same = (a: Vec2): Vec2 => step(abs(a.sub(coarse)), vec2(0.5));
  const inside = step(vec2(0), fine).mul(step(fine, size.sub(1)));
  return same(own).mul(0.75).add(same(next).mul(0.25)).mul(inside);
}

function upsample(frame: EffectContext, from: EffectImage): Vec4 {
  const own = floor(frame.pixel.div(2)).toVar();
  const beside = frame.pixel.sub(own.mul(2)).mul(2).sub(1).toVar();
  const [x, y] = [vec2(beside.x, 0), vec2(0, beside.y)];
  const near = from.at(own.add(x)).add(from.at(own.add(y)));
  return from
    .at(own)
    .mul(9)
    .add(near.mul(3))
    .add(from.at(own.add(beside)))
    .div(16);
}
