import { floor, mix, vec2, vec4 } from 'three/tsl';
import { BLOOM_LEVELS } from '../../scene/effects.ts';
import type { Float, Vec4 } from '../../shaders/types.ts';
import type { Effect, Step } from './effect.ts';
import type { Frame, Picture } from './frame.ts';

const SPLINE = [1, 3, 3, 1];
const levels = Array.from({ length: BLOOM_LEVELS }, (_, k) => k + 1);
const source = (frame: Frame, k: number): Picture => (k === 0 ? frame.image : frame.step(`half ${k}`));

/** `bloom` of reference/effects/. */
export const bloom: Effect = [
  ...levels.map(
    (k): Step => ({ name: `half ${k}`, shrink: 2 ** k, color: (frame) => halved(frame, source(frame, k - 1)) }),
  ),
  ...levels
    .slice(0, -1)
    .reverse()
    .map((k): Step => ({ name: `wide ${k}`, shrink: 2 ** k, color: (frame) => blend(frame, k, frame.args[1]) })),
  { name: 'result', shrink: 1, color: (frame) => blend(frame, 0, frame.args[0]) },
];

/** Level k, with a share of what is wider. */
function blend(frame: Frame, k: number, share: Float): Vec4 {
  const wide = k + 1 === BLOOM_LEVELS ? source(frame, BLOOM_LEVELS) : frame.step(`wide ${k + 1}`);
  return mix(source(frame, k).at(frame.pixel), doubled(frame, wide), share);
}

function halved(frame: Frame, from: Picture): Vec4 {
  const corner = frame.pixel.mul(2).sub(1).toVar();
  const sum = vec4(0).toVar();
  for (const [j, wj] of SPLINE.entries())
    for (const [i, wi] of SPLINE.entries()) sum.addAssign(from.at(corner.add(vec2(i, j))).mul((wi * wj) / 64));
  return sum;
}

function doubled(frame: Frame, from: Picture): Vec4 {
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
