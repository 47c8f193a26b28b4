import type { Vec3 } from '../../math/vec3.ts';

/**
 * A straight line of events in the world frame: at s ≥ 0 [m] the place is x + s·dx [m] and the time t + s·dt/c [s]. Light that arrives has dt = −|dx|
 * (the past light cone), a ray of the slice of simultaneity a space-like (dt, dx), a ray inside glass of refractive index n, in the
 * glass's rest frame, dt = −n|dx|. `s` is scaled by whoever makes the ray: camera rays so that s is the apparent distance in the observer's frame.
 */
export interface SpacetimeRay {
  readonly t: number;
  readonly x: Vec3;
  readonly dt: number;
  readonly dx: Vec3;
}

/** Where a ray meets a surface. */
export interface Hit {
  readonly s: number;
  /** Place in `Scene.objects`. */
  readonly object: number;
  /** Place of the triangle's first corner in `mesh.indices` of the object as it is traced (`TracedScene.objects`). */
  readonly corner: number;
  /** Weights of the second and third corner. */
  readonly v: number;
  readonly w: number;
  /** World time [s] and place [m] of the event. */
  readonly time: number;
  readonly position: Vec3;
  /** Of the surface there, world frame, units of c. */
  readonly velocity: Vec3;
  /** Unit normal of the triangle's plane in the surface's rest frame, on the world axes that the pure boost carries there; on its front side. */
  readonly normal: Vec3;
  /** The ray meets the front side. */
  readonly front: boolean;
}

/** What a ray passes through. */
export interface RayFilter {
  /** s beyond which nothing counts. */
  readonly end?: number;
  /** s before which nothing counts; 0 where absent. A ray that leaves a surface begins a little way from it. */
  readonly begin?: number;
  /** Only what can be seen: front sides, and back sides of double-sided meshes. */
  readonly visibleSides?: boolean;
  /** Called for every candidate nearer than the nearest so far: `false` lets the ray through (cut-outs, back faces). */
  readonly accepts?: (hit: Hit) => boolean;
  /** By their place in `Scene.objects`, objects whose every candidate is taken, without asking `accepts`. */
  readonly alwaysAccept?: readonly boolean[];
}
