import {
  atan,
  clamp,
  cos,
  cross,
  dot,
  float,
  If,
  int,
  Loop,
  length,
  mix,
  normalize,
  select,
  sign,
  sin,
  vec2,
  vec3,
} from 'three/tsl';
import type { Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';

/** The outline of a light: `count` corners in order, relative to the surface. */
export interface LightOutline {
  readonly count: number;
  corner(k: Int): Vec3;
}

/** A regular polygon around a face's centre: number of corners, angle of the first, and their distance in half axes. */
export interface FacePolygon {
  readonly count: number;
  readonly first: number;
  readonly reach: number;
}

/** A face with the half axes X and Y. */
export function faceOutline({ count, first, reach }: FacePolygon, center: Vec3, X: Vec3, Y: Vec3): LightOutline {
  const step = (2 * Math.PI) / count;
  return {
    count,
    corner: (k) => {
      const angle = float(k).mul(step).add(first).toVar();
      return center.add(X.mul(cos(angle).mul(reach))).add(Y.mul(sin(angle).mul(reach)));
    },
  };
}

/** Light of radiance 1 that a surface receives from within an outline. */
export interface OutlineFlux {
  /** ∫ N·(n, 1) dΩ: the irradiance of a surface at rest. */
  readonly amount: Float;
  /** ∫ n N·(n, 1) dΩ; without `weighted` ∫ n dΩ. */
  readonly toward: Vec3;
}

/**
 * Integrals over the directions n within an outline of unit vectors, clipped where N·(n, 1) < 0. `apex`: unit, about at its centre.
 * With Γ = a × b of an edge of length θ: ∫ n dΩ = ½ Σ θ Γ/sin θ; ∫ n nᵀ dΩ = ⅓ [Ω + Σ (a + b) Γᵀ/(1 + a·b)]; Ω from triangles with the apex.
 * Source: Lambert 1760, Photometria; Arvo 1995, "Applications of irradiance tensors to the simulation of non-Lambertian phenomena", SIGGRAPH, eq. 7;
 * Van Oosterom and Strackee 1983, "The solid angle of a plane triangle", IEEE Trans. Biomed. Eng. 30.
 */
export function outlineFlux({ count, corner }: LightOutline, N: Vec4, apex: Vec3, weighted: boolean): OutlineFlux {
  const [vector, second, angle] = [vec3(0).toVar(), vec3(0).toVar(), vec2(1, 0).toVar()];
  const along = (a: Vec3, b: Vec3): void => {
    // a × (b − a) rather than a × b, which loses its digits for small outlines.
    const turn = cross(a, b.sub(a)).toVar();
    const cosine = dot(a, b).toVar();
    const sine = length(turn).toVar();
    const rate = select(sine.greaterThan(1e-4), atan(sine, cosine).div(sine.max(1e-6)), float(1));
    vector.addAssign(turn.mul(rate.mul(0.5)));
    if (!weighted) return;
    second.addAssign(turn.mul(dot(N.xyz, a.add(b)).div(cosine.add(1))));
    const half = vec2(cosine.add(1).add(dot(apex, a.add(b))), dot(apex, turn)).toVar();
    angle.assign(vec2(angle.x.mul(half.x).sub(angle.y.mul(half.y)), angle.x.mul(half.y).add(angle.y.mul(half.x))));
  };
  forEachVisibleEdge({ count, corner }, N, along);
  const solidAngle = weighted ? atan(angle.y, angle.x).mul(2).toVar() : float(0);
  const amount = dot(N.xyz, vector).add(N.w.mul(solidAngle)).toVar();
  const toward = weighted ? vector.mul(N.w).add(N.xyz.mul(solidAngle).add(second).div(3)) : vector;
  // The corners may be in either order.
  const orientation = sign(amount).toVar();
  return { amount: amount.mul(orientation).toVar(), toward: toward.mul(orientation).toVar() };
}

/** The edges of an outline clipped to N·(n, 1) ≥ 0, with the edge along the horizon. */
function forEachVisibleEdge({ count, corner }: LightOutline, N: Vec4, visit: (a: Vec3, b: Vec3) => void): void {
  const [rises, sets] = [vec3(0).toVar(), vec3(0).toVar()];
  const height = (n: Vec3): Float => dot(N.xyz, n).add(N.w);
  const a = corner(int(count - 1)).toVar();
  const ha = height(a).toVar();
  Loop({ start: int(0), end: int(count), type: 'int', condition: '<' }, ({ i }) => {
    const b = corner(int(i)).toVar();
    const hb = height(b).toVar();
    const [up, down] = [ha.greaterThanEqual(0).toVar(), hb.lessThan(0).toVar()];
    If(up.or(down.not()), () => {
      const crossing = normalize(mix(a, b, clamp(ha.div(ha.sub(hb)), 0, 1))).toVar();
      If(up.and(down), () => {
        sets.assign(crossing);
      }).ElseIf(up.not(), () => {
        rises.assign(crossing);
      });
      visit(select(up, a, crossing).toVar(), select(down, crossing, b).toVar());
    });
    a.assign(b);
    ha.assign(hb);
  });
  visit(sets, rises);
}
