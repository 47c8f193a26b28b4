import { abs, dot, float, floor, fract, int, length, max, min, screenCoordinate, sqrt, vec2 } from 'three/tsl';
import type { Bool, Float, Int, Vec2 } from '../../../shaders/types.ts';
import { type AtlasLookup, edgeHeightNear, heightAt, loopTimes, rotateByGoldenAngle } from '../atlas/atlasLookups.ts';

/** A place on a map whose light comes from a point, and what the light around that point looks like from there. */
export interface LightFootprint {
  /** [texels] */
  readonly place: Vec2;
  /** One over the depth of what may be in shadow [1/m], how that changes on its plane from texel to texel, and by a rise as high as a texel is wide. */
  readonly ground: Float;
  readonly slope: Vec2;
  readonly grain: Float;
  /** Half axes of the light as they fall on the map in the height of an occluder: texels for each unit of its height above the ground. */
  readonly A: Vec2;
  readonly B: Vec2;
  /** Whether it fills the parallelogram of its axes, and not the ellipse. */
  readonly isParallelogram: boolean;
}

/** What rises beside the surface no steeper than so, as the floor at the foot of a wall does, is not above it. */
const MIN_OCCLUDER_SLOPE = 1.5;
/** A light on the map is taken to have at least this radius [texels], and at most a cell of edgeMap.ts. */
const MIN_FILTER_RADIUS = 0.8;
/** So much of the way to the light's edge, at an occluder's height, a lookup may be beside the place for the occluder to count. */
const BLOCKER_CONE = 0.8;

/**
 * The share of a light that is seen past the occluders on a tile. Where no edge is near, one lookup tells. Else some tell how high the occluders are
 * between the place and the light, as wide as that falls on the map in the height of the highest edge; and others, as wide as in the mean height of
 * those, what share of it they hide (percentage-closer soft shadows, Fernando 2005). They are turned from pixel to pixel, for a penumbra is wider
 * than there are steps.
 */
export function pcssVisibility(
  map: AtlasLookup,
  footprint: LightFootprint,
  sampleCount: number,
  enabled?: Bool,
): Float {
  const { place, ground, A, B, isParallelogram } = footprint;
  const edge = edgeHeightNear(map, place).toVar();
  const near = edge.greaterThan(ground).toVar();
  const widest = max(length(A), length(B)).max(1e-9).toVar();
  const most = float(map.cell).div(widest).toVar();
  const first = near.select(min(edge.sub(ground), most), float(0)).toVar();
  const start = samplePatternOf(isParallelogram);
  const blockers = { height: float(0).toVar(), count: float(0).toVar() };
  const searches = Math.max(4, sampleCount / 2);
  const search = lightSamples(filterAxis(A, first, vec2(1, 0), near), filterAxis(B, first, vec2(0, 1), near), start);
  loopTimes(near.select(int(searches), int(1)), (i) => {
    const { height, off, clear } = lookup(map, footprint, search(i, searches));
    // Beyond the light's edge as that occluder has it.
    const cone = max(off.sub(2), 0).mul(BLOCKER_CONE).div(widest).add(ground);
    const blocks = height.greaterThan(max(clear, cone)).select(float(1), float(0));
    blockers.height.addAssign(height.mul(blocks));
    blockers.count.addAssign(blocks);
  });
  const mean = blockers.height.div(max(blockers.count, 1)).toVar();
  const reach = min(max(mean.sub(ground), 0), most).toVar();
  const filter = lightSamples(filterAxis(A, reach, vec2(1, 0), near), filterAxis(B, reach, vec2(0, 1), near), start);
  const wide = near.and(blockers.count.greaterThan(0)).toVar();
  const count = wide.select(int(sampleCount), int(1)).toVar();
  const held = float(0).toVar();
  loopTimes(count, (i) => {
    const { height, clear } = lookup(map, footprint, wide.select(filter(i, sampleCount), vec2(0)));
    held.addAssign(height.greaterThan(clear).select(float(1), float(0)));
  });
  const open = held.div(float(count)).oneMinus();
  return enabled ? enabled.select(open, float(1)) : open;
}

/** The highest occluder beside the place, and how high it has to be to be above the surface. */
function lookup(map: AtlasLookup, { place, ground, slope, grain }: LightFootprint, aside: Vec2) {
  const at = floor(place.add(aside)).toVar();
  const off = at.add(0.5).sub(place).toVar();
  const rise = max(abs(off.x), abs(off.y)).mul(MIN_OCCLUDER_SLOPE).mul(grain);
  const clear = max(max(dot(slope, off), rise).add(ground), 0);
  return { height: heightAt(map, at).toVar(), off: length(off), clear };
}

/** A half axis on the map in some height above the ground, of at least a radius. */
function filterAxis(of: Vec2, reach: Float, otherwise: Vec2, near: Bool): Vec2 {
  const size = length(of).toVar();
  const way = size.greaterThan(1e-6).select(of.div(size.max(1e-6)), otherwise);
  return way.mul(near.select(size.mul(reach).max(MIN_FILTER_RADIUS), float(0))).toVar();
}

/** Steps of the R₂ sequence (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"). */
const R2_LATTICE = [0.7548776662, 0.5698402909] as const;

/** Of each pixel a number from 0 to 1, unlike those of its neighbours (interleaved gradient noise: Jimenez 2014, "Next generation post processing in Call of Duty"). */
const interleavedGradientNoise = (): Float =>
  fract(fract(dot(floor(screenCoordinate), vec2(0.06711056, 0.00583715))).mul(52.9829189));

/** Where the lookups begin: on a square the first of a lattice of its own, on a disc the first direction. */
function samplePatternOf(square: boolean): { readonly square: boolean; readonly at: Vec2 } {
  const number = interleavedGradientNoise().toVar();
  const angle = number.mul(2 * Math.PI);
  const other = fract(dot(floor(screenCoordinate), vec2(...R2_LATTICE)));
  return { square, at: (square ? vec2(number, other) : vec2(angle.cos(), angle.sin())).toVar() };
}

/** The i-th of `count` places, evenly over a light. On a square they are those of R₂, on a disc turned by the golden angle. */
function lightSamples(
  A: Vec2,
  B: Vec2,
  { square, at }: ReturnType<typeof samplePatternOf>,
): (i: Int, count: number) => Vec2 {
  const of = (p: Vec2): Vec2 => A.mul(p.x).add(B.mul(p.y));
  if (square) {
    const step = vec2(0.7548776662, 0.5698402909);
    return (i) =>
      of(
        fract(at.add(step.mul(float(i))))
          .mul(2)
          .sub(1),
      );
  }
  const direction = at.toVar();
  return (i, count) => {
    const away = sqrt(float(i).add(0.5).div(count));
    const place = of(direction.mul(away)).toVar();
    direction.assign(rotateByGoldenAngle(direction));
    return place;
  };
}
