import { clamp, dot, float, length, max, mix, select, vec2, vec3, vec4 } from 'three/tsl';
import type { Float, Vec2 } from '../../shaders/types.ts';
import { relativeLuminance } from '../color/luminance.ts';
import { singleStep } from './effect.ts';
import type { EffectContext } from './effectContext.ts';

const SIDES = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;

/** `edge` of src/reference/post/effects/. */
export const edge = singleStep((frame) => {
  const [light, depth, normal, under] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const strength = lightEdge(frame).mul(light).add(depthEdge(frame).mul(depth)).add(normalEdge(frame).mul(normal));
  const line = clamp(strength, 0, 1).toVar();
  return vec4(mix(vec3(line), here.rgb.mul(line.oneMinus()), under), here.w);
});

const beside = (frame: EffectContext, i: number, j: number): Vec2 => frame.pixel.add(vec2(i, j));

function lightEdge(frame: EffectContext): Float {
  const at = (i: number, j: number): Float => relativeLuminance(frame.image.at(beside(frame, i, j)).rgb).toVar();
  const [nw, n, ne] = [at(-1, -1), at(0, -1), at(1, -1)];
  const [w, here, e] = [at(-1, 0), at(0, 0), at(1, 0)];
  const [sw, s, se] = [at(-1, 1), at(0, 1), at(1, 1)];
  const weigh = (a: Float, b: Float, c: Float): Float => a.add(b.mul(2)).add(c);
  const [left, middle, right] = [weigh(nw, w, sw).toVar(), weigh(n, here, s), weigh(ne, e, se).toVar()];
  const gradient = vec2(right.sub(left), weigh(sw, s, se).sub(weigh(nw, n, ne)));
  return length(gradient)
    .div(8)
    .div(weigh(left, middle, right).div(16).add(1e-4));
}

function depthEdge(frame: EffectContext): Float {
  const inverse = (i: number, j: number): Float => {
    const surface = frame.depth(beside(frame, i, j)).toVar();
    return select(surface.x.greaterThan(0.5), surface.y.reciprocal(), 0).toVar();
  };
  const here = inverse(0, 0);
  const bend = (i: number, j: number): Float => here.mul(2).sub(inverse(i, j)).sub(inverse(-i, -j));
  const maxBend = max(bend(1, 0), max(bend(0, 1), 0));
  return select(here.greaterThan(0), maxBend.div(here), 0);
}

function normalEdge(frame: EffectContext): Float {
  const normal = frame.normal(frame.pixel).toVar();
  const angles = float(0).toVar();
  for (const [i, j] of SIDES) {
    const pixel = beside(frame, i, j).toVar();
    const change = dot(normal, frame.normal(pixel)).oneMinus().div(8);
    angles.addAssign(select(frame.hasSurface(pixel), change, 0));
  }
  return select(frame.hasSurface(frame.pixel), angles, 0);
}
