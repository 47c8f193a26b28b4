import type { Vec3 } from '../../../math/vec3.ts';
import type { LensModel } from './lensModel.ts';

/** An angular fisheye, also called equidistant: the distance from the middle of the circle is proportional to the angle from the axis. */
export interface FisheyeLens {
  readonly kind: 'fisheye';
  /** Angle across the whole circle, 0 … 2π [rad]. */
  readonly aperture: number;
  /**
   * Of its axis above the camera's forward direction [rad]. 0: what is ahead is in the middle. π/2: the zenith is in the middle and what is ahead at the bottom, as in
   * dome masters; a dome that is tilted forward by τ has π/2 − τ.
   */
  readonly elevation: number;
}

/**
 * A lens for dome masters: the zenith of the dome in the middle, what is ahead below it. `aperture` of the circle, `tilt` of the dome towards the front [rad].
 * @example
 * domeLens(Math.PI, Math.PI / 9); // { kind: 'fisheye', aperture: 3.1416, elevation: 1.2217 }
 */
export const domeLens = (aperture: number, tilt: number): FisheyeLens => ({
  kind: 'fisheye',
  aperture,
  elevation: Math.PI / 2 - tilt,
});

/** Right, up and back of the lens to those of the camera: about the right axis. */
function raised([right, up, back]: Vec3, elevation: number): Vec3 {
  const [sine, cosine] = [Math.sin(elevation), Math.cos(elevation)];
  return [right, cosine * up - sine * back, sine * up + cosine * back];
}

/** A direction on axes that are tilted with the lens: +Y is its axis, the zenith of a dome, and −Z what is at the bottom of the circle. */
export const towardsZenith = ({ elevation }: FisheyeLens, direction: Vec3): Vec3 =>
  raised(direction, Math.PI / 2 - elevation);

/** θ = r A/2 with r the distance from the middle over the circle's radius. A pixel has the solid angle (sin θ/θ)(A/d)², d the circle's diameter [px]. */
export const fisheyeModel: LensModel<FisheyeLens> = {
  directionAt({ aperture, elevation }, [x, y]) {
    const r = Math.hypot(x, y);
    if (r > 1) return undefined;
    const theta = (r * aperture) / 2;
    const spread = r > 0 ? Math.sin(theta) / r : 0;
    return raised([spread * x, spread * y, -Math.cos(theta)], elevation);
  },
  placeOf({ aperture, elevation }, direction) {
    const [right, up, back] = raised(direction, -elevation);
    const sine = Math.hypot(right, up);
    if (sine === 0) return back < 0 ? [0, 0] : undefined;
    const r = Math.atan2(sine, -back) / (aperture / 2);
    return [(r * right) / sine, (r * up) / sine];
  },
  pixelSolidAngle({ aperture }, [x, y], { width }) {
    const r = Math.hypot(x, y);
    if (r > 1) return 0;
    const theta = (r * aperture) / 2;
    return (theta > 0 ? Math.sin(theta) / theta : 1) * (aperture / width) ** 2;
  },
  pixelsPerRadian({ aperture }, { width }) {
    const theta = Math.min(aperture, Math.PI) / 2;
    return (width / aperture) * Math.sqrt(theta / Math.sin(theta));
  },
};
