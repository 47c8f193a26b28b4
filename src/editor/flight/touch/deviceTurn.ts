import { radians } from '../../../math/angle.ts';
import { conjugate, fromAxisAngle, multiply, type Quat, rotate } from '../../../math/quat.ts';
import { length, scale, type Vec3 } from '../../../math/vec3.ts';

/** How a device is held, as its system tells [degrees]: about the vertical, its right and its top, one after another. */
export interface DeviceAngles {
  readonly alpha: number;
  readonly beta: number;
  readonly gamma: number;
}

/** The axes of a screen, right, top and out of it, against those of the ground, east, north and up. `screenAngle`: by which the page is turned on the device [degrees]. */
export function screenOrientation({ alpha, beta, gamma }: DeviceAngles, screenAngle: number): Quat {
  const about = (axis: Vec3, angle: number): Quat => fromAxisAngle(axis, radians(angle));
  const device = multiply(multiply(about([0, 0, 1], alpha), about([1, 0, 0], beta)), about([0, 1, 0], gamma));
  return multiply(device, about([0, 0, 1], -screenAngle));
}

/** The turn from one orientation of the screen to another, as controls ask for it [rad]: `level` about the vertical and up and down, otherwise about the axes of the screen. */
export function deviceTurn(before: Quat, after: Quat, level: boolean): Vec3 {
  if (level) {
    const [from, to] = [lookOf(before), lookOf(after)];
    const yaw = to.heading - from.heading;
    return [to.elevation - from.elevation, yaw - 2 * Math.PI * Math.round(yaw / (2 * Math.PI)), 0];
  }
  const [x, y, z, w] = multiply(conjugate(before), after);
  const axis: Vec3 = w < 0 ? [-x, -y, -z] : [x, y, z];
  const sine = length(axis);
  return sine === 0 ? [0, 0, 0] : scale(axis, (2 * Math.atan2(sine, Math.abs(w))) / sine);
}

/** Where one looks through a screen [rad]. The heading is that of its right, which exists also where one looks straight down. */
function lookOf(orientation: Quat): { readonly heading: number; readonly elevation: number } {
  const right = rotate(orientation, [1, 0, 0]);
  const ahead = rotate(orientation, [0, 0, -1]);
  return { heading: Math.atan2(right[1], right[0]), elevation: Math.asin(Math.max(-1, Math.min(1, ahead[2]))) };
}
