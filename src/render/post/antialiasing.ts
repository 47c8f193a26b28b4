import { abs, Break, If, int, Loop, max, min, select, sqrt, vec2, vec3, vec4 } from 'three/tsl';
import { MIN_CONTRAST_BASE } from '../../scene/frameGraph/effects.ts';
import type { Bool, Float, Int, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { Effect } from './effect.ts';
import type { EffectContext } from './effectContext.ts';

/** `antialiasing` of src/reference/post/effects/. */
export const antialiasing: Effect = [
  { name: 'edges', downscale: 1, color: edges },
  { name: 'covered', downscale: 1, color: coverage },
  { name: 'result', downscale: 1, color: blend },
];

const [ROW, COLUMN] = [
  [1, 0],
  [0, 1],
] as const;
type EdgeAxis = typeof ROW | typeof COLUMN;

const largest = ({ x, y, z }: Vec3): Float => max(x, max(y, z));
const fourth = (value: Float): Float => value.mul(value).mul(value).mul(value);

/** (whether the left side is an edge, whether the upper one is, whether the pixel differs from all four neighbours) */
function edges(frame: EffectContext): Vec4 {
  const threshold = frame.args[0];
  const cached = new Map<string, Vec3>();
  const root = (x: number, y: number): Vec3 => {
    const key = `${x} ${y}`;
    const squareRoot = cached.get(key) ?? sqrt(max(frame.image.at(frame.pixel.add(vec2(x, y))).rgb, 0)).toVar();
    cached.set(key, squareRoot);
    return squareRoot;
  };
  const contrasts = new Map<string, { readonly difference: Float; readonly contrast: Float }>();
  /** Difference and contrast across the left (`ROW`) or upper side of a pixel. */
  const before = (x: number, y: number, [i, j]: EdgeAxis) => {
    const key = `${x} ${y} ${i}`;
    const cached = contrasts.get(key);
    if (cached) return cached;
    const [a, b] = [root(x, y), root(x - i, y - j)];
    const difference = largest(abs(a.sub(b)).toVar()).toVar();
    const contrast = difference.div(max(largest(max(a, b).toVar()), MIN_CONTRAST_BASE));
    const result = { difference, contrast };
    contrasts.set(key, result);
    return result;
  };
  const isEdge = (across: EdgeAxis, along: EdgeAxis): Bool => {
    const [[i, j], [k, l]] = [across, along];
    const own = before(0, 0, across);
    const neighborSides = [before(i, j, across), before(-i, -j, across)];
    for (const n of [0, -1]) neighborSides.push(before(n * i, n * j, along), before(n * i + k, n * j + l, along));
    const maxDifference = neighborSides.map(({ difference }) => difference).reduce((a, b) => max(a, b));
    return own.contrast.greaterThan(threshold).and(own.difference.mul(2).greaterThanEqual(maxDifference));
  };
  const left = isEdge(ROW, COLUMN);
  const top = isEdge(COLUMN, ROW);
  const ownSides = [before(0, 0, ROW), before(1, 0, ROW), before(0, 0, COLUMN), before(0, 1, COLUMN)];
  const minContrast = ownSides.map(({ contrast }) => contrast).reduce((a, b) => min(a, b));
  const isSingle = minContrast.greaterThan(threshold);
  return vec4(select(left, 1, 0), select(top, 1, 0), select(isSingle, 1, 0), 1);
}

/** How much this pixel covers of the one to the left, and is covered by it; the same for the one above. */
function coverage(frame: EffectContext): Vec4 {
  const pixelEdges = frame.stepImage('edges').at(frame.pixel).toVar();
  const areas = vec4(0).toVar();
  If(pixelEdges.x.greaterThan(0.5), () => {
    areas.xy.assign(coverageAlong(frame, COLUMN));
  });
  If(pixelEdges.y.greaterThan(0.5), () => {
    areas.zw.assign(coverageAlong(frame, ROW));
  });
  return areas;
}

/** Coverage over the side that lies along a row or a column. */
function coverageAlong(frame: EffectContext, axis: EdgeAxis): Vec2 {
  const start = edgeEnd(frame, axis, -1);
  const end = edgeEnd(frame, axis, 1);
  const length = start.x.add(end.x).add(1).toVar();
  const height = (near: Vec3, far: Vec3): Float => select(near.z.greaterThan(0.5), far.y.negate(), near.y);
  const areas = vec2(
    height(start, end).mul(halfCoverage(start.x, length)),
    height(end, start).mul(halfCoverage(end.x, length)),
  ).toVar();
  const sum = (part: Vec2): Float => part.x.add(part.y);
  return vec2(sum(max(areas, 0)), sum(max(areas.negate(), 0)));
}

function halfCoverage(k: Float, d: Float): Float {
  const middle = d.mul(0.5);
  const from = min(k, middle);
  const to = min(k.add(1), middle);
  return to.sub(from).mul(from.add(to).div(d).oneMinus());
}

/** (length, height, whether it is forked) */
function edgeEnd(frame: EffectContext, axis: EdgeAxis, sign: 1 | -1): Vec3 {
  const edgesFound = frame.stepImage('edges');
  const [along, across] = axis === ROW ? [vec2(1, 0), vec2(0, 1)] : [vec2(0, 1), vec2(1, 0)];
  const own = (texel: Vec4): Float => (axis === ROW ? texel.y : texel.x);
  const perpendicular = (texel: Vec4): Float => (axis === ROW ? texel.x : texel.y);
  const search = frame.args[1];
  const end = vec3(search, 0, 0).toVar();
  Loop({ start: int(1), end: int(search), type: 'int', condition: '<=' }, ({ i: n }: { i: Int }) => {
    const beyond = frame.pixel.add(along.mul(n.toFloat().mul(sign))).toVar();
    const turn = sign > 0 ? beyond : beyond.add(along);
    const after = edgesFound.at(turn).toVar();
    const inwards = perpendicular(after);
    const outwards = perpendicular(edgesFound.at(turn.sub(across))).toVar();
    const next = sign > 0 ? after : edgesFound.at(beyond);
    const beyondEdge = beyond.sub(beyond.clamp(vec2(0), edgesFound.size.sub(1)));
    const outside = beyondEdge.x.add(beyondEdge.y).notEqual(0);
    If(outside, () => {
      end.assign(vec3(n.toFloat().sub(1), 0, 0));
      Break();
    });
    If(inwards.add(outwards).greaterThan(0.5).or(own(next).lessThan(0.5)), () => {
      end.assign(vec3(n.toFloat().sub(1), outwards.sub(inwards).mul(0.5), inwards.mul(outwards)));
      Break();
    });
  });
  return end;
}

function blend(frame: EffectContext): Vec4 {
  const { image, pixel } = frame;
  const [edgesImage, coverageImage] = [frame.stepImage('edges'), frame.stepImage('covered')];
  const here = image.at(pixel).toVar();
  const isSingle = edgesImage.at(pixel).z.toVar();
  const own = coverageImage.at(pixel).toVar();
  const inside = min(image.size.sub(1).sub(pixel), 1).toVar();
  const side = (i: number, j: number, area: Float) => {
    const beside = pixel.add(vec2(i, j)).toVar();
    const spread = max(isSingle, edgesImage.at(beside).z).mul(frame.args[2]).toVar();
    return { color: image.at(beside).rgb, spread: spread.div(8), area: area.mul(spread.oneMinus()).toVar() };
  };
  const left = side(-1, 0, own.y);
  const right = side(1, 0, coverageImage.at(pixel.add(vec2(1, 0))).x.mul(inside.x));
  const top = side(0, -1, own.w);
  const bottom = side(0, 1, coverageImage.at(pixel.add(vec2(0, 1))).z.mul(inside.y));
  const across = fourth(left.area.add(right.area).toVar()).toVar();
  const down = fourth(top.area.add(bottom.area).toVar()).toVar();
  const sum = here.rgb.toVar();
  for (const [sides, strength] of [
    [[left, right], across],
    [[top, bottom], down],
  ] as const) {
    const weight = select(strength.greaterThan(0), strength.div(across.add(down)), 0).toVar();
    for (const { color, spread, area } of sides) sum.addAssign(color.sub(here.rgb).mul(area.mul(weight).add(spread)));
  }
  return vec4(sum, here.w);
}
