import { bool, dot, float, If, int, Loop, length, max, min, select, uniform, vec2, vec3 } from 'three/tsl';
import { Vector3 } from 'three/webgpu';
import { rotate } from '../../../math/quat.ts';
import type { Bool, Float, Int, Vec3 } from '../../../shaders/types.ts';
import { DEPTH_WEIGHT, MIN_STEP_PIXELS } from '../criterion/edgeCriterion.ts';
import { MIN_EDGE_PIXELS, MIN_ROUND_EDGE_PIXELS, ROUND_STRICTNESS } from '../criterion/projectedBody.ts';
import { cornerMagnification, type TessellationView } from '../criterion/tessellationView.ts';
import { MAX_LOG2_FACTOR } from '../patches/patch.ts';
import { baseFactor, maxInt } from './shaderPatch.ts';

/** Observer position of a point of an edge [m], and whether the point exists. */
export interface ProjectedPoint {
  readonly position: Vec3;
  readonly exists: Bool;
}

/** Uniforms of the edge metric of a view (`ScreenMetric`); `set` once per view. */
export class EdgeMetricUniforms {
  readonly focal = uniform(1);
  readonly tolerance = uniform(1);
  readonly forward = uniform(new Vector3());
  /** 1 + tan² of the angle to the picture's corner. */
  readonly cornerMagnification = uniform(1);

  set({ focal, orientation, frustum }: TessellationView, tolerance: number): void {
    this.focal.value = focal;
    this.tolerance.value = tolerance;
    this.forward.value.set(...rotate(orientation, [0, 0, -1]));
    this.cornerMagnification.value = cornerMagnification(frustum);
  }
}

/** The packed tessellation factors of a patch's three edges, and its pattern. `project`: from weights of the triangle's corners to the observer position; `isRound`: as in `ProjectedBody`. */
export function patchFactors(
  corners: readonly [Vec3, Vec3, Vec3],
  project: (weights: Vec3) => ProjectedPoint,
  metric: EdgeMetricUniforms,
  isRound: Bool,
): { factors: Int; pattern: Int } {
  const factors = [int(0).toVar(), int(0).toVar(), int(0).toVar()] as const;
  Loop({ start: int(0), end: int(3), type: 'int', condition: '<' }, ({ i }) => {
    const edge = int(i).toVar();
    const corner = (k: number) => {
      const at = edge.add(int(k));
      return select(at.equal(int(1)), corners[1], select(at.equal(int(2)), corners[2], corners[0]));
    };
    const factor = edgeFactor(corner(0).toVar(), corner(1).toVar(), project, metric, isRound);
    factors.forEach((to, k) => {
      to.assign(select(edge.equal(int(k)), factor, to));
    });
  });
  const largest = maxInt(maxInt(factors[0], factors[1]), factors[2]);
  // As patternIndexOf (pattern.ts) and packFactors (patch.ts).
  const pattern = largest
    .mul(largest.add(int(1)))
    .shiftRight(int(1))
    .add(baseFactor(...factors))
    .toVar();
  const packed = factors[0]
    .add(factors[1].shiftLeft(int(3)))
    .add(factors[2].shiftLeft(int(6)))
    .toVar();
  return { factors: packed, pattern };
}

/**
 * As `EdgeCriterion.segments` (edgeCriterion.ts), for edges that are graded already. Depends as little as possible on which end comes first: weights are exact,
 * and only symmetric functions of the five points are used.
 */
function edgeFactor(
  from: Vec3,
  to: Vec3,
  project: (weights: Vec3) => ProjectedPoint,
  metric: EdgeMetricUniforms,
  isRound: Bool,
): Int {
  const quarter = to.sub(from).mul(0.25).toVar();
  const [before, middle] = [vec3(0).toVar(), vec3(0).toVar()];
  const [begin, end] = [vec3(0).toVar(), vec3(0).toVar()];
  const [least, largest, bend] = [float(1e30).toVar(), float(0).toVar(), float(0).toVar()];
  const [turned, direction] = [float(0).toVar(), vec3(0).toVar()];
  const missing = bool(false).toVar();
  Loop({ start: int(0), end: int(5), type: 'int', condition: '<' }, ({ i }) => {
    // Loops inside `project` use the same variable name.
    const k = int(i).toVar();
    const point = project(from.add(quarter.mul(float(k))).toVar());
    end.assign(point.position);
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
    largest.assign(max(largest, magnification(end, metric)));
    If(k.greaterThan(int(1)), () => {
      bend.assign(max(bend, secondDifferencePixels(before.add(end).sub(middle.mul(2)).toVar(), middle, metric)));
    });
    before.assign(middle);
    middle.assign(end);
  });
  const long = length(end.sub(begin))
    .mul(metric.focal)
    .mul(largest)
    .greaterThanEqual(least.mul(select(isRound, float(MIN_ROUND_EDGE_PIXELS), float(MIN_EDGE_PIXELS))));
  const wide = turned.mul(metric.focal).mul(largest).greaterThanEqual(MIN_STEP_PIXELS);
  const square = select(
    long.and(wide).and(missing.not()),
    bend.mul(select(isRound, float(2 * ROUND_STRICTNESS), float(2))).div(metric.tolerance),
    float(0),
  ).toVar();
  const factor = int(0).toVar();
  for (let k = 0; k < MAX_LOG2_FACTOR; k++) factor.addAssign(select(square.greaterThan(4 ** k), int(1), int(0)));
  return factor;
}

/** Length in the picture of the second difference S at the observer position F [px]: S⊥ focal (1 + tan²θ)/|F|, with S∥ weighted by `DEPTH_WEIGHT`. */
function secondDifferencePixels(difference: Vec3, at: Vec3, metric: EdgeMetricUniforms): Float {
  const distance = max(length(at), 1e-30).toVar();
  const n = at.div(distance).toVar();
  const along = dot(difference, n).toVar();
  const across = length(difference.sub(n.mul(along)))
    .mul(magnification(at, metric))
    .toVar();
  return length(vec2(across, along.mul(float(DEPTH_WEIGHT))))
    .div(distance)
    .mul(metric.focal);
}

/** 1 + tan² of the angle from the forward axis, at most that of the corner. */
function magnification(at: Vec3, { forward, cornerMagnification }: EdgeMetricUniforms): Float {
  const depth = dot(at, forward).toVar();
  const square = dot(at, at).toVar();
  const inside = depth.greaterThan(0).and(square.lessThan(depth.mul(depth).mul(cornerMagnification)));
  return select(inside, square.div(max(depth.mul(depth), 1e-30)), cornerMagnification);
}
