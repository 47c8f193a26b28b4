import { rotate } from '../../math/quat.ts';
import { add, dot, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { meshBoundingSphere, sampleBoundingSphere } from '../../scene/bounds/bounds.ts';
import { type CubicPointsMotion, innerControlPoints, isCubic } from '../../scene/motion/cubicPoints.ts';
import { applyPose, samplePose } from '../../scene/motion/poses.ts';
import type { Motion, SampledMotion, SampledPointsMotion, SceneObject } from '../../scene/types.ts';

/** What a frame needs to know of an object, whatever its motion: at every world time all its points are within `radius` of `line`. */
export interface Body extends MovingBody {
  readonly object: SceneObject;
}

/** As much of it as tells where it is; its motion alone, for meshes are large. */
export interface MovingBody {
  /** Place in Scene.objects plus one. */
  readonly id: number;
  readonly object: Pick<SceneObject, 'motion' | 'authoredIn'>;
  /** Centre of the bounding sphere in the object's own frame [m]; vertices are uploaded relative to it. */
  readonly center: Vec3;
  /** [m] */
  readonly radius: number;
  /** World line of the centre, of an object that is authored in the world frame; else see `worldLineOfCenter`. */
  readonly line: WorldLine;
}

/**
 * World line [m, s] of the bounding sphere's centre, or of the point `shift` [m] from it. c [m/s]: an object authored in its rest
 * frame is contracted about its origin, and where it accelerates every point has its own acceleration a/(1 + a·ξ/c²) (Born rigid).
 */
export function worldLineOfCenter(body: MovingBody, c: number, shift: Vec3 = ZERO): WorldLine {
  const { line, object } = body;
  const { motion } = object;
  if (line.kind === 'uniform' && motion.kind === 'uniform' && object.authoredIn === 'rest') {
    const offset = rotate(motion.pose.orientation, body.center);
    const u = properVelocity(scale(motion.velocity, 1 / c));
    return { ...line, position: add(motion.pose.position, contraction(add(offset, shift), u)) };
  }
  if (line.kind !== 'hyperbolic' || motion.kind !== 'hyperbolic') return line;
  const position = add(line.position, shift);
  if (object.authoredIn === 'world') return { ...line, position };
  const ahead = dot(sub(position, motion.pose.position), motion.properAcceleration) / (c * c);
  return { ...line, position, properAcceleration: scale(motion.properAcceleration, 1 / (1 + ahead)) };
}

export function makeBody(object: SceneObject, id: number): Body {
  const { motion } = object;
  if (motion.kind === 'sampled-points') return deformingBody(object, motion, id);
  const { center, radius } = meshBoundingSphere(object.mesh);
  return { id, object, center, radius, line: lineOfPoint(motion, center) };
}

function lineOfPoint(motion: Exclude<Motion, SampledPointsMotion>, point: Vec3): WorldLine {
  if (motion.kind === 'sampled') return sampledLine(motion, point);
  const position = applyPose(motion.pose, point);
  if (motion.kind === 'static') return { kind: 'static', position };
  if (motion.kind === 'uniform') return { kind: 'uniform', position, velocity: motion.velocity };
  return { kind: 'hyperbolic', position, properAcceleration: motion.properAcceleration, t0: motion.t0 };
}

function sampledLine({ times, poses }: SampledMotion, point: Vec3): WorldLine {
  const positions = new Float64Array(times.length * 3);
  for (let k = 0; k < times.length; k++) positions.set(applyPose(samplePose(poses, k), point), 3 * k);
  return { kind: 'polyline', times, positions };
}

/** The centre follows the box of each sample, so that a deforming object that travels has a tight sphere, also round cubics. */
function deformingBody(object: SceneObject, motion: SampledPointsMotion, id: number): Body {
  const positions = new Float64Array(motion.times.length * 3);
  let radius = 0;
  for (let k = 0; k < motion.times.length; k++) {
    const sphere = sampleBoundingSphere(motion, k);
    positions.set(add(motion.origin, sphere.center), 3 * k);
    radius = Math.max(radius, sphere.radius);
  }
  if (isCubic(motion))
    for (let k = 0; k + 1 < motion.times.length; k++)
      radius = Math.max(radius, maxControlDeviation(motion, positions, k));
  return { id, object, center: ZERO, radius, line: { kind: 'polyline', times: motion.times, positions } };
}

/** How far the inner control points of a piece are from those of the centre's own straight way [m]: what is between is not farther. */
function maxControlDeviation(motion: CubicPointsMotion, centers: Float64Array, k: number): number {
  const { origin } = motion;
  let square = 0;
  innerControlPoints(motion, k).forEach((points, j) => {
    const share = (j + 1) / 3;
    const at = (axis: number) => centers[3 * k + axis] * (1 - share) + centers[3 * k + 3 + axis] * share - origin[axis];
    const [x, y, z] = [at(0), at(1), at(2)];
    for (let i = 0; i < points.length; i += 3)
      square = Math.max(square, (points[i] - x) ** 2 + (points[i + 1] - y) ** 2 + (points[i + 2] - z) ** 2);
  });
  return Math.sqrt(square);
}
