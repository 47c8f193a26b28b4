import { type Quat, rotate } from '../../math/quat.ts';
import { addScaled, dot, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { gamma } from '../../physics/lorentz/boost.ts';
import type { BoundingSphere } from '../../scene/bounds/bounds.ts';
import type { Frustum } from '../../scene/view/lenses/perspectiveLens.ts';

/** Directions n with n·axis ≥ cosine, |axis| = 1. Covers more than half the sky where cosine < 0. */
export interface Cone {
  readonly axis: Vec3;
  readonly cosine: number;
}

/** The directions from the origin to a sphere; undefined if the origin is inside it. */
export function coneAround({ center, radius }: BoundingSphere): Cone | undefined {
  const distance = length(center);
  if (!(distance > radius)) return undefined;
  const sine = radius / distance;
  return { axis: scale(center, 1 / distance), cosine: Math.sqrt(1 - sine * sine) };
}

/**
 * A cone of directions for an observer with proper velocity u; aberration takes circles on the sky to circles.
 * With p = ω(1, n) the light from n (as a place, not a propagation), n·m ≥ k is N·p ≥ 0 for N = (k, m), and
 * p′ = (γω(1 + β·n), …) makes N′ = (γk + u·m, m + [u·m/(γ + 1) + k]u), which is space-like: |m′|² − k′² = 1 − k².
 */
export function aberrateCone({ axis, cosine }: Cone, u: Vec3): Cone {
  const g = gamma(u);
  const along = dot(u, axis);
  const boosted = addScaled(axis, u, along / (g + 1) + cosine);
  const size = length(boosted);
  return { axis: scale(boosted, 1 / size), cosine: (g * cosine + along) / size };
}

/** Inward unit normals of the four side planes of the frustum, on the axes that the orientation refers to. */
export function frustumSides(orientation: Quat, { tanX, tanY, center: [x, y] }: Frustum): Vec3[] {
  const sides: Vec3[] = [
    [1, 0, x - tanX],
    [-1, 0, -x - tanX],
    [0, 1, y - tanY],
    [0, -1, -y - tanY],
  ];
  return sides.map((s) => rotate(orientation, normalize(s)));
}

/** False only if no direction of the cone is inside the frustum. */
export function coneMayIntersectFrustum(cone: Cone, sides: readonly Vec3[]): boolean {
  if (cone.cosine <= 0) return true;
  const sine = Math.sqrt(Math.max(0, 1 - cone.cosine * cone.cosine));
  return sides.every((side) => dot(side, cone.axis) >= -sine - 1e-9);
}
