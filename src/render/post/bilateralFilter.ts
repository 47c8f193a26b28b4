import { dot, exp, float, radians, select, vec2 } from 'three/tsl';
import type { Float, Int, Vec2, Vec4 } from '../../shaders/types.ts';
import type { Effect } from './effect.ts';
import type { EffectContext, EffectImage } from './effectContext.ts';
import { gaussianMean } from './gaussianBlur.ts';

/** `bilateralFilter` of src/reference/post/effects/. */
export const bilateralFilter: Effect = [
  { name: 'across', downscale: 1, color: (frame) => filterAlong(frame, frame.image, vec2(1, 0)) },
  { name: 'result', downscale: 1, color: (frame) => filterAlong(frame, frame.stepImage('across'), vec2(0, 1)) },
];

function filterAlong(frame: EffectContext, from: EffectImage, direction: Vec2): Vec4 {
  const similarityTo = similarity(frame);
  const place = (k: Int): Vec2 => frame.pixel.add(direction.mul(float(k)));
  return gaussianMean(
    frame.args[0],
    float(1),
    (k) => from.at(place(k)),
    (k) => similarityTo(place(k)),
  );
}

/** The weight of a pixel by its similarity to this one, 0 … 1. */
function similarity(frame: EffectContext): (pixel: Vec2) => Float {
  const [, depthRange, normalRange] = frame.args;
  const alpha = radians(normalRange).toVar();
  const usesGuides = depthRange.greaterThan(0).or(normalRange.greaterThan(0)).toVar();
  const here = frame.depth(frame.pixel).toVar();
  const normal = frame.normal(frame.pixel).toVar();
  const perDepth = select(depthRange.greaterThan(0), depthRange.mul(here.y).reciprocal(), 0).toVar();
  const perTurn = select(normalRange.greaterThan(0), alpha.mul(alpha).reciprocal(), 0).toVar();
  return (pixel) => {
    const other = frame.depth(pixel).toVar();
    const depthDifference = other.y.sub(here.y).mul(perDepth).toVar();
    const normalDifference = dot(normal, frame.normal(pixel)).oneMinus().mul(perTurn);
    const weight = exp(depthDifference.mul(depthDifference).mul(-0.5).sub(normalDifference));
    const sky = here.x.add(other.x).lessThan(0.5);
    return select(usesGuides.not().or(sky), 1, select(here.x.equal(other.x), weight, 0));
  };
}
