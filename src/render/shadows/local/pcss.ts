import { abs, dot, float, floor, fract, int, length, max, min, screenCoordinate, sqrt, vec2 } from 'three/tsl';
import type { Bool, Float, Int, Vec2 } from '../../../shaders/types.ts';
import { interleavedGradientNoise } from '../../gpu/gradientNoise.ts';
import {
  type AtlasLookup,
  edgeHeightNear,
  heightAt,
  loopTimes,
  MIN_FILTER_RADIUS,
  MIN_OCCLUDER_SLOPE,
  rotateByGoldenAngle,
} from '../atlas/atlasLookups.ts';

/** A place on a light's tile, and what the light looks like from there. */
export interface LightFootprint {
  /** [texels] */
  readonly place: Vec2;
  /** One over the depth of the receiver [1/m], its derivative on the receiver's plane per texel, and its change by a rise of one texel's width. */
  readonly ground: Float;
  readonly slope: Vec2;
  readonly grain: Float;
  /** Half axes of the light as projected onto the tile through an occluder: texels per unit of the occluder's height above the ground. */
  readonly A: Vec2;
  readonly B: Vec2;
  /** Whether the light fills the parallelogram of its axes, or else the ellipse. */
  readonly isParallelogram: boolean;
}

/**
 * A blocker counts if its distance from the place is within the cone to the light's edge at the blocker's height; the cone is widened by 1 over this factor.
 */
const BLOCKER_CONE = 0.8;

/**
 * The fraction of a light that is visible past the occluders on a tile. Where no edge is near, one lookup decides. Elsewhere a first set of lookups, as wide
 * as the light projected at the height of the highest edge, finds the mean height of the blockers; a second set, as wide as the light projected at that
 * height, finds the fraction that they occlude (percentage-closer soft shadows, Fernando 2005). Lookups are rotated from pixel to pixel, because a penumbra
 * is wider than there are steps.
 */
export function pcssVisibility(
  map: AtlasLookup,
  footprint: LightFootprint,
  sampleCount: number,
  enabled?: Bool,
): Float {
  const { place, ground, A, B, isParallelogram } = footprint;
  const edge = edgeHeightNear(map, place).toVar();
  const nearEdge = edge.greaterThan(ground).toVar();
  const widest = max(length(A), length(B)).max(1e-9).toVar();
  const maxReach = float(map.cell).div(widest).toVar();
  const searchReach = nearEdge.select(min(edge.sub(ground), maxReach), float(0)).toVar();
  const start = samplePatternOf(isParallelogram);
  const blockers = { height: float(0).toVar(), count: float(0).toVar() };
  const searchCount = Math.max(4, sampleCount / 2);
  const search = lightSamples(
    filterAxis(A, searchReach, vec2(1, 0), nearEdge),
    filterAxis(B, searchReach, vec2(0, 1), nearEdge),
    start,
  );
  loopTimes(nearEdge.select(int(searchCount), int(1)), (i) => {
    const { height, off: offset, clear: minHeight } = lookup(map, footprint, search(i, searchCount));
    // Not outside the cone to the light's edge at the blocker's height.
    const cone = max(offset.sub(2), 0).mul(BLOCKER_CONE).div(widest).add(ground);
    const blocks = height.greaterThan(max(minHeight, cone)).select(float(1), float(0));
    blockers.height.addAssign(height.mul(blocks));
    blockers.count.addAssign(blocks);
  });
  const mean = blockers.height.div(max(blockers.count, 1)).toVar();
  const reach = min(max(mean.sub(ground), 0), maxReach).toVar();
  const filter = lightSamples(
    filterAxis(A, reach, vec2(1, 0), nearEdge),
    filterAxis(B, reach, vec2(0, 1), nearEdge),
    start,
  );
  const inPenumbra = nearEdge.and(blockers.count.greaterThan(0)).toVar();
  const count = inPenumbra.select(int(sampleCount), int(1)).toVar();
  const occluded = float(0).toVar();
  loopTimes(count, (i) => {
    const { height, clear: minHeight } = lookup(map, footprint, inPenumbra.select(filter(i, sampleCount), vec2(0)));
    occluded.addAssign(height.greaterThan(minHeight).select(float(1), float(0)));
  });
  const visibility = occluded.div(float(count)).oneMinus();
  return enabled ? enabled.select(visibility, float(1)) : visibility;
}

/** The highest occluder at an offset from the place, and the height above which it occludes the receiver. */
function lookup(map: AtlasLookup, { place, ground, slope, grain }: LightFootprint, offsetTexels: Vec2) {
  const at = floor(place.add(offsetTexels)).toVar();
  const offset = at.add(0.5).sub(place).toVar();
  const rise = max(abs(offset.x), abs(offset.y)).mul(MIN_OCCLUDER_SLOPE).mul(grain);
  const minHeight = max(max(dot(slope, offset), rise).add(ground), 0);
  return { height: heightAt(map, at).toVar(), off: length(offset), clear: minHeight };
}

/** A half axis on the tile at a height above the ground, of at least the minimal filter radius. */
function filterAxis(of: Vec2, reach: Float, otherwise: Vec2, nearEdge: Bool): Vec2 {
  const size = length(of).toVar();
  const unitAxis = size.greaterThan(1e-6).select(of.div(size.max(1e-6)), otherwise);
  return unitAxis.mul(nearEdge.select(size.mul(reach).max(MIN_FILTER_RADIUS), float(0))).toVar();
}

/** Steps of the R₂ sequence (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"). */
const R2_LATTICE = [0.7548776662, 0.5698402909] as const;

/** Where the pixel's lookups begin: for a square the offset of its lattice, for a disc the first direction. */
function samplePatternOf(square: boolean): { readonly square: boolean; readonly at: Vec2 } {
  const number = interleavedGradientNoise().toVar();
  const angle = number.mul(2 * Math.PI);
  const other = fract(dot(floor(screenCoordinate), vec2(...R2_LATTICE)));
  return { square, at: (square ? vec2(number, other) : vec2(angle.cos(), angle.sin())).toVar() };
}

/** The i-th of `count` places, evenly distributed over a light: on a square by the R₂ sequence, on a disc by the golden angle. */
function lightSamples(
  A: Vec2,
  B: Vec2,
  { square, at }: ReturnType<typeof samplePatternOf>,
): (i: Int, count: number) => Vec2 {
  const of = (p: Vec2): Vec2 => A.mul(p.x).add(B.mul(p.y));
  if (square) {
    const step = vec2(...R2_LATTICE);
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
