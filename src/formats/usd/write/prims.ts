import type { Vec3 } from '../../../math/vec3.ts';
import { normalsAt, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type {
  Mesh,
  Motion,
  Pose,
  SampledMotion,
  SampledPointsMotion,
  SceneCamera,
  SceneObject,
} from '../../../scene/types.ts';
import { boxCorners } from '../schema/geometry/pointSampling.ts';
import type { PrimContent } from './primTree.ts';
import { block, double, doubles, float, floatTuples, type Lines, timeSamples, withMetadata } from './usdaText.ts';

/** How a prim is written. */
export interface WriteContext {
  readonly metersPerUnit: number;
  readonly codesPerSecond: number;
  /** It is inside a prim that has a transform of its own. */
  readonly nested: boolean;
}

/** `materialOf`: the path of a material, by its place in the scene. */
export function meshContent(
  object: SceneObject,
  placement: WriteContext,
  materialOf: (index: number) => string,
): PrimContent {
  const { mesh, motion } = object;
  const { groups } = mesh;
  const single = groups.length === 1 ? [`rel material:binding = <${materialOf(groups[0].material)}>`] : [];
  return {
    type: 'Mesh',
    metadata: ['prepend apiSchemas = ["MaterialBindingAPI"]'],
    properties: [
      `uniform bool doubleSided = ${mesh.doubleSided ? 1 : 0}`,
      ...pointLines(mesh, motion, placement),
      `int[] faceVertexCounts = [${new Array(mesh.indices.length / 3).fill('3').join(', ')}]`,
      `int[] faceVertexIndices = [${mesh.indices.join(', ')}]`,
      ...single,
      ...colorLines(mesh),
      ...withMetadata(`texCoord2f[] primvars:st = ${floatTuples(mesh.uvs, 2)}`, 'interpolation = "vertex"'),
      ...slowlightLines(object, placement),
      'uniform token subdivisionScheme = "none"',
      ...motionLines(motion, placement),
    ],
    inner: groups.length > 1 ? groups.map((_, i) => subsetLines(mesh, i, materialOf)) : [],
  };
}

function subsetLines(mesh: Mesh, i: number, materialOf: (index: number) => string): Lines {
  const { start, count, material } = mesh.groups[i];
  const faces = Array.from({ length: count / 3 }, (_, k) => start / 3 + k);
  return block(
    `def GeomSubset "Part${i}"`,
    [
      'uniform token elementType = "face"',
      'uniform token familyName = "materialBind"',
      `int[] indices = [${faces.join(', ')}]`,
      `rel material:binding = <${materialOf(material)}>`,
    ],
    ['prepend apiSchemas = ["MaterialBindingAPI"]'],
  );
}

const colorLines = ({ colors }: Mesh): Lines =>
  colors ? withMetadata(`color3f[] primvars:displayColor = ${floatTuples(colors, 3)}`, 'interpolation = "vertex"') : [];

function pointLines(mesh: Mesh, motion: Motion, placement: WriteContext): Lines {
  const scale = 1 / placement.metersPerUnit;
  const points = (values: Float32Array): string => floatTuples(values, 3, scale);
  const extent = (values: Float32Array): string => {
    const corners = boxCorners(values);
    return floatTuples([...corners[0], ...corners.at(-1)!], 3, scale);
  };
  const still = motion.kind !== 'sampled-points' || !normalsAt(motion, 0);
  const normals = still ? `normal3f[] normals = ${floatTuples(mesh.normals, 3)}` : 'normal3f[] normals';
  const normalLines = withMetadata(normals, 'interpolation = "vertex"');
  if (motion.kind !== 'sampled-points')
    return [
      `float3[] extent = ${extent(mesh.positions)}`,
      ...normalLines,
      `point3f[] points = ${points(mesh.positions)}`,
    ];
  const codes = motion.times.map((t) => t * placement.codesPerSecond);
  return [
    ...timeSamples('float3[] extent', codes, (i) => extent(pointsAt(motion, i))),
    ...normalLines,
    ...(still ? [] : timeSamples('normal3f[] normals', codes, (i) => floatTuples(normalsAt(motion, i)!, 3))),
    ...timeSamples('point3f[] points', codes, (i) => points(pointsAt(motion, i))),
    ...(motion.velocities ? timeSamples('vector3f[] velocities', codes, (i) => points(motion.velocities![i])) : []),
  ];
}

type WithSlowlightAttributes = Pick<SceneObject, 'motion' | 'lifetime'> & Partial<Pick<SceneObject, 'authoredIn'>>;

/** Our own attributes: what closed-form motion, lifetime and frame of authoring an object or a light has. */
export function slowlightLines(
  { motion, lifetime, authoredIn }: WithSlowlightAttributes,
  placement: WriteContext,
): Lines {
  const perUnit = (v: Vec3): string => doubles(v.map((x) => x / placement.metersPerUnit));
  return [
    ...(authoredIn === 'rest' ? ['custom token slowlight:authoredIn = "rest"'] : []),
    ...(Number.isFinite(lifetime.birth) ? [`custom double slowlight:birth = ${double(lifetime.birth)}`] : []),
    ...(Number.isFinite(lifetime.death) ? [`custom double slowlight:death = ${double(lifetime.death)}`] : []),
    ...(motion.kind === 'uniform' || motion.kind === 'hyperbolic'
      ? [`custom token slowlight:motion = "${motion.kind}"`]
      : []),
    ...(motion.kind === 'hyperbolic'
      ? [
          `custom vector3d slowlight:properAcceleration = ${perUnit(motion.properAcceleration)}`,
          `custom double slowlight:t0 = ${double(motion.t0)}`,
        ]
      : []),
    ...(motion.kind === 'uniform' ? [`custom vector3d slowlight:velocity = ${perUnit(motion.velocity)}`] : []),
  ];
}

/** Poses are the stage's: inside a prim with a transform, that one's does not count. */
function orderLine({ nested }: WriteContext, ...ops: string[]): string {
  const order = nested ? ['!resetXformStack!', ...ops] : ops;
  return `uniform token[] xformOpOrder = [${order.map((op) => `"${op}"`).join(', ')}]`;
}

export function motionLines(motion: Motion, placement: WriteContext): Lines {
  if (motion.kind === 'sampled') return sampledLines(motion, placement);
  if (motion.kind === 'sampled-points') return originLines(motion, placement);
  return poseLines(motion.pose, placement);
}

export function poseLines({ position, orientation }: Pose, placement: WriteContext): Lines {
  return [
    `quatd xformOp:orient = ${quaternionText(orientation)}`,
    `double3 xformOp:translate = ${doubles(position.map((x) => x / placement.metersPerUnit))}`,
    orderLine(placement, 'xformOp:translate', 'xformOp:orient'),
  ];
}

function sampledLines({ times, poses }: SampledMotion, placement: WriteContext): Lines {
  const codes = times.map((t) => t * placement.codesPerSecond);
  const part = (i: number, from: number, to: number): number[] => Array.from(poses.subarray(7 * i + from, 7 * i + to));
  return [
    ...timeSamples('quatd xformOp:orient', codes, (i) => quaternionText(part(i, 3, 7))),
    ...timeSamples('double3 xformOp:translate', codes, (i) =>
      doubles(part(i, 0, 3).map((x) => x / placement.metersPerUnit)),
    ),
    orderLine(placement, 'xformOp:translate', 'xformOp:orient'),
  ];
}

const originLines = ({ origin }: SampledPointsMotion, placement: WriteContext): Lines => [
  `double3 xformOp:translate = ${doubles(origin.map((x) => x / placement.metersPerUnit))}`,
  orderLine(placement, 'xformOp:translate'),
];

const quaternionText = ([x, y, z, w]: readonly number[]): string => doubles([w, x, y, z]);

/** [tenths of a stage unit], as USD's fallback. */
const FOCAL_LENGTH = 50;
const ASPECT = 1.5;

export function cameraContent(camera: SceneCamera, placement: WriteContext): PrimContent {
  const aperture = 2 * FOCAL_LENGTH * Math.tan(camera.fovY / 2);
  return {
    type: 'Camera',
    properties: [
      `float focalLength = ${FOCAL_LENGTH}`,
      `float horizontalAperture = ${float(aperture * ASPECT)}`,
      `float verticalAperture = ${float(aperture)}`,
      ...motionLines(camera.motion, placement),
    ],
  };
}
