import { rotate } from '../../math/quat.ts';
import { add, lerp, type Vec3, ZERO } from '../../math/vec3.ts';
import { type BoundingSphere, objectBoundingSphere, sampleBoundingSphere } from '../../scene/bounds/bounds.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { objectNormal, objectPoint } from '../../scene/mesh/stretch.ts';
import { deformedPoints } from '../../scene/motion/deformedPoints.ts';
import type { ObjectWith } from '../../scene/motion/kinds/motionKind.ts';
import { applyPose, pieceAt, samplePose } from '../../scene/motion/poses.ts';
import { normalsAt } from '../../scene/streaming/samplePoints.ts';
import type { Motion, Pose, SampledMotion, SceneObject, UniformMotion } from '../../scene/types.ts';
import type { ObjectIntersector } from '../acceleration/rayQuery.ts';
import type { TriangleBvh } from '../acceleration/triangleBvh.ts';
import { HyperbolicRayIntersector } from './hyperbolic.ts';
import { HyperbolicQuadricIntersector } from './quadrics/hyperbolicQuadric.ts';
import { RigidQuadricIntersector } from './quadrics/rigidQuadric.ts';
import type { RoundSolid } from './quadrics/roundSolid.ts';
import { SampledQuadricIntersector } from './quadrics/sampledQuadric.ts';
import { RigidIntersector } from './rigid.ts';
import { PointShapes } from './sampled/pointShapes.ts';
import { SampledPointsRayIntersector } from './sampled/sampledPoints.ts';
import { SampledPosesRayIntersector } from './sampled/sampledPoses.ts';
import { SampledShapes, type ShapeCache } from './sampled/sampledShapes.ts';

/** What an intersector is created from, besides its object. */
export interface TracerInputs {
  /** Index in `Scene.objects`. */
  readonly index: number;
  /** [m/s] */
  readonly c: number;
  /** The BVH of a mesh of constant shape. */
  readonly tree: () => TriangleBvh;
  /** What is seen instead of the mesh's triangles, if it is round. */
  readonly solid: RoundSolid | undefined;
  readonly store: ShapeCache;
}

/** The reference renderer's functions for one kind of motion (docs/adr/0022-motion-kinds.md). */
interface MotionTracer<M extends Motion> {
  /** Whether one BVH of the mesh serves all times and all objects that share it. */
  readonly keepsShape: boolean;
  /** Whether its intersector maps rays to the axes of the mesh, so that bodies of other proportions share that BVH; for others stretches are baked. */
  readonly mapsToMesh: boolean;
  createIntersector(object: ObjectWith<M>, inputs: TracerInputs): ObjectIntersector;
  /** Whether shape and normals are those on a slice of world time, where the object moves, and not those at rest. */
  isAuthoredMoving(object: ObjectWith<M>): boolean;
  /** Vertex → position on the slice of world time t (in the rest frame for objects authored at rest), relative to a common origin. */
  vertexPlaces(object: ObjectWith<M>, t: number, c: number): (vertex: number) => Vec3;
  /** Vertex → normal at world time t on the world's axes, not normalized. */
  vertexNormals(object: ObjectWith<M>, t: number): (vertex: number) => Vec3;
  /** Bounding sphere at `motion.pose`, or at the first sample; of a deforming object with its greatest radius over all samples. */
  startSphere(object: ObjectWith<M>): BoundingSphere;
}

const sphereAt = (pose: Pose, object: SceneObject): BoundingSphere => {
  const { center, radius } = objectBoundingSphere(object);
  return { center: applyPose(pose, center), radius };
};

type WithPose = SceneObject & { readonly motion: { readonly pose: Pose } };

/** Common to kinds with constant orientation. */
const POSED = {
  keepsShape: true,
  mapsToMesh: true,
  vertexPlaces:
    (object: WithPose) =>
    (i: number): Vec3 =>
      rotate(object.motion.pose.orientation, objectPoint(object, i)),
  vertexNormals:
    (object: WithPose) =>
    (i: number): Vec3 =>
      rotate(object.motion.pose.orientation, objectNormal(object, i)),
  startSphere: (object: WithPose): BoundingSphere => sphereAt(object.motion.pose, object),
};

const isAuthoredInWorld = ({ authoredIn }: SceneObject): boolean => authoredIn === 'world';

/** Vectors of the mesh with the orientation at t, interpolated linearly between samples, as vertices are. */
function turned({ times, poses }: SampledMotion, vectors: Float32Array, t: number): (vertex: number) => Vec3 {
  const { before, after, s } = pieceAt(times, t);
  const [a, b] = [samplePose(poses, before).orientation, samplePose(poses, after).orientation];
  return (i) => lerp(rotate(a, pointAt(vectors, i)), rotate(b, pointAt(vectors, i)), s);
}

const inertial = (
  object: SceneObject,
  frame: Pick<UniformMotion, 'pose' | 'velocity'>,
  { index, tree, solid, c }: TracerInputs,
): ObjectIntersector =>
  solid
    ? new RigidQuadricIntersector(index, object, frame, solid, c)
    : new RigidIntersector(index, object, frame, tree(), c);

const MOTION_TRACERS: { readonly [K in Motion['kind']]: MotionTracer<Extract<Motion, { readonly kind: K }>> } = {
  static: {
    ...POSED,
    createIntersector: (object, inputs) => inertial(object, { pose: object.motion.pose, velocity: ZERO }, inputs),
    isAuthoredMoving: () => false,
  },
  uniform: {
    ...POSED,
    createIntersector: (object, inputs) => inertial(object, object.motion, inputs),
    isAuthoredMoving: isAuthoredInWorld,
  },
  hyperbolic: {
    ...POSED,
    mapsToMesh: false,
    createIntersector: (object, { index, tree, solid, c }) =>
      solid
        ? new HyperbolicQuadricIntersector(index, object, solid, c)
        : new HyperbolicRayIntersector(index, object, tree(), c),
    isAuthoredMoving: isAuthoredInWorld,
  },
  sampled: {
    keepsShape: true,
    mapsToMesh: false,
    createIntersector: (object, { index, tree, solid, c }) =>
      solid
        ? new SampledQuadricIntersector(index, object, solid, c)
        : new SampledPosesRayIntersector(index, object, tree(), c),
    isAuthoredMoving: isAuthoredInWorld,
    vertexPlaces: ({ mesh, motion }, t) => turned(motion, mesh.positions, t),
    vertexNormals: ({ mesh, motion }, t) => turned(motion, mesh.normals, t),
    startSphere: (object) => sphereAt(samplePose(object.motion.poses, 0), object),
  },
  'sampled-points': {
    keepsShape: false,
    mapsToMesh: false,
    createIntersector: (object, { index, c, store }) =>
      new SampledPointsRayIntersector(
        index,
        object,
        c,
        new SampledShapes(object.mesh, new PointShapes(object, c), store),
      ),
    isAuthoredMoving: () => true,
    vertexPlaces: ({ motion }, t, c) => deformedPoints(motion, t, c),
    vertexNormals: ({ mesh, motion }, t) => {
      const { before, after, s } = pieceAt(motion.times, t);
      const [a, b] = [normalsAt(motion, before), normalsAt(motion, after)];
      if (!a || !b) return (i) => pointAt(mesh.normals, i);
      return (i) => lerp(pointAt(a, i), pointAt(b, i), s);
    },
    startSphere: ({ motion }) => {
      const spheres = Array.from(motion.times, (_, k) => sampleBoundingSphere(motion, k));
      const radius = Math.max(...spheres.map((sphere) => sphere.radius));
      return { center: add(motion.origin, spheres[0].center), radius };
    },
  },
};

/** The reference renderer's functions for a motion. */
export const motionTracer = (motion: Motion): MotionTracer<Motion> => MOTION_TRACERS[motion.kind];
