import type { Quat } from '../../math/quat.ts';
import { add, cross, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { lookAtOrientation } from './camera.ts';

/** A camera that looks at what a picture shows from outside: not from the observer's eye, and with the observer in sight. */
export interface OutsideCamera {
  /** World frame [m]: from the observer, if it follows him, else from the origin. */
  readonly place: Vec3;
  /** Whether it keeps its distance to the observer; else it stays where it is. */
  readonly follows: boolean;
  /** Camera axes (−Z forward, +Y up) → world axes. */
  readonly orientation: Quat;
  /** Vertical field of view [rad]. */
  readonly fovY: number;
}

/** Where a camera is that looks at a centre. */
export interface Orbit {
  /** [m] */
  readonly distance: number;
  /** About the scene's up axis, from the side of its front camera (−Z, or +Y where Z is up) to the right [rad]. */
  readonly azimuth: number;
  /** Above the horizontal plane, −π/2 … π/2 [rad]. */
  readonly elevation: number;
  /** Vertical field of view [rad]. */
  readonly fovY: number;
}

/**
 * A camera on a sphere about the observer (`centre` absent), or about a place of the world [m], that looks at it. At azimuth 0 it is behind one who looks the way
 * in which cameras of files look, −Z, or +Y where Z is up. `up`: the scene's upward direction, unit.
 * @example
 * // Ten metres straight behind the observer.
 * const camera = orbitCamera({ distance: 10, azimuth: 0, elevation: 0, fovY: 1 }, [0, 1, 0]);
 * camera; // { place: [0, 0, 10], follows: true, orientation: [0, 0, 0, 1] }
 */
export function orbitCamera({ distance, azimuth, elevation, fovY }: Orbit, up: Vec3, centre?: Vec3): OutsideCamera {
  const back: Vec3 = up[1] === 1 ? [0, 0, 1] : [0, -1, 0];
  const right = cross(up, back);
  const level = add(scale(back, Math.cos(azimuth)), scale(right, Math.sin(azimuth)));
  const outward = add(scale(level, Math.cos(elevation)), scale(up, Math.sin(elevation)));
  // Straight down, the top of the picture is what is ahead.
  const top = Math.abs(Math.cos(elevation)) < 1e-6 ? scale(level, -Math.sign(elevation)) : up;
  return {
    place: add(centre ?? ZERO, scale(outward, distance)),
    follows: centre === undefined,
    orientation: lookAtOrientation(scale(outward, -1), top),
    fovY,
  };
}
