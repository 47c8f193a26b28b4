import type { Vec3 } from '../../math/vec3.ts';
import { positionAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import type { Motion, Pose, RigidMotion, SampledMotion, SampledPointsMotion, SceneObject } from '../types.ts';
import type { FastestVertex } from './kinds/motionKind.ts';
import { placeVertices } from './kinds/rigidMotion.ts';
import { motionFacts, motionKind } from './motions.ts';

// Functions of any motion, by the record of its kind; documented in kinds/motionKind.ts.

type OfKind = Pick<Motion, 'kind'>;

export const isStatic = ({ kind }: OfKind): boolean => motionFacts(kind).isStatic;
export const deforms = ({ kind }: OfKind): boolean => motionFacts(kind).deforms;
export const approachesC = ({ kind }: OfKind): boolean => motionFacts(kind).approachesC;
export const restingPose = (motion: Motion): Pose | undefined => motionKind(motion).restingPose(motion);
export const sampleTimes = (motion: Motion): Float64Array | undefined => motionKind(motion).sampleTimes(motion);
export const poseSamples = (motion: Motion): SampledMotion | undefined => motionKind(motion).poseSamples(motion);
export const pointSamples = (motion: Motion): SampledPointsMotion | undefined =>
  motionKind(motion).pointSamples(motion);

/**
 * The object's frame at world time t [s]; c [m/s].
 * @example
 * poseAt({ kind: 'uniform', pose: IDENTITY_POSE, velocity: [6, 0, 0] }, 2, 10).position; // [12, 0, 0] m
 */
export const poseAt = (motion: Motion, t: number, c: number): Pose => motionKind(motion).poseAt(motion, t, c);

/**
 * The world line of the origin of the object's frame.
 * @example
 * originWorldLine(restingAt([1, 2, 3])); // { kind: 'static', position: [1, 2, 3] }
 */
export const originWorldLine = (motion: RigidMotion): WorldLine => motionKind(motion).originWorldLine(motion);

/**
 * The world line of vertex i. A mesh authored in its rest frame is contracted along its velocity; in hyperbolic motion
 * it is Born rigid, so each vertex has its own acceleration. c [m/s].
 * @example
 * // A rod of 1 m in its own frame, at 0.6 c: half of it is 0.4 m long in the world.
 * const rod = makeObject({
 *   path: '/Rod',
 *   mesh: box([1, 0.1, 0.1]),
 *   motion: { kind: 'uniform', pose: IDENTITY_POSE, velocity: [6, 0, 0] },
 *   authoredIn: 'rest',
 * });
 * const line = vertexWorldLine(rod, 0, 10);
 * line.kind === 'uniform' && Math.abs(line.position[0]); // 0.4 m
 */
export const vertexWorldLine = (object: SceneObject, i: number, c: number): WorldLine =>
  motionKind(object.motion).vertexWorldLine(object, i, c);

/**
 * Vertex i in the world frame at world time t [m].
 * @example
 * const cube = makeObject({ path: '/Cube', mesh: box([2, 2, 2]), motion: restingAt([5, 0, 0]) });
 * Math.abs(vertexPosition(cube, 0, 0, 10)[1]); // 1 m
 */
export const vertexPosition = (object: SceneObject, i: number, t: number, c: number): Vec3 =>
  positionAt(vertexWorldLine(object, i, c), t, c);

/**
 * All vertices in the world frame at world time t, 3 numbers each [m]: as `vertexPosition`, without building world lines.
 * @example
 * const cube = makeObject({ path: '/Cube', mesh: box([2, 2, 2]), motion: restingAt([5, 0, 0]) });
 * boundingBox(vertexPositions(cube, 0, 10)); // { min: [4, -1, -1], max: [6, 1, 1] } m
 */
export const vertexPositions = (object: SceneObject, t: number, c: number): Float64Array =>
  placeVertices(object.mesh, motionKind(object.motion).vertexPlacer(object, t, c));

/**
 * A sampled motion authored in the rest frame, as points of the world: at each sample the body is contracted along its
 * frame's velocity there. c [m/s]. Any other object is returned unchanged.
 */
export const restToWorld = (object: SceneObject, c: number): SceneObject =>
  motionKind(object.motion).restToWorld(object, c);

/**
 * The fastest vertex of an object, exactly: over all vertices and pieces, not only the frame's origin. Hyperbolic
 * motion, which has no greatest speed, is evaluated at the ends of `range` [s]. c [m/s]. Pieces that cannot be faster than
 * `atLeast` [m/s] are skipped; returns `REST` if all are.
 * @example
 * const cube = makeObject({
 *   path: '/Cube',
 *   mesh: box([2, 2, 2]),
 *   motion: { kind: 'uniform', pose: IDENTITY_POSE, velocity: [6, 0, 0] },
 * });
 * fastestVertex(cube, 10).speed; // 6 m/s
 */
export const fastestVertex = (
  object: SceneObject,
  c: number,
  range: readonly [number, number] = [0, 0],
  atLeast = 0,
): FastestVertex => motionKind(object.motion).fastestVertex(object, c, range, atLeast);
