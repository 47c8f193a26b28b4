import { abs, clamp, dot, float, length, max, min, mix, round, select, smoothstep, vec2, vec3, vec4 } from 'three/tsl';
import { OBSERVER_MARKS } from '../../scene/frameGraph/effects.ts';
import type { Float, Vec2 } from '../../shaders/types.ts';
import { singleStep } from './effect.ts';
import type { EffectContext } from './effectContext.ts';

/** No distance [m]: beyond all. */
const NONE = 1e30;

/** `observerMarks` of src/reference/post/effects/. */
export const observerMarks = singleStep((frame) => {
  const [seconds, opacity, size] = frame.args;
  const { toObserver: observer, secondsPerMetre, u, gamma } = frame.uniforms;
  const outside = dot(observer, observer).greaterThan(0);
  const here = frame.image.at(frame.pixel).toVar();
  const spacing = seconds.div(secondsPerMetre).toVar();
  const color = mix(here.rgb, vec3(...OBSERVER_MARKS.ring), opacity.mul(ringCover(frame, spacing))).toVar();
  const pixel = frame.pixel.add(0.5).toVar();
  const start = frame.pixelOf(observer).toVar();
  const tip = frame.pixelOf(observer.add(u.div(gamma).mul(spacing))).toVar();
  const surface = frame.depth(frame.pixel).toVar();
  const hidden = surface.x.greaterThan(0.5).and(surface.y.lessThan(length(observer)));
  const visible = select(hidden, OBSERVER_MARKS.hidden, 1)
    .mul(select(start.z.greaterThan(0).and(size.greaterThan(0)), 1, 0))
    .toVar();
  const arrow = arrowCover(pixel, start.xy, tip.xy, size).mul(select(tip.z.greaterThan(0), visible, 0));
  color.assign(mix(color, vec3(...OBSERVER_MARKS.arrow), arrow));
  const rim = size.sub(length(pixel.sub(start.xy))).toVar();
  const disc = (inset: number): Float => clamp(rim.add(0.5 - inset), 0, 1).mul(visible);
  color.assign(mix(color, vec3(...OBSERVER_MARKS.edge), disc(0)));
  color.assign(mix(color, vec3(...OBSERVER_MARKS.body), disc(OBSERVER_MARKS.border)));
  return select(outside, vec4(color, here.w), here);
});

function ringCover(frame: EffectContext, spacing: Float): Float {
  const covered = frame.hasSurface(frame.pixel).toVar();
  const away = (pixel: Vec2): Float =>
    select(covered, surfaceDistance(frame, pixel), planeDistance(frame, pixel)).toVar();
  const here = away(frame.pixel);
  const change = (i: number, j: number): Float => {
    const side = (sign: number): Float => abs(away(frame.pixel.add(vec2(sign * i, sign * j))).sub(here));
    return min(side(1), side(-1));
  };
  const perPixel = length(vec2(change(1, 0), change(0, 1))).toVar();
  const { ringWidth, ringGap, farthest } = OBSERVER_MARKS;
  const [gap, full] = ringGap;
  const [near, far] = farthest;
  const nearest = max(round(here.div(spacing)), 1);
  const off = abs(here.sub(nearest.mul(spacing))).div(max(perPixel, spacing.mul(1e-6)));
  const line = clamp(float(ringWidth / 2 + 0.5).sub(off), 0, 1)
    .mul(smoothstep(gap, full, spacing.div(max(perPixel, spacing.mul(1e-6)))))
    .mul(smoothstep(near, far, here.div(spacing)).oneMinus());
  return select(perPixel.lessThan(spacing).and(here.lessThan(NONE)), line, 0);
}

function surfaceDistance(frame: EffectContext, pixel: Vec2): Float {
  const distance = length(frame.apparentPosition(pixel).sub(frame.uniforms.toObserver));
  return select(frame.hasSurface(pixel), distance, NONE);
}

function planeDistance(frame: EffectContext, pixel: Vec2): Float {
  const { toObserver: observer, zenith } = frame.uniforms;
  const direction = frame.apparentDirection(pixel).toVar();
  const along = dot(observer, zenith).div(dot(direction, zenith)).toVar();
  const meets = along.greaterThan(0).and(along.lessThan(NONE));
  return select(meets, length(direction.mul(along).sub(observer)), NONE);
}

function arrowCover(here: Vec2, from: Vec2, to: Vec2, size: Float): Float {
  const { arrowWidth, barb } = OBSERVER_MARKS;
  const shaft = to.sub(from).toVar();
  const long = length(shaft).toVar();
  const ahead = shaft.div(max(long, 1e-6)).toVar();
  const aside = vec2(ahead.y.negate(), ahead.x);
  const barbTip = (side: number): Vec2 =>
    to.sub(
      ahead
        .add(aside.mul(side * barb.slope))
        .mul(size)
        .mul(barb.length),
    ) as Vec2;
  const distances = [from, barbTip(1), barbTip(-1)].map((end) => distanceToSegment(here, to, end));
  const cover = clamp(float(arrowWidth / 2 + 0.5).sub(min(min(distances[0], distances[1]), distances[2])), 0, 1);
  return select(long.greaterThan(size), cover, 0);
}

function distanceToSegment(p: Vec2, a: Vec2, b: Vec2): Float {
  const along = b.sub(a).toVar();
  const from = p.sub(a).toVar();
  const t = clamp(dot(from, along).div(max(dot(along, along), 1e-12)), 0, 1);
  return length(from.sub(along.mul(t)));
}
