import { determinant } from '../../../math/mat3.ts';
import { decomposeRigid, IDENTITY, type Mat4, multiply, transpose } from '../../../math/mat4.ts';
import { length } from '../../../math/vec3.ts';
import { transformMesh } from '../../../scene/mesh/meshOps.ts';
import { type Axis, capsule, cone, cylinder, type RoundOptions, sphere } from '../../../scene/mesh/primitives.ts';
import type { Mesh, Quadric, QuadricShape, SceneObject } from '../../../scene/types.ts';
import {
  attribute,
  custom,
  type PrimContent,
  type Properties,
  relationship,
  schemas,
  uniform,
} from '../layer/specs.ts';
import { bool, double, int, token } from '../layer/values.ts';
import { DIVISIONS } from '../schema/geometry/gprims.ts';
import { lifeProperties } from './lives.ts';
import { slowlightMotion, transformOf, type WriteContext, withMap } from './motions.ts';
import { authoringProperties, type MeshSurroundings } from './prims.ts';

/** How the primitives are made, and what USD has of them. */
interface RoundGprim<S extends QuadricShape> {
  readonly type: string;
  make(shape: S, division: RoundOptions & { readonly rings: number }): Mesh;
  /** Half of it along its axis, by its radius and height. */
  halfLength(shape: S): number;
}

const GPRIMS: { readonly [K in QuadricShape['kind']]: RoundGprim<Extract<QuadricShape, { readonly kind: K }>> } = {
  sphere: {
    type: 'Sphere',
    make: ({ radius }, division) => sphere(radius, division),
    halfLength: ({ radius }) => radius,
  },
  cylinder: {
    type: 'Cylinder',
    make: ({ radius, height }, division) => cylinder(radius, height, division),
    halfLength: ({ height }) => height / 2,
  },
  cone: {
    type: 'Cone',
    make: ({ radius, height }, division) => cone(radius, height, division),
    halfLength: ({ height }) => height / 2,
  },
  capsule: {
    type: 'Capsule',
    make: ({ radius, height }, division) => capsule(radius, height, division),
    halfLength: ({ radius, height }) => radius + height / 2,
  },
};

const gprimOf = (shape: QuadricShape): RoundGprim<QuadricShape> => GPRIMS[shape.kind];

/** A round solid as a prim of UsdGeom; undefined if what is read of that would be another object. */
export function gprimContent(
  object: SceneObject,
  placement: WriteContext,
  { materialOf }: MeshSurroundings,
): PrimContent | undefined {
  const { mesh, motion } = object;
  const { quadric, groups } = mesh;
  if (!quadric || groups.length !== 1 || mesh.colors || motion.kind === 'sampled-points') return undefined;
  if (!isDivisible(quadric) || !isMadeOf(quadric, mesh)) return undefined;
  const { axis, map } = axisAndMap(quadric);
  // What turns and moves a solid in its own frame is read as part of its pose, which is the same only for things at rest.
  if (motion.kind !== 'static' && !isStretch(map)) return undefined;
  const { type } = gprimOf(quadric.shape);
  return {
    type,
    metadata: schemas('MaterialBindingAPI'),
    properties: [
      ...shapeProperties(quadric, axis, placement),
      uniform('bool', 'doubleSided', bool(mesh.doubleSided)),
      relationship('material:binding', materialOf(groups[0].material)),
      ...authoringProperties(object),
      ...slowlightMotion(motion, placement),
      ...lifeProperties(placement),
      ...withMap(transformOf(motion, placement), map, placement),
    ],
  };
}

function shapeProperties({ shape, segments, rings }: Quadric, axis: Axis, { metersPerUnit }: WriteContext): Properties {
  const size = (name: string, metres: number) => attribute('double', name, double(metres / metersPerUnit));
  const half = gprimOf(shape).halfLength(shape);
  const corner = (['X', 'Y', 'Z'] as const).map((k) => (k === axis ? half : shape.radius) / metersPerUnit);
  const extent = Float32Array.from([...corner.map((x) => -x), ...corner]);
  return [
    attribute('float3[]', 'extent', { type: 'float3[]', data: extent }),
    size('radius', shape.radius),
    ...('height' in shape ? [size('height', shape.height)] : []),
    // USD's spheres have no axis; texture coordinates run around it.
    ...(shape.kind !== 'sphere' ? [uniform('token', 'axis', token(axis))] : []),
    ...(shape.kind === 'sphere' && axis !== 'Z' ? [custom('token', 'slowlight:axis', token(axis))] : []),
    ...(segments === SEGMENTS ? [] : [custom('int', 'slowlight:segments', int(segments))]),
    ...(rings === usualRings(shape, segments) ? [] : [custom('int', 'slowlight:rings', int(rings))]),
  ];
}

/** What the primitives have where nothing is said. */
const SEGMENTS = 64;
const usualRings = ({ kind }: QuadricShape, segments: number): number =>
  kind === 'sphere' ? Math.round(segments / 2) : kind === 'capsule' ? Math.round(segments / 4) : 1;

/** Whether what is written of its division is read. */
const isDivisible = ({ shape, segments, rings }: Quadric): boolean => {
  const isWithin = ([least, most]: readonly [number, number], n: number): boolean => n >= least && n <= most;
  return (
    isWithin(DIVISIONS.segments, segments) &&
    (rings === usualRings(shape, segments) || isWithin(DIVISIONS.rings, rings))
  );
};

/** Greatest difference of points relative to the mesh's size, of normals and of texture coordinates: f32, rounded a few times. */
const TOLERANCE = { points: 2e-6, normals: 1e-5, uvs: 1e-6 };

/** Whether a mesh has just the points, normals, texture coordinates and faces of its solid as a primitive. */
function isMadeOf({ shape, toMesh, segments, rings }: Quadric, mesh: Mesh): boolean {
  const made = transformMesh(gprimOf(shape).make(shape, { segments, rings }), toMesh);
  const size = made.positions.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  return (
    areNear(mesh.positions, made.positions, TOLERANCE.points * size) &&
    areNear(mesh.normals, made.normals, TOLERANCE.normals) &&
    areNear(mesh.uvs, made.uvs, TOLERANCE.uvs) &&
    areNear(mesh.indices, made.indices, 0)
  );
}

const areNear = (a: Float32Array | Uint32Array, b: Float32Array | Uint32Array, tolerance: number): boolean =>
  a.length === b.length && a.every((x, i) => Math.abs(x - b[i]) <= tolerance);

/** From axes with the solid's axis along z to those with it along another, as the primitives turn. */
const FROM_Z: readonly (readonly [Axis, Mat4])[] = [
  ['Z', IDENTITY],
  ['Y', [0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1]],
  ['X', [0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1]],
];

/** The axis along which as little as possible is left to be done by a transform, and that transform. */
function axisAndMap({ toMesh }: Quadric): { readonly axis: Axis; readonly map: Mat4 } {
  const ways = FROM_Z.map(([axis, turn]) => ({ axis, map: multiply(toMesh, transpose(turn)) }));
  return ways.find(({ map }) => isStretch(map)) ?? ways[0];
}

/** Whether a map has only a scale and a shear, without a turn, a mirror or a way: what is read as the mesh's shape. */
const isStretch = (map: Mat4): boolean => {
  const { pose, stretch } = decomposeRigid(map);
  const [x, y, z, w] = pose.orientation;
  return length([x, y, z]) <= 1e-9 * Math.abs(w) && length(pose.position) === 0 && determinant(stretch) > 0;
};
