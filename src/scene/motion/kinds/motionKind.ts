import type { Quat } from '../../../math/quat.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import type { WorldLine } from '../../../physics/worldLines/worldLine.ts';
import type { BoundingBox } from '../../bounds/bounds.ts';
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

/** An object whose motion is of a kind. */
export type ObjectWith<M extends Motion> = SceneObject & { readonly motion: M };

/** A greatest speed, and where and when. */
export interface FastestVertex {
  /** [m/s] */
  readonly speed: number;
  readonly vertex: number;
  /** World times between which it goes so fast [s]. */
  readonly from: number;
  readonly to: number;
}

export const REST: FastestVertex = {
  speed: 0,
  vertex: 0,
  from: Number.NEGATIVE_INFINITY,
  to: Number.POSITIVE_INFINITY,
};

/**
 * All that the scene knows of a kind of motion (docs/adr/0022-motion-kinds.md). Records of render, reference and formats have the rest. Times are
 * world times [s], lengths [m], c [m/s].
 */
export interface MotionKind<M extends Motion> {
  /** At rest for ever. */
  readonly isStatic: boolean;
  /** The mesh is world-oriented and turns with the samples: no frame carries it. */
  readonly deforms: boolean;
  /**
   * Its speed approaches c, however large c is, so that greatest speeds are found anew for each c; and bodies that are authored at rest have a horizon.
   */
  readonly approachesC: boolean;

  /** The pose of what rests for ever. */
  restingPose(motion: M): Pose | undefined;
  /** The orientation that its frame always has. */
  fixedOrientation(motion: M): Quat | undefined;
  /** Times between which it is straight or cubic, strictly rising. */
  sampleTimes(motion: M): Float64Array | undefined;
  /** How many samples it has, whatever its times say. */
  sampleCount(motion: M): number;
  /** Rigid poses at times. */
  poseSamples(motion: M): SampledMotion | undefined;
  /** Places of every vertex at times. */
  pointSamples(motion: M): SampledPointsMotion | undefined;
  /** All numbers that say where its frame is, for finding those that are not finite; without those of every vertex. */
  numbers(motion: M): readonly ArrayLike<number>[];

  /** The object's frame at t. Between samples the position goes straight and the orientation turns evenly. */
  poseAt(motion: M, t: number, c: number): Pose;
  vertexWorldLine(object: ObjectWith<M>, vertex: number, c: number): WorldLine;
  /** Vertex → place at t; what the vertices share is worked out once. */
  vertexPlacer(object: ObjectWith<M>, t: number, c: number): (vertex: number) => Vec3;
  /** The box of the object at t; of one whose samples are left in a file between the boxes of its samples. */
  bounds(object: ObjectWith<M>, t: number, c: number): BoundingBox | undefined;
  /** As `fastestVertex` of motion.ts. */
  fastestVertex(object: ObjectWith<M>, c: number, range: readonly [number, number], atLeast: number): FastestVertex;
  /** Whether its fastest vertex is the same for every c, and dear to find. */
  keepsFastest(motion: M): boolean;
  /** The object as shapes of the world, where the kind can only be drawn so; else as it is. */
  restToWorld(object: ObjectWith<M>, c: number): SceneObject;

  /** What is not a finite number in it, for a message. */
  nonFiniteText(motion: M): string | undefined;
  /** What its speed makes impossible or changes at c. */
  validateSpeed(object: ObjectWith<M>, c: number): Diagnostic[];

  retime(motion: M, map: LinearTimeMap): M;
  transform(motion: M, by: SimilarityTransform): M;
  fly(motion: M, path: FlightPath): Motion;
}

/** The same of one frame: of rigid objects, lights and cameras. */
export interface RigidMotionKind<M extends RigidMotion> extends MotionKind<M> {
  /** The world line of the origin of the object's frame. */
  originWorldLine(motion: M): WorldLine;
  /** The motion of what stands at a pose in the frame. */
  compose(frame: M, pose: Pose): M;
  fly(motion: M, path: FlightPath): RigidMotion;
}
