import {
  abs,
  ceil,
  clamp,
  cos,
  dot,
  float,
  floor,
  fract,
  If,
  int,
  Loop,
  max,
  min,
  select,
  sin,
  sqrt,
  vec2,
  vec4,
} from 'three/tsl';
import { DEPTH_OF_FIELD_SAMPLING, EFFECTS } from '../../scene/frameGraph/effects.ts';
import type { Float, Int, Vec2, Vec4 } from '../../shaders/types.ts';
import type { Effect } from './effect.ts';
import type { EffectContext, EffectImage } from './effectContext.ts';

/** Least radius of a disc [px]: that of a disc with the area of a pixel. */
const MIN_RADIUS = Math.sqrt(1 / Math.PI);
/** The golden angle [turns]. */
const GOLDEN_TURN = (3 - Math.sqrt(5)) / 2;
const CELL_REACH = Math.ceil(EFFECTS['depth-of-field'].args[2].max / DEPTH_OF_FIELD_SAMPLING.cell);

/** `depthOfField` of reference/post/effects/depthOfField.ts. The lens step holds (colour, ±ρ), the cells the largest |ρ|. */
export const depthOfField: Effect = [
  { name: 'lens', downscale: 1, color: circleOfConfusion },
  { name: 'soft', downscale: 1, color: soften },
  { name: 'cells', downscale: DEPTH_OF_FIELD_SAMPLING.cell, color: maxOfCell },
  {
    name: 'reach across',
    downscale: DEPTH_OF_FIELD_SAMPLING.cell,
    color: (frame) => maxAlong(frame, frame.stepImage('cells'), vec2(1, 0)),
  },
  {
    name: 'reach',
    downscale: DEPTH_OF_FIELD_SAMPLING.cell,
    color: (frame) => maxAlong(frame, frame.stepImage('reach across'), vec2(0, 1)),
  },
  { name: 'result', downscale: 1, color: gather },
];

function circleOfConfusion(frame: EffectContext): Vec4 {
  const [focus, aperture, maxRadius] = frame.args;
  const { halfTangents } = frame.uniforms;
  const focal = float(frame.image.size.y).div(halfTangents.y.mul(2));
  const found = frame.depth(frame.pixel).toVar();
  const tangents = frame.tangents(frame.pixel).toVar();
  const inverseDepth = select(found.x.greaterThan(0.5), sqrt(dot(tangents, tangents).add(1)).div(found.y), 0);
  const rho = aperture
    .mul(focal)
    .mul(0.5 / 1000)
    .mul(focus.reciprocal().sub(inverseDepth));
  return vec4(frame.image.at(frame.pixel).rgb, clamp(rho, maxRadius.negate(), maxRadius));
}

function soften(frame: EffectContext): Vec4 {
  const lens = frame.stepImage('lens');
  const here = lens.at(frame.pixel).toVar();
  const amount = clamp(abs(here.w).sub(1), 0, 1).toVar();
  const sum = vec4(here.rgb, 1).toVar();
  for (const j of [-1, 0, 1])
    for (const i of [-1, 0, 1]) {
      if (i === 0 && j === 0) continue;
      const texel = lens.at(frame.pixel.add(vec2(i, j))).toVar();
      const similarity = clamp(float(2).sub(abs(texel.w.sub(here.w))), 0, 1);
      sum.addAssign(vec4(texel.rgb, 1).mul(similarity.mul(amount).mul(i * j === 0 ? 0.5 : 0.25)));
    }
  return vec4(sum.rgb.div(sum.w), here.w);
}

function maxOfCell(frame: EffectContext): Vec4 {
  const lens = frame.stepImage('lens');
  const corner = frame.pixel.mul(DEPTH_OF_FIELD_SAMPLING.cell).toVar();
  const most = float(0).toVar();
  for (let j = 0; j < DEPTH_OF_FIELD_SAMPLING.cell; j++)
    for (let i = 0; i < DEPTH_OF_FIELD_SAMPLING.cell; i++)
      most.assign(max(most, abs(lens.at(corner.add(vec2(i, j))).w)));
  return vec4(most, 0, 0, 1);
}

function maxAlong(frame: EffectContext, cells: EffectImage, direction: Vec2): Vec4 {
  const most = float(0).toVar();
  for (let k = -CELL_REACH; k <= CELL_REACH; k++) {
    const rho = cells.at(frame.pixel.add(direction.mul(k))).x.toVar();
    const reaches = rho.greaterThanEqual(DEPTH_OF_FIELD_SAMPLING.cell * (Math.abs(k) - 1));
    most.assign(select(reaches, max(most, rho), most));
  }
  return vec4(most, 0, 0, 1);
}

function gather(frame: EffectContext): Vec4 {
  const lens = frame.stepImage('soft');
  const here = lens.at(frame.pixel).toVar();
  const own = here.w;
  const R = frame
    .stepImage('reach')
    .at(floor(frame.pixel.div(DEPTH_OF_FIELD_SAMPLING.cell)))
    .x.toVar();
  const weight = discWeight(abs(own)).div(Math.PI).toVar();
  const sum = here.rgb.mul(weight).toVar();
  If(R.greaterThanEqual(0.5), () => {
    const samples = clamp(ceil(R.mul(R)), 16, DEPTH_OF_FIELD_SAMPLING.samples).toVar();
    const density = R.mul(R).div(samples).toVar();
    Loop({ start: int(0), end: int(samples), type: 'int', condition: '<' }, ({ i }: { i: Int }) => {
      const distance = R.mul(sqrt(float(i).add(0.5).div(samples))).toVar();
      const angle = fract(float(i).mul(GOLDEN_TURN))
        .mul(2 * Math.PI)
        .toVar();
      const offset = floor(vec2(cos(angle), sin(angle)).mul(distance).add(0.5));
      const texel = lens.at(frame.pixel.add(offset)).toVar();
      const size = abs(texel.w).toVar();
      const rho = select(texel.w.greaterThan(own), min(size, abs(own)), size).toVar();
      const sampleWeight = density
        .mul(clamp(rho.sub(distance).add(1), 0, 1))
        .mul(discWeight(rho))
        .toVar();
      sum.addAssign(texel.rgb.mul(sampleWeight));
      weight.addAssign(sampleWeight);
    });
  });
  return vec4(sum.div(weight), frame.image.at(frame.pixel).w);
}

/** The fraction of a disc's light that one pixel gets, times π. */
function discWeight(rho: Float): Float {
  const radius = max(rho, MIN_RADIUS);
  return radius.mul(radius).reciprocal();
}
