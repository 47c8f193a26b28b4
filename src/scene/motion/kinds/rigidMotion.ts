import { IDENTITY, transform, transpose } from '../../../math/mat3.ts';
import { dot, sub, type Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { positionAt, type WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { type BoundingBox, boundingBox, finiteBox, meshBoundingSphere } from '../../bounds/bounds.ts';
import { type Support, SupportMap } from '../../bounds/supportMap.ts';
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

/** Those without a number that is not finite. */
const finitePoints = (points: Float64Array): Float64Array =>
  points.filter((_, i) => pointAt(points, Math.floor(i / 3)).every(Number.isFinite));

/** The bounding box of all vertices, and how far they reach. */
export const ofVertices = <M extends Motion>(place: Placer<M>) => ({
  bounds: (object: ObjectWith<M>, t: number, c: number): BoundingBox | undefined =>
    boundingBox(placeVertices(object.mesh, place(object, t, c))),
  support: (object: ObjectWith<M>, t: number, c: number): Support => {
    const placed = placeVertices(object.mesh, place(object, t, c));
    const points = finiteBox(placed) ? placed : finitePoints(placed);
    const extremes = new SupportMap(points);
    return (d) => extremes.support(d);
  },
});

/** The origin, and the tips of the axes. */
const AXES = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);

/** By positions, so that objects with the same mesh share them. */
const SUPPORT_MAPS = new WeakMap<Float32Array, SupportMap>();

/** The same for motions that map the object affinely to the world, from the mesh's extreme points. */
export const ofAffineMap = <M extends Motion>(place: Placer<M>) => {
  const vertices = ofVertices(place);
  const isSimple = ({ mesh }: ObjectWith<M>): boolean =>
    mesh.positions.length > 0 && Number.isFinite(meshBoundingSphere(mesh).radius);
  const support = (object: ObjectWith<M>, t: number, c: number): Support => {
    if (!isSimple(object)) return vertices.support(object, t, c);
    const { positions } = object.mesh;
    const { stretch = IDENTITY, ...rest } = object;
    const axes = { ...rest, mesh: { ...object.mesh, positions: AXES } } as ObjectWith<M>;
    const placed = placeVertices(axes.mesh, place(axes, t, c));
    const [o, x, y, z] = [0, 1, 2, 3].map((i) => pointAt(placed, i));
    const [ax, ay, az] = [sub(x, o), sub(y, o), sub(z, o)];
    const extremes = SUPPORT_MAPS.get(positions) ?? new SupportMap(positions);
    SUPPORT_MAPS.set(positions, extremes);
    const inMesh = transpose(stretch);
    return (d) => dot(d, o) + extremes.support(transform(inMesh, [dot(d, ax), dot(d, ay), dot(d, az)]));
  };
  return {
    support,
    bounds: (object: ObjectWith<M>, t: number, c: number): BoundingBox | undefined => {
      if (!isSimple(object)) return vertices.bounds(object, t, c);
      const reach = support(object, t, c);
      return {
        min: [-reach([-1, 0, 0]), -reach([0, -1, 0]), -reach([0, 0, -1])],
        max: [reach([1, 0, 0]), reach([0, 1, 0]), reach([0, 0, 1])],
      };
    },
  };
};
