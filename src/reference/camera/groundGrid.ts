import { dot, lerp, type Vec3 } from '../../math/vec3.ts';
import { halfDiagonal } from '../../scene/bounds/bounds.ts';
import { upVector } from '../../scene/lights/sceneLights.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { motionTracer } from '../intersection/motionTracers.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import { directionAt } from './lensRay.ts';

/** A colour drawn over the picture with the opacity `cover`, 0 … 1. Display values, linear sRGB. */
export interface Overlay {
  readonly color: Vec3;
  readonly cover: number;
}

const MINOR: Vec3 = [0.02, 0.42, 0.62];
const MAJOR: Vec3 = [0.05, 0.75, 0.95];
const NONE: Overlay = { color: MINOR, cover: 0 };

/**
 * The ground's reference grid at a point of the picture, as in the rasterizer (render/post/display/grid.ts): straight lines in the observer's frame,
 * as a plane below the observer at its altitude would look without relativity. `depth`: apparent distance of the visible surface [m].
 */
export function groundGrid(
  traced: TracedScene,
  view: ViewPoint,
  width: number,
  height: number,
): (x: number, y: number, depth: number) => Overlay {
  const { upAxis } = traced.scene;
  const up = upVector(upAxis);
  const east: Vec3 = [1, 0, 0];
  const north: Vec3 = upAxis === 'Y' ? [0, 0, 1] : [0, 1, 0];
  const step = gridStep(traced);
  const altitude = dot(view.position, up);
  const distanceAlong = (n: Vec3): number => altitude / -dot(n, up);
  /** Where a direction meets the ground, in grid steps. */
  const place = (n: Vec3): readonly number[] =>
    [east, north].map((axis) => (dot(view.position, axis) + distanceAlong(n) * dot(n, axis)) / step);
  return (x, y, depth) => {
    const n = directionAt(view, x, y, width, height);
    const [toRight, below] = [directionAt(view, x + 1, y, width, height), directionAt(view, x, y + 1, width, height)];
    if (!n || !toRight || !below) return NONE;
    const distance = distanceAlong(n);
    if (!(distance > 0 && distance < 1.02 * depth)) return NONE;
    const [here, across, down] = [place(n), place(toRight), place(below)];
    const footprint = here.map((p, k) => Math.max(Math.abs(across[k] - p) + Math.abs(down[k] - p), 1e-6));
    const minor = lines(here, footprint, 1.1);
    const major = lines(
      here.map((p) => p / 10),
      footprint.map((f) => f / 10),
      1.6,
    );
    const faded = Math.exp(-((distance / (120 * step)) ** 2));
    return { color: lerp(MINOR, MAJOR, major), cover: Math.max(0.55 * minor, 0.9 * major) * faded };
  };
}

/** Coverage of lines at integers, `width` pixels wide; they fade out where they are closer than pixels. */
function lines(place: readonly number[], footprint: readonly number[], width: number): number {
  const each = place.map((p, k) => {
    const away = Math.abs(p - Math.round(p)) / footprint[k];
    const dense = 1 - clamped(2 * footprint[k] - 0.4);
    return (1 - smoothstep(width / 2 - 0.5, width / 2 + 0.5, away)) * dense;
  });
  return Math.max(...each);
}

const clamped = (x: number): number => Math.min(Math.max(x, 0), 1);
function smoothstep(from: number, to: number, x: number): number {
  const s = clamped((x - from) / (to - from));
  return s * s * (3 - 2 * s);
}

const steps = new WeakMap<TracedScene, number>();

/** Distance of the finer lines [m]: a power of ten that depends on the scene's size. */
function gridStep(traced: TracedScene): number {
  const cached = steps.get(traced);
  if (cached) return cached;
  const step =
    10 **
    Math.floor(
      Math.log10(
        Math.max(halfDiagonal(traced.objects.map((object) => motionTracer(object.motion).startSphere(object))), 1e-6) /
          15,
      ),
    );
  steps.set(traced, step);
  return step;
}
