import type { Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { positionAt, type WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { type BoundingBox, boundingBox, meshBoundingSphere } from '../../bounds/bounds.ts';
import { SupportMap } from '../../bounds/supportMap.ts';
import { pointAt } from '../../mesh/polygons.ts';
import type { Mesh, Motion, Pose, RigidMotion, SceneObject } from '../../types.ts';
import { composePoses } from './changes.ts';
import type { ObjectWith } from './motionKind.ts';

// Shared by kinds of rigid motion.

type PosedMotion = Extract<RigidMotion, { readonly pose: Pose }>;

/** Members of a kind that has one pose, and no samples. */
export const POSED = {
  deforms: false,
  fixedOrientation: ({ pose }: PosedMotion) => pose.orientation,
  sampleTimes: () => undefined,
  sampleCount: () => 0,
  poseSamples: () => undefined,
  pointSamples: () => undefined,
  keepsFastest: () => false,
  restToWorld: (object: SceneObject): SceneObject => object,
  compose: <M extends PosedMotion>(frame: M, pose: Pose): M => ({ ...frame, pose: composePoses(frame.pose, pose) }),
};

export const poseNumbers = ({ pose }: PosedMotion): readonly number[] => [...pose.position, ...pose.orientation];

/** Describes the first number that is not finite in a pose and the vector that determines its motion. */
export function nonFinitePoseText(motion: PosedMotion, vector: Vec3): Message | undefined {
  const bad = [...poseNumbers(motion), ...vector].find((x) => !Number.isFinite(x));
  return bad === undefined ? undefined : msg`its pose or motion has ${bad} in it`;
}

/** Vertex → place at t, from its own world line. */
export const placeByWorldLine =
  <M extends Motion>(vertexWorldLine: (object: ObjectWith<M>, vertex: number, c: number) => WorldLine) =>
  (object: ObjectWith<M>, t: number, c: number) =>
  (vertex: number): Vec3 =>
    positionAt(vertexWorldLine(object, vertex, c), t, c);

/** All vertices of a mesh, 3 numbers each. */
export function placeVertices({ positions }: Pick<Mesh, 'positions'>, at: (vertex: number) => Vec3): Float64Array {
  const out = new Float64Array(positions.length);
  for (let i = 0; 3 * i < out.length; i++) out.set(at(i), 3 * i);
  return out;
}

type Placer<M extends Motion> = (object: ObjectWith<M>, t: number, c: number) => (vertex: number) => Vec3;

/** The bounding box of all vertices. */
export const boundsOfVertices =
  <M extends Motion>(place: Placer<M>) =>
  (object: ObjectWith<M>, t: number, c: number): BoundingBox | undefined =>
    boundingBox(placeVertices(object.mesh, place(object, t, c)));

/** The origin, and the tips of the axes. */
const AXES = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);

/** By positions, so that objects with the same mesh share them. */
const SUPPORT_MAPS = new WeakMap<Float32Array, SupportMap>();

/** The same for motions that map the object affinely to the world, from the mesh's extreme points. */
export const affineBounds =
  <M extends Motion>(place: Placer<M>) =>
  (object: ObjectWith<M>, t: number, c: number): BoundingBox | undefined => {
    const { positions } = object.mesh;
    if (positions.length === 0 || !Number.isFinite(meshBoundingSphere(object.mesh).radius))
      return boundsOfVertices(place)(object, t, c);
    const axes = { ...object, mesh: { ...object.mesh, positions: AXES } };
    const placed = placeVertices(axes.mesh, place(axes, t, c));
    const [o, x, y, z] = [0, 1, 2, 3].map((i) => pointAt(placed, i));
    const extremes = SUPPORT_MAPS.get(positions) ?? new SupportMap(positions);
    SUPPORT_MAPS.set(positions, extremes);
    const reach = (k: number, sign: number): number =>
      o[k] + sign * extremes.support([sign * (x[k] - o[k]), sign * (y[k] - o[k]), sign * (z[k] - o[k])]);
    return { min: [reach(0, -1), reach(1, -1), reach(2, -1)], max: [reach(0, 1), reach(1, 1), reach(2, 1)] };
  };
