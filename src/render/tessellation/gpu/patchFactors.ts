import { bool, dot, float, If, int, Loop, length, max, min, select, uniform, vec2, vec3 } from 'three/tsl';
import { Vector3 } from 'three/webgpu';
import { rotate } from '../../../math/quat.ts';
import type { Bool, Float, Int, Vec3 } from '../../../shaders/types.ts';
import { DEPTH_WEIGHT, MIN_STEP_PIXELS } from '../criterion/edgeCriterion.ts';
import { MIN_EDGE_PIXELS } from '../criterion/projectedBody.ts';
import { cornerMagnification, type TessellationView } from '../criterion/tessellationView.ts';
import { MAX_LOG2_FACTOR } from '../patches/patch.ts';
import { baseFactor, maxInt } from './shaderPatch.ts';

/** Where a point of an edge is shown, in the observer's frame [m], and whether there is such a point. */
export interface ProjectedPoint {
  readonly shown: Vec3;
  readonly exists: Bool;
}

/** What a picture's edges are measured by; `take` once per picture. */
export class EdgeMetricUniforms {
  readonly focal = uniform(1);
  readonly tolerance = uniform(1);
  readonly forward = uniform(new Vector3());
  /** 1 + tan² of the picture's corner. */
  readonly cornerMagnification = uniform(1);

  set({ focal, orientation, frustum }: TessellationView, tolerance: number): void {
    this.focal.value = focal;
    this.tolerance.value = tolerance;
    this.forward.value.set(...rotate(orientation, [0, 0, -1]));
    this.cornerMagnification.value = cornerMagnification(frustum);
  }
}

/** Levels of a leaf's three edges, packed, and its pattern; `show` tells where the point with some weights of the triangle's corners is seen. */
export function patchFactors(
  corners: readonly [Vec3, Vec3, Vec3],
  project: (weights: Vec3) => ProjectedPoint,
  metric: EdgeMetricUniforms,
): { levels: Int; pattern: Int } {
  const levels = [int(0).toVar(), int(0).toVar(), int(0).toVar()] as const;
  Loop({ start: int(0), end: int(3), type: 'int', condition: '<' }, ({ i }) => {
    const edge = int(i).toVar();
    const of = (k: number) => {
      const at = edge.add(int(k));
      return select(at.equal(int(1)), corners[1], select(at.equal(int(2)), corners[2], corners[0]));
    };
    const level = edgeFactor(of(0).toVar(), of(1).toVar(), project, metric);
    levels.forEach((to, k) => {
      to.assign(select(edge.equal(int(k)), level, to));
    });
  });
  const most = maxInt(maxInt(levels[0], levels[1]), levels[2]);
  // As patternOf and packLevels.
  const pattern = most
    .mul(most.add(int(1)))
    .shiftRight(int(1))
    .add(baseFactor(...levels))
    .toVar();
  const packed = levels[0]
    .add(levels[1].shiftLeft(int(3)))
    .add(levels[2].shiftLeft(int(6)))
    .toVar();
  return { levels: packed, pattern };
}

/**
 * As EdgeCriterion.pieces (edgeCriterion.ts), for edges that are graded already, and as little dependent on which end is the first: weights are
 * exact, and of the five points only symmetric functions are used.
 */
function edgeFactor(from: Vec3, to: Vec3, show: (weights: Vec3) => ProjectedPoint, gauge: EdgeMetricUniforms): Int {
  const quarter = to.sub(from).mul(0.25).toVar();
  const [before, middle] = [vec3(0).toVar(), vec3(0).toVar()];
  const [begin, end] = [vec3(0).toVar(), vec3(0).toVar()];
  const [least, largest, bend] = [float(1e30).toVar(), float(0).toVar(), float(0).toVar()];
  const [turned, direction] = [float(0).toVar(), vec3(0).toVar()];
  const missing = bool(false).toVar();
  Loop({ start: int(0), end: int(5), type: 'int', condition: '<' }, ({ i }) => {
    // Loops inside `show` count with a variable of the same name.
    const k = int(i).toVar();
    const point = show(from.add(quarter.mul(float(k))).toVar());
    end.assign(point.shown);
    missing.assign(missing.or(point.exists.not()));
    If(k.equal(int(0)), () => {
      begin.assign(end);
    });
    const distance = length(end).toVar();
    const n = end.div(max(distance, 1e-30)).toVar();
    If(k.greaterThan(int(0)), () => {
      turned.assign(max(turned, length(n.sub(direction))));
    });
    direction.assign(n);
    least.assign(min(least, distance));
    largest.assign(max(largest, magnification(end, gauge)));
    If(k.greaterThan(int(1)), () => {
      bend.assign(max(bend, secondDifferencePixels(before.add(end).sub(middle.mul(2)).toVar(), middle, gauge)));
    });
    before.assign(middle);
    middle.assign(end);
  });
  const long = length(end.sub(begin))
    .mul(gauge.focal)
    .mul(largest)
    .greaterThanEqual(least.mul(float(MIN_EDGE_PIXELS)));
  const wide = turned.mul(gauge.focal).mul(largest).greaterThanEqual(MIN_STEP_PIXELS);
  const square = select(long.and(wide).and(missing.not()), bend.mul(2).div(gauge.tolerance), float(0)).toVar();
  const level = int(0).toVar();
  for (let k = 0; k < MAX_LOG2_FACTOR; k++) level.addAssign(select(square.greaterThan(4 ** k), int(1), int(0)));
  return level;
}

/** Size of the second difference S at a place F in the picture [px]: S⊥ focal (1 + tan²θ)/|F|, and a share of what is along F. */
function secondDifferencePixels(difference: Vec3, at: Vec3, gauge: EdgeMetricUniforms): Float {
  const distance = max(length(at), 1e-30).toVar();
  const n = at.div(distance).toVar();
  const along = dot(difference, n).toVar();
  const across = length(difference.sub(n.mul(along)))
    .mul(magnification(at, gauge))
    .toVar();
  return length(vec2(across, along.mul(float(DEPTH_WEIGHT))))
    .div(distance)
    .mul(gauge.focal);
}

/** 1 + tan² of the angle from the picture's middle, at most that of its corner. */
function magnification(at: Vec3, { forward, cornerMagnification }: EdgeMetricUniforms): Float {
  const depth = dot(at, forward).toVar();
  const square = dot(at, at).toVar();
  const inside = depth.greaterThan(0).and(square.lessThan(depth.mul(depth).mul(cornerMagnification)));
  return select(inside, square.div(max(depth.mul(depth), 1e-30)), cornerMagnification);
}
