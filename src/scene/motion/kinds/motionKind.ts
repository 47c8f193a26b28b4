import type { Quat } from '../../../math/quat.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import type { Message } from '../../../messages/message.ts';
import type { WorldLine } from '../../../physics/worldLines/worldLine.ts';
import type { BoundingBox } from '../../bounds/bounds.ts';
import type { Support } from '../../bounds/supportMap.ts';
import type {
  Diagnostic,
  Motion,
  Pose,
  RigidMotion,
  SampledMotion,
  SampledPointsMotion,
  SceneObject,
} from '../../types.ts';
import type { FlightPath, LinearTimeMap, SimilarityTransform } from './changes.ts';

/** An object with a motion of one kind. */
export type ObjectWith<M extends Motion> = SceneObject & { readonly motion: M };

/** A greatest speed, with its vertex and time. */
export interface FastestVertex {
  /** [m/s] */
  readonly speed: number;
  /** Its index in the mesh. */
  readonly vertex: number;
  /** First world time at which it has this speed [s]. */
  readonly from: number;
  /** Last world time at which it has this speed [s]. */
  readonly to: number;
}

export const REST: FastestVertex = {
  speed: 0,
  vertex: 0,
  from: Number.NEGATIVE_INFINITY,
  to: Number.POSITIVE_INFINITY,
};

/**
 * All that the scene needs to know of a kind of motion (docs/adr/0022-motion-kinds.md); render, reference and formats have records of their own. Times are
 * world times [s], lengths [m], c [m/s].
 */
export interface MotionKind<M extends Motion> {
  /** Always at rest. */
  readonly isStatic: boolean;
  /** The mesh is world-oriented and deforms with the samples: it has no rigid frame. */
  readonly deforms: boolean;
  /**
   * Its speed approaches c for any c, so that greatest speeds depend on c; and bodies authored at rest have a horizon.
   */
  readonly approachesC: boolean;

  /** The pose, if it is always at rest. */
  restingPose(motion: M): Pose | undefined;
  /** The orientation of its frame, if that is constant. */
  fixedOrientation(motion: M): Quat | undefined;
  /** Strictly increasing times between which it is straight or cubic. */
  sampleTimes(motion: M): Float64Array | undefined;
  /** Number of its samples, even if that differs from the number of its times. */
  sampleCount(motion: M): number;
  /** The motion itself, if it is given by rigid poses. */
  poseSamples(motion: M): SampledMotion | undefined;
  /** The motion itself, if it is given by places of every vertex. */
  pointSamples(motion: M): SampledPointsMotion | undefined;
  /** All its numbers except those of every vertex, to find those that are not finite. */
  numbers(motion: M): readonly ArrayLike<number>[];

  /** The object's frame at t. Between samples the position moves straight and the orientation turns uniformly. */
  poseAt(motion: M, t: number, c: number): Pose;
  vertexWorldLine(object: ObjectWith<M>, vertex: number, c: number): WorldLine;
  /** Vertex → place at t; what all vertices share is computed once. */
  vertexPlacer(object: ObjectWith<M>, t: number, c: number): (vertex: number) => Vec3;
  /** Bounding box at t; with streamed samples interpolated between the boxes of the samples. */
  bounds(object: ObjectWith<M>, t: number, c: number): BoundingBox | undefined;
  /** How far it reaches at t; with streamed samples, what the box reaches. */
  support(object: ObjectWith<M>, t: number, c: number): Support;
  /** As `fastestVertex` of motion.ts. */
  fastestVertex(object: ObjectWith<M>, c: number, range: readonly [number, number], atLeast: number): FastestVertex;
  /** Whether its fastest vertex is independent of c, and expensive to find, so that it is cached. */
  keepsFastest(motion: M): boolean;
  /** The object authored in the world frame, if the kind can only be drawn so; else unchanged. */
  restToWorld(object: ObjectWith<M>, c: number): SceneObject;

  /** Describes a number of it that is not finite, for a message; undefined if there is none. */
  nonFiniteText(motion: M): Message | undefined;
  /** Findings about its speed compared with c. */
  validateSpeed(object: ObjectWith<M>, c: number): Diagnostic[];

  retime(motion: M, map: LinearTimeMap): M;
  transform(motion: M, by: SimilarityTransform): M;
  fly(motion: M, path: FlightPath): Motion;
}

/** A kind of motion of one frame: of rigid objects, lights and cameras. */
export interface RigidMotionKind<M extends RigidMotion> extends MotionKind<M> {
  /** The world line of the origin of the object's frame. */
  originWorldLine(motion: M): WorldLine;
  /** The motion of something with a fixed pose in the frame. */
  compose(frame: M, pose: Pose): M;
  fly(motion: M, path: FlightPath): RigidMotion;
}
