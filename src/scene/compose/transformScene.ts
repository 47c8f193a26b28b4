import { fromParts, type Mat4, scaledUniformly } from '../../math/mat4.ts';
import { multiply, type Quat, rotate, toMatrix } from '../../math/quat.ts';
import { add, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { lightKind } from '../lights/lightKinds.ts';
import { transformMesh } from '../mesh/meshOps.ts';
import { transformPointsInPlace } from '../mesh/transformPoints.ts';
import { samplePose } from '../motion/motion.ts';
import { isStreamed } from '../streaming/samplePoints.ts';
import { transformStreamedPoints } from '../streaming/streamedPoints.ts';
import type { Light, Mesh, Motion, Pose, RigidMotion, SampledPointsMotion, Scene, SceneObject } from '../types.ts';

/** x → position + orientation · (scale · x) [m]: turned, enlarged and carried, never sheared, so that every motion stays of its kind. */
export interface SimilarityTransform {
  readonly position: Vec3;
  readonly orientation: Quat;
  /** Above 0. */
  readonly scale: number;
}

/**
 * A scene as a whole at another place: what is in it, its lamps, its cameras and the directions of its sky.
 *
 * Speeds grow with the scale, for every path is as much longer and takes as long. Of hyperbolic motion the proper acceleration does:
 * it never reaches c, so that its path is only nearly the enlarged one where it is fast.
 */
export const transformScene = (scene: Scene, by: SimilarityTransform): Scene => ({
  ...scene,
  objects: scene.objects.map((object) => transformObject(object, by)),
  lights: scene.lights.map((light) => transformLight(light, by)),
  cameras: scene.cameras.map((camera) => ({ ...camera, motion: transformRigidMotion(camera.motion, by) })),
});

export function transformObject(object: SceneObject, by: SimilarityTransform): SceneObject {
  const { motion } = object;
  return {
    ...object,
    mesh: enlargedMesh(object.mesh, motion, by),
    motion: motion.kind === 'sampled-points' ? transformSampledPoints(motion, by) : transformRigidMotion(motion, by),
  };
}

/** A deforming mesh is world-oriented: it turns with its samples. */
function enlargedMesh(mesh: Mesh, motion: Motion, { orientation, scale: s }: SimilarityTransform): Mesh {
  if (motion.kind === 'sampled-points') return transformMesh(mesh, linearOf(orientation, s));
  return s === 1 ? mesh : { ...mesh, positions: mesh.positions.map((x) => s * x) };
}

const transformPose = ({ position, orientation }: Pose, by: SimilarityTransform): Pose => ({
  position: add(by.position, rotate(by.orientation, scale(position, by.scale))),
  orientation: multiply(by.orientation, orientation),
});

const transformVelocity = (v: Vec3, by: SimilarityTransform): Vec3 => rotate(by.orientation, scale(v, by.scale));

function transformRigidMotion<M extends RigidMotion>(motion: M, by: SimilarityTransform): M;
function transformRigidMotion(motion: RigidMotion, by: SimilarityTransform): RigidMotion {
  switch (motion.kind) {
    case 'static':
      return { ...motion, pose: transformPose(motion.pose, by) };
    case 'uniform':
      return { ...motion, pose: transformPose(motion.pose, by), velocity: transformVelocity(motion.velocity, by) };
    case 'hyperbolic': {
      const properAcceleration = transformVelocity(motion.properAcceleration, by);
      return { ...motion, pose: transformPose(motion.pose, by), properAcceleration };
    }
    case 'sampled': {
      const poses = new Float64Array(motion.poses.length);
      for (let k = 0; k < motion.times.length; k++) {
        const { position, orientation } = transformPose(samplePose(motion.poses, k), by);
        poses.set([...position, ...orientation], 7 * k);
      }
      return { ...motion, poses };
    }
  }
}

function transformSampledPoints(motion: SampledPointsMotion, by: SimilarityTransform): SampledPointsMotion {
  const linear = linearOf(by.orientation, by.scale);
  const turn = linearOf(by.orientation, 1);
  const origin = transformPose({ position: motion.origin, orientation: by.orientation }, by).position;
  const { points, velocities, normals } = motion;
  return {
    ...motion,
    origin,
    points: isStreamed(points) ? transformStreamedPoints(points, linear) : points.map((each) => carried(each, linear)),
    ...(velocities && { velocities: velocities.map((each) => carried(each, linear)) }),
    ...(normals && { normals: normals.map((each) => carried(each, turn)) }),
  };
}

/** Scale, then turn. */
const linearOf = (orientation: Quat, s: number): Mat4 => scaledUniformly(fromParts(toMatrix(orientation), ZERO), s);

const carried = (vectors: Float32Array, linear: Mat4): Float32Array => transformPointsInPlace(vectors.slice(), linear);

/** Radiance does not change with the scale, so that a light of a scaled room lights it as before; of a point or line `color` is all of its light. */
function transformLight(light: Light, by: SimilarityTransform): Light {
  const turned = lightKind(light).transform(light, by);
  return 'motion' in turned ? { ...turned, motion: transformRigidMotion(turned.motion, by) } : turned;
}
