import { pointSamples } from '../../../scene/motion/motion.ts';
import { normalsAt, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Mesh, Motion, SceneCamera, SceneObject } from '../../../scene/types.ts';
import { boxCorners } from '../schema/geometry/pointSampling.ts';
import { motionLines, slowlightMotionLines, type WriteContext } from './motionLines.ts';
import type { PrimContent } from './primTree.ts';
import { block, double, float, floatTuples, type Lines, timeSamples, withMetadata } from './usdaText.ts';

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
  const samples = pointSamples(motion);
  const still = !samples || !normalsAt(samples, 0);
  const normals = still ? `normal3f[] normals = ${floatTuples(mesh.normals, 3)}` : 'normal3f[] normals';
  const normalLines = withMetadata(normals, 'interpolation = "vertex"');
  if (!samples)
    return [
      `float3[] extent = ${extent(mesh.positions)}`,
      ...normalLines,
      `point3f[] points = ${points(mesh.positions)}`,
    ];
  const codes = samples.times.map((t) => t * placement.codesPerSecond);
  return [
    ...timeSamples('float3[] extent', codes, (i) => extent(pointsAt(samples, i))),
    ...normalLines,
    ...(still ? [] : timeSamples('normal3f[] normals', codes, (i) => floatTuples(normalsAt(samples, i)!, 3))),
    ...timeSamples('point3f[] points', codes, (i) => points(pointsAt(samples, i))),
    ...(samples.velocities ? timeSamples('vector3f[] velocities', codes, (i) => points(samples.velocities![i])) : []),
  ];
}

type WithSlowlightAttributes = Pick<SceneObject, 'motion' | 'lifetime'> & Partial<Pick<SceneObject, 'authoredIn'>>;

/** Our own attributes: what closed-form motion, lifetime and frame of authoring an object or a light has. */
export function slowlightLines(
  { motion, lifetime, authoredIn }: WithSlowlightAttributes,
  placement: WriteContext,
): Lines {
  return [
    ...(authoredIn === 'rest' ? ['custom token slowlight:authoredIn = "rest"'] : []),
    ...(Number.isFinite(lifetime.birth) ? [`custom double slowlight:birth = ${double(lifetime.birth)}`] : []),
    ...(Number.isFinite(lifetime.death) ? [`custom double slowlight:death = ${double(lifetime.death)}`] : []),
    ...slowlightMotionLines(motion, placement),
  ];
}

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
