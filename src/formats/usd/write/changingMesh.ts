import { fromPose } from '../../../math/mat4.ts';
import { transformNormalsInPlace } from '../../../scene/mesh/transformPoints.ts';
import { pointSamples, restingPose } from '../../../scene/motion/motion.ts';
import { pieceAt } from '../../../scene/motion/poses.ts';
import { normalsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Mesh, SceneObject } from '../../../scene/types.ts';
import {
  PER_VERTEX,
  type PrimContent,
  type Properties,
  relationship,
  sampled,
  schemas,
  uniform,
} from '../layer/specs.ts';
import { bool, ints, LazyTuples, token } from '../layer/values.ts';
import { gprimContent } from './gprims.ts';
import { lifeProperties } from './lives.ts';
import { slowlightMotion, transformOf, type WriteContext } from './motions.ts';
import { movesUntil, pointTimes, type TurnMotion, type TurnShape, turnMotion, turnsOf } from './pieceMotions.ts';
import { authoringProperties, extentOf, type MeshSurroundings, meshContent, scaledPoints } from './prims.ts';

/** Whether pieces can be written as one prim. */
export const isOneMesh = (pieces: readonly SceneObject[]): boolean => {
  const turns = turnsOf(pieces);
  return turns.length === 1 || turnMotion(turns) !== undefined;
};

/** A mesh, or all pieces of one: its topology and points over time, and its visibility. */
export function meshOfPieces(
  pieces: readonly [SceneObject, ...SceneObject[]],
  placement: WriteContext,
  surroundings: MeshSurroundings,
): PrimContent {
  const turns = turnsOf(pieces);
  const motion = turns.length > 1 ? turnMotion(turns) : undefined;
  return motion
    ? changingMesh(turns, motion, placement, surroundings)
    : (gprimContent(pieces[0], placement, surroundings) ?? meshContent(pieces[0], placement, surroundings));
}

function changingMesh(
  turns: readonly TurnShape[],
  motion: TurnMotion,
  placement: WriteContext,
  { materialOf, innerName }: MeshSurroundings,
): PrimContent {
  const { object } = turns[0];
  const meshes = turns.map((turn) => turn.object.mesh);
  const starts = turns.map((turn) => pointTimes(turn, placement.startTime)[0] * placement.codesPerSecond);
  const codes = Float64Array.from(starts);
  const materials = [...new Set(meshes.flatMap(({ groups }) => groups.map(({ material }) => material)))];
  const perTurn = (typeName: string, name: string, values: (mesh: Mesh) => Float32Array) =>
    sampled(
      typeName,
      name,
      codes,
      (i) => ({ type: name === 'primvars:st' ? 'float2[]' : 'float3[]', data: values(meshes[i]) }),
      PER_VERTEX,
    );
  const facesOf = (material: number): PrimContent => ({
    type: 'GeomSubset',
    metadata: schemas('MaterialBindingAPI'),
    properties: [
      uniform('token', 'elementType', token('face')),
      uniform('token', 'familyName', token('materialBind')),
      sampled('int[]', 'indices', codes, (i) => ints(trianglesWith(meshes[i], material))),
      relationship('material:binding', materialOf(material)),
    ],
  });
  return {
    type: 'Mesh',
    metadata: schemas('MaterialBindingAPI'),
    properties: [
      uniform('bool', 'doubleSided', bool(object.mesh.doubleSided)),
      ...pointProperties(turns, motion, placement),
      sampled('int[]', 'faceVertexCounts', codes, (i) => ints(new Int32Array(meshes[i].indices.length / 3).fill(3))),
      sampled('int[]', 'faceVertexIndices', codes, (i) => ints(new Int32Array(meshes[i].indices))),
      ...(materials.length === 1 ? [relationship('material:binding', materialOf(materials[0]))] : []),
      ...(meshes.some(({ colors }) => colors)
        ? [perTurn('color3f[]', 'primvars:displayColor', (mesh) => mesh.colors ?? white(mesh))]
        : []),
      perTurn('texCoord2f[]', 'primvars:st', ({ uvs }) => uvs),
      ...authoringProperties(object),
      ...slowlightMotion(motion.transform, placement),
      uniform('token', 'subdivisionScheme', token('none')),
      ...lifeProperties(placement),
      ...transformOf(motion.transform, placement),
    ],
    inner: new Map(
      materials.length > 1 ? materials.map((material, i) => [innerName(`Part${i}`), facesOf(material)] as const) : [],
    ),
  };
}

const white = ({ positions }: Mesh): Float32Array => new Float32Array(positions.length).fill(1);

function trianglesWith({ groups }: Mesh, material: number): Int32Array {
  const out: number[] = [];
  for (const { start, count, material: own } of groups)
    if (own === material) for (let i = start; i < start + count; i += 3) out.push(i / 3);
  return Int32Array.from(out);
}

/** One sample of the points of all turns. */
interface PointSample {
  readonly turn: TurnShape;
  /** World time [s]. */
  readonly time: number;
  /** Until when its points go on straight [s]; absent if they rest. */
  readonly until: number | undefined;
}

function pointProperties(turns: readonly TurnShape[], motion: TurnMotion, placement: WriteContext): Properties {
  const { codesPerSecond, startTime, metersPerUnit } = placement;
  const samples = turns.flatMap((turn): PointSample[] => {
    const times = motion.points ? pointTimes(turn, startTime) : pointTimes(turn, startTime).slice(0, 1);
    return times.map((time, i) => ({ turn, time, until: movesUntil(turn, time, times[i + 1]) }));
  });
  const codes = Float64Array.from(samples, ({ time }) => time * codesPerSecond);
  const pointsOf = ({ turn, time }: PointSample): Float32Array =>
    motion.points ? motion.points(turn, time) : turn.object.mesh.positions;
  const normalsOf = (sample: PointSample): Float32Array =>
    motion.points ? worldNormals(sample) : sample.turn.object.mesh.normals;
  // Where the next sample has other points, only velocities say how these go on.
  const isLast = ({ turn }: PointSample, i: number): boolean => samples[i + 1]?.turn !== turn;
  const moveOn = motion.points && samples.some((sample, i) => sample.until !== undefined && isLast(sample, i));
  const lazily = (
    typeName: string,
    name: string,
    of: (sample: PointSample) => Float32Array,
    metadata?: typeof PER_VERTEX,
  ) => sampled(typeName, name, codes, (i) => new LazyTuples(() => of(samples[i])), metadata);
  return [
    lazily('float3[]', 'extent', (sample) => extentOf(pointsOf(sample), metersPerUnit)),
    lazily('normal3f[]', 'normals', normalsOf, PER_VERTEX),
    lazily('point3f[]', 'points', (sample) => scaledPoints(pointsOf(sample), metersPerUnit)),
    ...(moveOn
      ? [lazily('vector3f[]', 'velocities', (sample) => scaledPoints(velocitiesOf(sample, motion), metersPerUnit))]
      : []),
  ];
}

/** [m/s] */
function velocitiesOf({ turn, time, until }: PointSample, { points }: TurnMotion): Float32Array {
  const from = points!(turn, time);
  if (until === undefined) return new Float32Array(from.length);
  const to = points!(turn, until);
  return from.map((x, i) => (to[i] - x) / (until - time));
}

/** Normals on the world's axes. */
function worldNormals({ turn: { object }, time }: PointSample): Float32Array {
  const samples = pointSamples(object.motion);
  const pose = restingPose(object.motion);
  if (pose) return transformNormalsInPlace(object.mesh.normals.slice(), fromPose(pose));
  return (samples && normalsAt(samples, pieceAt(samples.times, time).before)) ?? object.mesh.normals;
}
