import { abs, clamp, float, floor, max, mix, select, step, vec2, vec3, vec4 } from 'three/tsl';
import { INSET, type MixMode, WIPE_WIDTH } from '../../scene/frameGraph/effects.ts';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import { type EffectContext, type EffectImage, mixExact } from './effectContext.ts';

type ColorBlend = (a: Vec3, b: Vec3) => Vec3;

const clampedToUnit = (value: Vec3): Vec3 => clamp(value, 0, 1).toVar();
const excessOverOne = (value: Vec3): Vec3 => max(value.sub(1), vec3(0));
const over: ColorBlend = (_, b) => b;

const BLENDS: Readonly<Record<MixMode, ColorBlend>> = {
  normal: over,
  multiply: (a, b) => a.mul(b),
  add: (a, b) => a.add(b),
  screen: (a, b) =>
    clampedToUnit(a).oneMinus().mul(clampedToUnit(b).oneMinus()).oneMinus().add(excessOverOne(a)).add(excessOverOne(b)),
  overlay: (a, b) => {
    const [p, q] = [clampedToUnit(a), clampedToUnit(b)];
    const light = p.oneMinus().mul(q.oneMinus()).mul(2).oneMinus();
    return mix(p.mul(q).mul(2), light, step(vec3(0.5), p)).add(excessOverOne(a));
  },
  difference: (a, b) => abs(a.sub(b)),
  split: over,
  wipe: over,
  inset: over,
};

/** `mixed` of src/reference/post/effects/: the frame's image is below, `b` over it. */
export function mixImages(frame: EffectContext, mode: MixMode, alpha: Float, b: EffectImage, mask?: EffectImage): Vec4 {
  const below = frame.image.at(frame.pixel).toVar();
  if (mode === 'inset') {
    const { cover, color } = insetPicture(frame, alpha, b);
    const weight = mask ? clamp(mask.at(frame.pixel).x, 0, 1) : float(1);
    return mixExact(below, vec4(color, below.w), cover.mul(weight).toVar());
  }
  const blend = BLENDS[mode](below.rgb, b.at(frame.pixel).rgb.toVar());
  const maskWeight = mask ? clamp(mask.at(frame.pixel).x, 0, 1) : float(1);
  return mixExact(below, vec4(blend, below.w), mixWeight(frame, mode, alpha).mul(maskWeight).toVar());
}

function mixWeight(frame: EffectContext, mode: MixMode, alpha: Float): Float {
  const across = float(frame.pixel.x).add(0.5).div(float(frame.image.size.x));
  if (mode === 'split') return select(across.lessThan(alpha), 0, 1);
  if (mode === 'wipe')
    return clamp(
      alpha
        .mul(1 + WIPE_WIDTH)
        .sub(across)
        .div(WIPE_WIDTH),
      0,
      1,
    );
  return alpha;
}

/** `insetPicture` of src/reference/post/effects/mix.ts. `cover`: 1 in the inset and its border, else 0. */
function insetPicture(
  frame: EffectContext,
  share: Float,
  b: EffectImage,
): { readonly cover: Float; readonly color: Vec3 } {
  const { margin, border, color, samples } = INSET;
  const { size } = frame.image;
  const scale = size.y.div(1080).toVar();
  const extent = size.mul(share).toVar();
  const corner = size.sub(extent).sub(scale.mul(margin)).toVar();
  const place = frame.pixel.add(0.5).sub(corner).toVar();
  const beyond = max(place.negate(), place.sub(extent)).toVar();
  const outside = max(beyond.x, beyond.y).toVar();
  const steps = Array.from({ length: samples }, (_, i) => (i + 0.5) / samples);
  const texels = steps.flatMap((j) =>
    steps.map((i) => b.at(floor(frame.pixel.add(vec2(i, j)).sub(corner).div(max(share, 1e-6)))).rgb),
  );
  const mean = texels
    .reduce((sum, texel) => sum.add(texel))
    .div(samples ** 2)
    .toVar();
  const covers = outside.lessThanEqual(scale.mul(border)).and(share.greaterThan(0));
  return { cover: select(covers, 1, 0), color: select(outside.greaterThan(0), vec3(...color), mean) };
}
