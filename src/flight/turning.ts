import {
  fromAxisAngle,
  IDENTITY,
  multiply,
  normalizeQuat,
  type Quat,
  rotate,
  shortestRotation,
  slerp,
} from '../math/quat.ts';
import { dot, length, type Vec3 } from '../math/vec3.ts';

const RIGHT: Vec3 = [1, 0, 0];
const TOP: Vec3 = [0, 1, 0];
/** Where a ship's nose points, in its axes. */
export const NOSE: Vec3 = [0, 0, -1];

/** How near one looks to the zenith where the horizon is kept [rad]. */
const ZENITH = 0.02;

/** Turns by yaw about the scene's up axis, then pitch about the ship's right [rad]; pitch ends before the vertical. */
export function turnLevel(orientation: Quat, [pitch, yaw]: Vec3, up: Vec3): Quat {
  const turned = multiply(fromAxisAngle(up, yaw), orientation);
  const elevation = Math.asin(Math.max(-1, Math.min(1, dot(rotate(turned, NOSE), up))));
  const limit = Math.PI / 2 - ZENITH;
  const bounded = Math.max(-limit, Math.min(limit, elevation + pitch)) - elevation;
  return normalizeQuat(multiply(fromAxisAngle(rotate(turned, RIGHT), bounded), turned));
}

/** Turns by a rotation vector along the ship's own axes [rad]. */
export function turnFreely(orientation: Quat, turn: Vec3): Quat {
  const angle = length(turn);
  return angle === 0 ? orientation : normalizeQuat(multiply(orientation, fromAxisAngle(turn, angle)));
}

/** Rolls by at most `angle` [rad] until the ship's right is level; where the nose is vertical there is nothing to level. */
export function levelled(orientation: Quat, up: Vec3, angle = Math.PI): Quat {
  const roll = Math.atan2(-dot(rotate(orientation, RIGHT), up), dot(rotate(orientation, TOP), up));
  if (roll === 0 || Math.abs(dot(rotate(orientation, NOSE), up)) > Math.cos(ZENITH / 2)) return orientation;
  return turnFreely(orientation, [0, 0, Math.max(-angle, Math.min(angle, roll))]);
}

/** Turns the nose towards a direction, by the part `share` of the angle, 0 … 1. */
export function noseTowards(orientation: Quat, direction: Vec3, share: number): Quat {
  const whole = shortestRotation(rotate(orientation, NOSE), direction);
  return normalizeQuat(multiply(slerp(IDENTITY, whole, share), orientation));
}
