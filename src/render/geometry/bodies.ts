import { rotate } from '../../math/quat.ts';
import { add, dot, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import type { HyperbolicLine } from '../../physics/worldLines/kinds/hyperbolicLine.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { objectBoundingSphere, sampleBoundingSphere } from '../../scene/bounds/bounds.ts';
import { type CubicPointsMotion, innerControlPoints, isCubic } from '../../scene/motion/cubicPoints.ts';
import type { ObjectWith } from '../../scene/motion/kinds/motionKind.ts';
import { applyPose, samplePose } from '../../scene/motion/poses.ts';
import type {
  HyperbolicMotion,
  Motion,
  Pose,
  RigidMotion,
  SampledMotion,
  SampledPointsMotion,
  SceneObject,
} from '../../scene/types.ts';

/** An object as frames need it, whatever its motion: at every world time all its points are within `radius` of `line`. */
export interface Body extends MovingBody {
  readonly object: SceneObject;
}

/** The part of a body that determines where it is. Of its object only the motion and the stretch, because meshes are large. */
export interface MovingBody {
  /** Index in Scene.objects plus one. */
  readonly id: number;
  readonly object: Pick<SceneObject, 'motion' | 'authoredIn' | 'stretch'>;
  /** Centre of the bounding sphere in the object's own frame [m]; vertices are uploaded relative to it. */
  readonly center: Vec3;
  /** Radius of the bounding sphere [m]. */
  readonly radius: number;
  /** World line of the centre, for objects authored in the world frame; otherwise see `worldLineOfCenter`. */
  readonly line: WorldLine;
}

/** Linear map from offsets of uploaded vertices to the world, about the body's centre [m]: the images of the unit vectors. */
export type LinearMap = readonly [Vec3, Vec3, Vec3];

/** How a body moves, by the kind of its motion (docs/adr/0022-motion-kinds.md). Without shaders, which workers do not load. */
interface BodyMotion<M extends Motion> {
  /** Whether one mesh can be uploaded for many bodies. */
  readonly sharesMesh: boolean;
  /** Whether events are solved per vertex, because the body turns, deforms or is in Born rigid acceleration: no single rotation and place holds for all of it. */
  readonly isSolvedPerVertex: boolean;
  /** A line and a radius such that at every world time all points of the object are within the radius of the line. */
  boundingLine(object: ObjectWith<M>): Pick<Body, 'center' | 'radius' | 'line'>;
  worldLineOfCenter(body: MovingBody, motion: M, c: number, shift: Vec3): WorldLine;
  /** See `linearMapOf`. */
  linearMap(body: MovingBody, motion: M, instanced: boolean, t: number, c: number): LinearMap | undefined;
}

const mapOf = (rotated: (axis: Vec3) => Vec3): LinearMap => [
  rotated([1, 0, 0]),
  rotated([0, 1, 0]),
  rotated([0, 0, 1]),
];

/** For motions with one orientation; meshes of single bodies are uploaded already rotated. */
const rotatedBy =
  ({ orientation }: Pose, instanced: boolean) =>
  (axis: Vec3): Vec3 =>
    instanced ? rotate(orientation, axis) : axis;

const rigid =
  <M extends RigidMotion>(lineOf: (motion: M, center: Vec3) => WorldLine) =>
  (object: ObjectWith<M>): Pick<Body, 'center' | 'radius' | 'line'> => {
    const { center, radius } = objectBoundingSphere(object);
    return { center, radius, line: lineOf(object.motion, center) };
  };

const BODY_MOTIONS: { readonly [K in Motion['kind']]: BodyMotion<Extract<Motion, { readonly kind: K }>> } = {
  static: {
    sharesMesh: true,
    isSolvedPerVertex: false,
    boundingLine: rigid(({ pose }, center) => ({ kind: 'static', position: applyPose(pose, center) })),
    worldLineOfCenter: ({ line }) => line,
    linearMap: (_body, { pose }, instanced) => mapOf(rotatedBy(pose, instanced)),
  },
  uniform: {
    sharesMesh: true,
    isSolvedPerVertex: false,
    boundingLine: rigid(({ pose, velocity }, center) => ({
      kind: 'uniform',
      position: applyPose(pose, center),
      velocity,
    })),
    worldLineOfCenter: ({ line, object, center }, { pose, velocity }, c, shift) => {
      if (object.authoredIn === 'world') return line;
      const u = properVelocity(scale(velocity, 1 / c));
      const offset = contraction(add(rotate(pose.orientation, center), shift), u);
      return { kind: 'uniform', position: add(pose.position, offset), velocity };
    },
    linearMap: ({ object }, { pose, velocity }, instanced, _t, c) => {
      const rotated = rotatedBy(pose, instanced);
      if (object.authoredIn === 'world') return mapOf(rotated);
      const u = properVelocity(scale(velocity, 1 / c));
      return mapOf((axis) => contraction(rotated(axis), u));
    },
  },
  hyperbolic: {
    sharesMesh: false,
    isSolvedPerVertex: true,
    boundingLine: rigid(({ pose, properAcceleration, t0 }, center) => ({
      kind: 'hyperbolic',
      position: applyPose(pose, center),
      properAcceleration,
      t0,
    })),
    worldLineOfCenter: hyperbolicLineOfCenter,
    linearMap: () => undefined,
  },
  sampled: {
    sharesMesh: true,
    isSolvedPerVertex: true,
    boundingLine: rigid(sampledLine),
    worldLineOfCenter: ({ line }) => line,
    linearMap: () => undefined,
  },
  'sampled-points': {
    sharesMesh: false,
    isSolvedPerVertex: true,
    boundingLine: deformingLine,
    worldLineOfCenter: ({ line }) => line,
    linearMap: () => undefined,
  },
};

const bodyMotion = ({ kind }: Pick<Motion, 'kind'>): BodyMotion<Motion> => BODY_MOTIONS[kind];

export const sharesMesh = (motion: Motion): boolean => bodyMotion(motion).sharesMesh;

export const isSolvedPerVertex = (motion: Pick<Motion, 'kind'>): boolean => bodyMotion(motion).isSolvedPerVertex;

/**
 * World line [m, s] of the bounding sphere's centre, or of the point `shift` [m] from it. c [m/s]. An object authored in its rest frame is contracted about
 * its origin; if it accelerates, every point ξ has its own acceleration a/(1 + a·ξ/c²) (Born rigidity, docs/physics.md §4.5).
 */
export const worldLineOfCenter = (body: MovingBody, c: number, shift: Vec3 = ZERO): WorldLine =>
  bodyMotion(body.object.motion).worldLineOfCenter(body, body.object.motion, c, shift);

/** `worldLineOfCenter` for hyperbolic motion. */
export function hyperbolicLineOfCenter(
  { object, center }: MovingBody,
  { pose, properAcceleration, t0 }: HyperbolicMotion,
  c: number,
  shift: Vec3 = ZERO,
): HyperbolicLine {
  const position = add(applyPose(pose, center), shift);
  if (object.authoredIn === 'world') return { kind: 'hyperbolic', position, properAcceleration, t0 };
  const offsetOverLength = dot(sub(position, pose.position), properAcceleration) / (c * c);
  return {
    kind: 'hyperbolic',
    position,
    properAcceleration: scale(properAcceleration, 1 / (1 + offsetOverLength)),
    t0,
  };
}

/**
 * Rotation and contraction of a rigid body in the world's slice at the time t [s]; c [m/s]. `instanced`: its mesh is uploaded in its own axes. Returns
 * undefined if no single map holds for all of it (`isSolvedPerVertex`).
 */
export const linearMapOf = (body: MovingBody, instanced: boolean, t: number, c: number): LinearMap | undefined =>
  bodyMotion(body.object.motion).linearMap(body, body.object.motion, instanced, t, c);

export const makeBody = (object: SceneObject, id: number): Body => ({
  id,
  object,
  ...bodyMotion(object.motion).boundingLine(object),
});

function sampledLine({ times, poses }: SampledMotion, point: Vec3): WorldLine {
  const positions = new Float64Array(times.length * 3);
  for (let k = 0; k < times.length; k++) positions.set(applyPose(samplePose(poses, k), point), 3 * k);
  return { kind: 'polyline', times, positions };
}

/** The centre follows the box of each sample, so that a deforming object that travels has a tight sphere; it also contains cubics between samples. */
function deformingLine({ motion }: ObjectWith<SampledPointsMotion>): Pick<Body, 'center' | 'radius' | 'line'> {
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
  return { center: ZERO, radius, line: { kind: 'polyline', times: motion.times, positions } };
}

/** Largest distance of a piece's inner control points from those of the centre's straight path [m]: points between them are not farther. */
function maxControlDeviation(motion: CubicPointsMotion, centers: Float64Array, k: number): number {
  const { origin } = motion;
  let square = 0;
  innerControlPoints(motion, k).forEach((points, j) => {
    const fraction = (j + 1) / 3;
    const at = (axis: number) =>
      centers[3 * k + axis] * (1 - fraction) + centers[3 * k + 3 + axis] * fraction - origin[axis];
    const [x, y, z] = [at(0), at(1), at(2)];
    for (let i = 0; i < points.length; i += 3)
      square = Math.max(square, (points[i] - x) ** 2 + (points[i + 1] - y) ** 2 + (points[i + 2] - z) ** 2);
  });
  return Math.sqrt(square);
}
