import { abs, clamp, float, max, mix, select, step, vec3, vec4 } from 'three/tsl';
import { type MixMode, WIPE_WIDTH } from '../../scene/effects.ts';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import { between, type Frame, type Picture } from './frame.ts';

type Blend = (a: Vec3, b: Vec3) => Vec3;

const within = (value: Vec3): Vec3 => clamp(value, 0, 1).toVar();
const above = (value: Vec3): Vec3 => max(value.sub(1), vec3(0));
const over: Blend = (_, b) => b;

const BLENDS: Readonly<Record<MixMode, Blend>> = {
  normal: over,
  multiply: (a, b) => a.mul(b),
  add: (a, b) => a.add(b),
  screen: (a, b) => within(a).oneMinus().mul(within(b).oneMinus()).oneMinus().add(above(a)).add(above(b)),
  overlay: (a, b) => {
    const [p, q] = [within(a), within(b)];
    const light = p.oneMinus().mul(q.oneMinus()).mul(2).oneMinus();
    return mix(p.mul(q).mul(2), light, step(vec3(0.5), p)).add(above(a));
  },
  difference: (a, b) => abs(a.sub(b)),
  split: over,
  wipe: over,
};

/** `mixed` of reference/effects/: the frame's image below, `b` over it. */
export function mixed(frame: Frame, mode: MixMode, alpha: Float, b: Picture, mask?: Picture): Vec4 {
  const below = frame.image.at(frame.pixel).toVar();
  const blend = BLENDS[mode](below.rgb, b.at(frame.pixel).rgb.toVar());
  const through = mask ? clamp(mask.at(frame.pixel).x, 0, 1) : float(1);
  return between(below, vec4(blend, below.w), shareAt(frame, mode, alpha).mul(through).toVar());
}

function shareAt(frame: Frame, mode: MixMode, alpha: Float): Float {
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
