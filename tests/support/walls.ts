import type { Obstacles, Wall, WorldSegment } from '../../src/flight/collision/obstacles.ts';
import { addScaled, dot, normalize, type Vec3 } from '../../src/math/vec3.ts';

/** A plane through `at` [m] at world time 0, with any normal, that moves with `beta` [c] in its own direction. */
export interface Plane {
  readonly at: Vec3;
  readonly normal: Vec3;
  readonly beta: number;
}

/** Planes that fill all of space, met in closed form. c [m/s]. */
export const planes = (all: readonly Plane[], c: number): Obstacles => ({
  first(segment, end) {
    const met = all.flatMap((plane) => meeting(plane, segment, end, c) ?? []);
    return met.sort((a, b) => a.part - b.part)[0]?.wall;
  },
});

/** n·x = n·x₀ + βct. A boost along the normal leaves it as it is. */
function meeting(
  { at, normal, beta }: Plane,
  { start, dt, dx }: WorldSegment,
  end: number,
  c: number,
): { readonly part: number; readonly wall: Wall } | undefined {
  const n = normalize(normal);
  const ahead = dot(n, at) + beta * c * start.t - dot(n, start.x);
  const part = ahead / (dot(n, dx) - beta * c * dt);
  if (!(part >= 0 && part <= end)) return undefined;
  const event = { t: start.t + part * dt, x: addScaled(start.x, dx, part) };
  const direction: Vec3 = beta < 0 ? [-n[0], -n[1], -n[2]] : n;
  return { part, wall: { event, velocity: { direction, rapidity: Math.atanh(Math.abs(beta)) }, normal: n } };
}
