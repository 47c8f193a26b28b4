import type { Vec3 } from '../../math/vec3.ts';

/**
 * A straight line of events in the world frame: at s ≥ 0 the position is x + s·dx [m] and the time t + s·dt/c [s]. Arriving light has dt = −|dx|
 * (the past light cone), a ray in a slice of simultaneity a space-like (dt, dx), a ray inside glass of refractive index n, in the
 * glass's rest frame, dt = −n|dx|. The length of (dt, dx) sets the scale of s: for camera rays s is the apparent distance in the observer's frame [m].
 * docs/physics.md §10.1.
 */
export interface SpacetimeRay {
  /** World time at s = 0 [s]. */
  readonly t: number;
  /** Position at s = 0, world frame [m]. */
  readonly x: Vec3;
  /** c times the change of the time for each s [m]. */
  readonly dt: number;
  /** Change of the position for each s [m]. */
  readonly dx: Vec3;
  /** What is seen along it from beside the eye: the ray itself is that curve's asymptote then, light from infinity. */
  readonly curve?: SightCurve;
}

/**
 * The events that a camera beside the observer's eye (`ViewPoint.vantage`) sees one behind another: a straight line in his space, each event of which sent its light to his eye.
 * s: distance from the camera in his space [m]. docs/physics.md §10.5.
 */
export interface SightCurve {
  /** Where chords of it end, in order; the first is 0 and the last infinite. */
  readonly knots: readonly number[];
  /** The straight ray through the events at knots k and k + 1. */
  chord(k: number): SpacetimeRay;
  /** The straight ray that touches it at s. */
  tangent(s: number): SpacetimeRay;
  /** The ray of light by which the observer sees the event at s; its own s is the distance from his eye. */
  lightFrom(s: number): SpacetimeRay;
}

/**
 * The ray of light by which a hit of a camera ray is seen: that ray itself, but from beside the eye.
 * @example
 * const ray = { t: 0, x: [0, 0, 0], dt: -1, dx: [0, 0, -1] } as const;
 * lightOf(ray, { s: 4 }); // { dt: -1, dx: [0, 0, -1] }
 */
export const lightOf = (ray: SpacetimeRay, { s }: Pick<Hit, 's'>): SpacetimeRay => ray.curve?.lightFrom(s) ?? ray;

/** Where a ray meets a surface. */
export interface Hit {
  /** Place on the ray. */
  readonly s: number;
  /** Index in `Scene.objects`. */
  readonly object: number;
  /** Index of the triangle's first corner in `mesh.indices` of the object in `TracedScene.objects`. */
  readonly corner: number;
  /** Barycentric weight of the second corner. */
  readonly v: number;
  /** Barycentric weight of the third corner. */
  readonly w: number;
  /** World time of the event [s]. */
  readonly time: number;
  /** World position of the event [m]. */
  readonly position: Vec3;
  /** Velocity of the surface at the event, world frame [c]. */
  readonly velocity: Vec3;
  /** Unit normal of the triangle's plane on its front side, in the surface's rest frame, on the world axes carried there by the pure boost. */
  readonly normal: Vec3;
  /** Whether the ray meets the front side. */
  readonly front: boolean;
}

/** Which hits of a ray count. */
export interface RayFilter {
  /** Hits beyond this s are ignored. */
  readonly end?: number;
  /** Hits before this s are ignored; default 0. A ray that leaves a surface begins a little away from it. */
  readonly begin?: number;
  /** Any hit will do, not only the nearest: the search ends with the first one that it finds. */
  readonly any?: boolean;
  /** Only visible sides count: front sides, and back sides of double-sided meshes. */
  readonly visibleSides?: boolean;
  /** Called for every candidate nearer than the nearest so far; `false` lets the ray through (cut-outs, back faces). */
  readonly accepts?: (hit: Hit) => boolean;
  /** Per index in `Scene.objects`: whether every candidate is accepted without calling `accepts`. */
  readonly alwaysAccept?: readonly boolean[];
}
