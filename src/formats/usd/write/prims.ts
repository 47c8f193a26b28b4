import { IDENTITY } from '../../../math/mat3.ts';
import { fromParts } from '../../../math/mat4.ts';
import { ZERO } from '../../../math/vec3.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import type { RestShape } from '../../../scene/streaming/blendedPoints.ts';
import { normalsAt, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Mesh, Motion, SceneCamera, SceneObject } from '../../../scene/types.ts';
import {
  attribute,
  custom,
  PER_VERTEX,
  type PrimContent,
  type Properties,
  relationship,
  sampled,
  schemas,
  uniform,
} from '../layer/specs.ts';
import { bool, float, floatTuples, ints, LazyTuples, token } from '../layer/values.ts';
import { boxCorners } from '../schema/geometry/pointSampling.ts';
import { lifeProperties } from './lives.ts';
import { slowlightMotion, transformOf, type WriteContext, withMap } from './motions.ts';

/** What a mesh needs of the rest of the scene. */
export interface MeshSurroundings {
  /** The path of a material, by its place in the scene. */
  materialOf(index: number): string;
  /** A free name for a prim within the mesh's. */
  innerName(wanted: string): string;
  /** How a mesh is written that follows joints; undefined for all others. */
  formOf(object: SceneObject, placement: WriteContext): MeshForm | undefined;
}

/** What a mesh has instead of points at all times. */
export interface MeshForm {
  /** Triangles as the front of the shape at rest has them. */
  readonly indices: Uint32Array;
  /** The shape at rest, in the axes of the prim. */
  readonly rest: RestShape;
  readonly transform: Properties;
  /** What says how it bends. */
  readonly bindings?: Properties;
  readonly schemas?: readonly string[];
  readonly inner?: ReadonlyMap<string, PrimContent>;
}

export function meshContent(
  object: SceneObject,
  placement: WriteContext,
  { materialOf, innerName, formOf }: MeshSurroundings,
): PrimContent {
  const { mesh, motion, stretch = IDENTITY } = object;
  const { groups } = mesh;
  const form = formOf(object, placement);
  const { indices } = form ?? mesh;
  const single = groups.length === 1 ? [relationship('material:binding', materialOf(groups[0].material))] : [];
  const subsets = groups.length > 1 ? groups.map((_, i) => subsetContent(mesh, i, materialOf)) : [];
  return {
    type: 'Mesh',
    metadata: schemas('MaterialBindingAPI', ...(form?.schemas ?? [])),
    properties: [
      uniform('bool', 'doubleSided', bool(mesh.doubleSided)),
      ...(form ? restProperties(form.rest) : pointProperties(mesh, motion, placement)),
      ...faceProperties(indices),
      ...single,
      ...(mesh.colors ? [perVertex('color3f[]', 'primvars:displayColor', mesh.colors)] : []),
      perVertex('texCoord2f[]', 'primvars:st', mesh.uvs),
      ...(form?.bindings ?? []),
      ...authoringProperties(object),
      ...slowlightMotion(motion, placement),
      uniform('token', 'subdivisionScheme', token('none')),
      ...lifeProperties(placement),
      ...(form?.transform ?? withMap(transformOf(motion, placement), fromParts(stretch, ZERO), placement)),
    ],
    inner: new Map([...subsets.map((content, i) => [innerName(`Part${i}`), content] as const), ...(form?.inner ?? [])]),
  };
}

/** By the mesh's indices and positions, so that objects with one mesh share what is written of it. */
const FACES = new WeakMap<Uint32Array, Properties>();
const POINTS = new WeakMap<Float32Array, { readonly metersPerUnit: number; readonly points: Float32Array }>();

function faceProperties(indices: Uint32Array): Properties {
  const known = FACES.get(indices) ?? [
    attribute('int[]', 'faceVertexCounts', ints(new Int32Array(indices.length / 3).fill(3))),
    attribute('int[]', 'faceVertexIndices', ints(new Int32Array(indices))),
  ];
  FACES.set(indices, known);
  return known;
}

function unitPoints(positions: Float32Array, metersPerUnit: number): Float32Array {
  const known = POINTS.get(positions);
  if (known?.metersPerUnit === metersPerUnit) return known.points;
  const points = scaledPoints(positions, metersPerUnit);
  POINTS.set(positions, { metersPerUnit, points });
  return points;
}

const perVertex = (typeName: string, name: string, values: Float32Array) =>
  attribute(typeName, name, floatTuples(typeName.includes('2') ? 'float2' : 'float3', values), {
    metadata: PER_VERTEX,
  });

function subsetContent(mesh: Mesh, i: number, materialOf: (index: number) => string): PrimContent {
  const { start, count, material } = mesh.groups[i];
  return {
    type: 'GeomSubset',
    metadata: schemas('MaterialBindingAPI'),
    properties: [
      uniform('token', 'elementType', token('face')),
      uniform('token', 'familyName', token('materialBind')),
      attribute('int[]', 'indices', ints(Int32Array.from({ length: count / 3 }, (_, k) => start / 3 + k))),
      relationship('material:binding', materialOf(material)),
    ],
  };
}

/** Vectors [m] in units of the stage. */
export function scaledPoints(values: Float32Array, metersPerUnit: number): Float32Array {
  const scale = 1 / metersPerUnit;
  return scale === 1 ? values : values.map((x) => x * scale);
}

/** The corners of the box of some points [m], in units of the stage. */
export function extentOf(values: Float32Array, metersPerUnit: number): Float32Array {
  const corners = boxCorners(values);
  const scale = 1 / metersPerUnit;
  return Float32Array.from([...corners[0], ...corners.at(-1)!], (x) => x * scale);
}

/** `positions`: in units of the prim. */
const restProperties = ({ positions, normals }: RestShape): Properties => [
  attribute('float3[]', 'extent', { type: 'float3[]', data: extentOf(positions, 1) }),
  perVertex('normal3f[]', 'normals', normals),
  attribute('point3f[]', 'points', { type: 'float3[]', data: positions }),
];

function pointProperties(mesh: Mesh, motion: Motion, { metersPerUnit, codesPerSecond }: WriteContext): Properties {
  const scaled = (values: Float32Array): Float32Array => scaledPoints(values, metersPerUnit);
  const samples = pointSamples(motion);
  if (!samples) return restProperties({ positions: unitPoints(mesh.positions, metersPerUnit), normals: mesh.normals });
  const codes = samples.times.map((t) => t * codesPerSecond);
  const moving = (typeName: string, name: string, at: (i: number) => Float32Array, metadata?: typeof PER_VERTEX) =>
    sampled(typeName, name, codes, (i) => new LazyTuples(() => at(i)), metadata);
  const { velocities } = samples;
  return [
    moving('float3[]', 'extent', (i) => extentOf(pointsAt(samples, i), metersPerUnit)),
    normalsAt(samples, 0)
      ? moving('normal3f[]', 'normals', (i) => normalsAt(samples, i)!, PER_VERTEX)
      : perVertex('normal3f[]', 'normals', mesh.normals),
    moving('point3f[]', 'points', (i) => scaled(pointsAt(samples, i))),
    ...(velocities ? [moving('vector3f[]', 'velocities', (i) => scaled(velocities[i]))] : []),
  ];
}

/** The frame in which its shape is given. */
export const authoringProperties = ({ authoredIn }: Pick<SceneObject, 'authoredIn'>): Properties =>
  authoredIn === 'rest' ? [custom('token', 'slowlight:authoredIn', token('rest'))] : [];

/** [tenths of a stage unit], as USD's fallback. */
const FOCAL_LENGTH = 50;
const ASPECT = 1.5;

export function cameraContent(camera: SceneCamera, placement: WriteContext): PrimContent {
  const aperture = 2 * FOCAL_LENGTH * Math.tan(camera.fovY / 2);
  return {
    type: 'Camera',
    properties: [
      attribute('float', 'focalLength', float(FOCAL_LENGTH)),
      attribute('float', 'horizontalAperture', float(aperture * ASPECT)),
      attribute('float', 'verticalAperture', float(aperture)),
      ...transformOf(camera.motion, placement),
    ],
  };
}
