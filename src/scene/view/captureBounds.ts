import { type Quat, rotate } from '../../math/quat.ts';
import { dot, length, type Vec3 } from '../../math/vec3.ts';
import { CAPTURE_TEXELS, type CaptureSettings } from './capture.ts';
import { isPanoramic, type Lens, perspectiveOf, pixelsPerRadian } from './lenses/lenses.ts';
import { farthestCorner, frustumOf, pixelsPerTangent } from './lenses/perspectiveLens.ts';
import type { PictureSize } from './pictureSize.ts';

/** Largest side that is chosen by the picture. */
const MAX_OWN_TEXELS = 1024;

/** Side of the faces for a picture [px]. */
export function captureTexels(
  { texels }: CaptureSettings,
  { lens }: { readonly lens: Lens },
  size: PictureSize,
): number {
  const { min, max } = CAPTURE_TEXELS;
  if (texels > 0) return clamp(Math.round(texels), min, max);
  return clamp(Math.ceil(2 * pixelsPerRadian(lens, size)), min, MAX_OWN_TEXELS);
}

/**
 * Upper bound of the pixels of a picture per radian at rest: that of the lens, f sec² θ of a perspective one, times 1/D = γ − |u| cos θ′ of the direction farthest
 * from that of flight. `u`: γβ that directions are boosted by.
 */
export function pixelsPerRestRadian(
  { lens, orientation }: { readonly lens: Lens; readonly orientation: Quat },
  u: Vec3,
  size: PictureSize,
): number {
  const { pixels, reach } = isPanoramic(lens)
    ? { pixels: pixelsPerRadian(lens, size), reach: Math.PI }
    : perspectiveReach(lens, size);
  const w = length(u);
  const ahead = w === 0 ? 1 : clamp(dot(u, rotate(orientation, [0, 0, -1])) / w, -1, 1);
  const farthest = Math.cos(Math.min(Math.PI, Math.acos(ahead) + reach));
  return pixels * (Math.hypot(1, w) - w * farthest);
}

/** At the corner farthest from the axis: pixels per radian, and its angle from the axis [rad]. */
function perspectiveReach(lens: Lens, { width, height }: PictureSize): { pixels: number; reach: number } {
  const frustum = frustumOf(perspectiveOf(lens), width, height);
  const tangent = Math.hypot(...farthestCorner(frustum));
  return { pixels: pixelsPerTangent(frustum, width, height) * (1 + tangent ** 2), reach: Math.atan(tangent) };
}

/**
 * Upper bound of the angle at rest by which an observer who has moved by `moved` [m] sees a resting ball elsewhere than before: |Δp⊥|/R, R the distance of its
 * nearest point on the way [rad]; ∞ if he may have come to it. `center`: of the ball from where he was [m].
 */
export function parallaxBound(center: Vec3, radius: number, moved: Vec3): number {
  const [step, distance] = [length(moved), length(center)];
  if (step === 0) return 0;
  const nearest = distance - radius - step;
  if (!(nearest > 0)) return Number.POSITIVE_INFINITY;
  const aside = Math.acos(clamp(dot(center, moved) / (distance * step), -1, 1));
  // Of all points of the ball, from all places on the way.
  const spread = Math.asin(Math.min(1, (radius + step) / distance));
  const widest =
    Math.abs(aside - Math.PI / 2) <= spread ? 1 : Math.max(Math.sin(aside - spread), Math.sin(aside + spread));
  return (step * widest) / nearest;
}

const clamp = (x: number, min: number, max: number): number => Math.max(min, Math.min(max, x));
