import type { Quat } from '../../math/quat.ts';
import { add, cross, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { VIEWS } from '../views/views.ts';
import { lookAtOrientation } from './camera.ts';
import { perspective } from './lens.ts';
import type { RenderSettings, ViewPoint } from './view.ts';

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

/** From the observer to the camera that his picture is drawn from [m]. */
const offsetOf = ({ position }: ViewPoint, { place, follows }: OutsideCamera): Vec3 =>
  follows ? place : sub(place, position);

/**
 * The view point that a picture or one of its G-buffers is drawn from: the observer's own, or that of its outside camera. The world's moment (c = ∞) is the
 * same for every observer, so that the camera is one there, and its light is what he would see; of all else it shows what the observer himself sees, from aside.
 */
export function drawnFrom(view: ViewPoint, settings: Pick<RenderSettings, 'outside' | 'view'>): ViewPoint {
  const { outside } = settings;
  if (!outside) return view;
  const { vantage: _, ...observer } = view;
  const { orientation, fovY } = outside;
  const camera = { ...observer, orientation, lens: perspective(fovY) };
  const offset = offsetOf(view, outside);
  return VIEWS[settings.view].relativistic
    ? { ...camera, vantage: offset }
    : { ...camera, position: add(view.position, offset) };
}

/** From the camera of a picture to the observer [m]; zero if it is at his eye. */
export const toObserver = (view: ViewPoint, { outside }: Pick<RenderSettings, 'outside'>): Vec3 =>
  outside ? scale(offsetOf(view, outside), -1) : ZERO;

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
