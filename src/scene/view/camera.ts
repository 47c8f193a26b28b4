import { fromMatrix, type Quat, rotate } from '../../math/quat.ts';
import { addScaled, cross, length, negate, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { cubicPiece } from '../../physics/worldLines/kinds/cubicLine.ts';
import { positionAt, properVelocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { boxSupport } from '../bounds/bounds.ts';
import { animationSupport } from '../bounds/sceneBounds.ts';
import type { Support } from '../bounds/supportMap.ts';
import { restingAt } from '../defaults.ts';
import { originWorldLine, poseAt, sampleTimes } from '../motion/motion.ts';
import type { Scene, SceneCamera } from '../types.ts';
import type { Lens } from './lenses/lenses.ts';
import { perspective } from './lenses/perspectiveLens.ts';

/** The observer at a camera at one moment. */
export interface CameraState {
  /** World frame [m]. */
  readonly position: Vec3;
  /** γβ of the camera's world line, world frame. */
  readonly u: Vec3;
  /** Camera axes in the world's axes carried by the pure boost with u. */
  readonly orientation: Quat;
  /** In the observer's frame. */
  readonly lens: Lens;
}

/**
 * The observer at a camera at world time t [s], with its velocity; c [m/s]. At a sample that is the velocity of the piece that begins there; at the last sample,
 * of the piece that ends there, so that the last picture of an animation still shows the motion.
 * @example
 * const observer = observerFromCamera({ path: '/Eye', motion: restingAt([0, 1, 5]), fovY: 1 }, 0, 10);
 * observer; // { position: [0, 1, 5], u: [0, 0, 0] }
 */
export function observerFromCamera(camera: SceneCamera, t: number, c: number): CameraState {
  const { motion, course, fovY } = camera;
  const pose = { ...poseAt(motion, t, c), ...(course && { position: positionAt(course.line, t, c) }) };
  return { ...pose, u: riddenVelocity(camera, t, c), lens: perspective(fovY) };
}

/** The world line of one who rides on a camera. */
export const riddenLine = ({ motion, course }: SceneCamera): WorldLine => course?.line ?? originWorldLine(motion);

/** γβ */
function riddenVelocity(camera: SceneCamera, t: number, c: number): Vec3 {
  const { motion, course } = camera;
  const times = sampleTimes(motion);
  if (!times || times[times.length - 1] !== t) return properVelocityAt(riddenLine(camera), t, c);
  const last = times.length - 2;
  return course
    ? properVelocity(scale(cubicPiece(course.line, last).vb, 1 / c))
    : properVelocityAt(riddenLine(camera), times[last], c);
}

/**
 * Orientation of a camera (−Z forward, +Y up) that looks along `forward`, with `up` as far up as possible. Vectors of any non-zero length.
 * @example
 * import { quat } from 'slowlight/math';
 * // The camera's forward axis is −Z.
 * quat.rotate(lookAtOrientation([1, 0, 0], [0, 1, 0]), [0, 0, -1]); // [1, 0, 0]
 */
export function lookAtOrientation(forward: Vec3, up: Vec3): Quat {
  const back = normalize(negate(forward), [0, 0, 1]);
  const sideways = cross(up, back);
  // Looking along `up`: any perpendicular direction will do.
  const spare: Vec3 = Math.abs(back[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const right =
    length(sideways) > 1e-9 * length(up)
      ? normalize(sideways)
      : normalize(addScaled(spare, back, -back[0] * spare[0] - back[1] * spare[1]));
  const top = cross(back, right);
  return fromMatrix([right[0], top[0], back[0], right[1], top[1], back[1], right[2], top[2], back[2]]);
}

const FRAMING_FOV = Math.PI / 3;
/** The part of half the picture's height to which things reach. */
const FRAMED = 0.9;
/** Least distance to what is nearest [m]. */
const MIN_DISTANCE = 2e-3;

/**
 * A camera for scenes without one: at rest and slightly above, as near as the outline of all objects, during the whole animation, allows that fills 9/10 of a square picture. A point (x, y, z) on the camera's axes is in a picture of half-width k per distance
 * if |x − x₀| ≤ k(z₀ − z), so that 2kz₀ ≥ max(x + kz) + max(kz − x), with the camera midway.
 * @example
 * const scene = makeScene({ name: 'one', objects: [makeObject({ path: '/Ball', mesh: sphere(1) })] });
 * framingCamera(scene).fovY; // 1.0472 rad
 */
export function framingCamera(scene: Scene): SceneCamera {
  const c = scene.hints.speedOfLight ?? SPEED_OF_LIGHT;
  const up: Vec3 = scene.upAxis === 'Z' ? [0, 0, 1] : [0, 1, 0];
  const aside: Vec3 = scene.upAxis === 'Z' ? [0.55, -1, 0] : [0.55, 0, 1];
  const back = normalize(addScaled(aside, up, 0.45));
  const orientation = lookAtOrientation(negate(back), up);
  const [right, top] = [rotate(orientation, [1, 0, 0]), rotate(orientation, [0, 1, 0])];
  const reach = animationSupport(scene, scene.hints.openAt ?? scene.startTime, c);
  const support: Support = Number.isFinite(reach(back)) ? reach : boxSupport({ min: [-1, -1, -1], max: [1, 1, 1] });
  const k = FRAMED * Math.tan(FRAMING_FOV / 2);
  const fitted = (axis: Vec3): readonly [at: number, distance: number] => {
    const [one, other] = [1, -1].map((sign) => support(addScaled(scale(back, k), axis, sign)));
    return [(one - other) / 2, (one + other) / (2 * k)];
  };
  const [[x, forX], [y, forY]] = [fitted(right), fitted(top)];
  const z = Math.max(forX, forY, support(back) + MIN_DISTANCE);
  const { pose } = restingAt(addScaled(addScaled(scale(back, z), right, x), top, y));
  return { path: '/FramingCamera', motion: { kind: 'static', pose: { ...pose, orientation } }, fovY: FRAMING_FOV };
}
