import { IDENTITY, type Mat4 } from '../../../../math/mat4.ts';
import { lerp, ZERO } from '../../../../math/vec3.ts';
import { boundingBox } from '../../../../scene/bounds/bounds.ts';
import { withoutQuadric } from '../../../../scene/mesh/quadric.ts';
import {
  type BlendedPoints,
  MATRIX,
  makeBlendedNormals,
  makeBlendedPoints,
} from '../../../../scene/streaming/blendedPoints.ts';
import type { Mesh } from '../../../../scene/types.ts';
import { blendedSkin, jointPoses, ONE_JOINT } from '../../../read/blendedSkin.ts';
import type { StageContext } from '../context.ts';
import type { LinearBlend, PlacedMesh, PoseGrid, PrimGeometry } from '../geometry/primGeometry.ts';
import { Memo } from '../transforms/memo.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { facingIndices, relativeTo } from './deforming.ts';

/** In the axes of the grid's poses. */
const BLENDED_POINTS = new Memo<BlendedPoints>();

/** A mesh that follows joints, which are kept instead of its points. */
export function placeBlended(
  context: StageContext,
  path: string,
  { mesh }: PrimGeometry,
  blend: LinearBlend,
  world: StageTransform,
): PlacedMesh {
  const grid = blend.gridIn(path, world);
  const { times, isInWorld } = grid;
  const start = world.matrixAt(times[0]);
  const frame = isInWorld ? IDENTITY : start;
  const own = BLENDED_POINTS.getOrCreate(blend, [grid], () => pointsOf(blend, grid));
  return placed(context, mesh, own, times, frame, start);
}

/** `frame`: from the axes of the poses to the world; `start`: the mesh's own frame at the first time. */
function placed(
  context: StageContext,
  mesh: Mesh,
  own: BlendedPoints,
  times: Float64Array,
  frame: Mat4,
  start: Mat4,
): PlacedMesh {
  const box = boundingBox(makeBlendedPoints({ ...own, outer: frame }, 0));
  const origin = box ? lerp(box.min, box.max, 0.5) : ZERO;
  const points = { ...own, outer: relativeTo(origin, frame) };
  const bent = { positions: makeBlendedPoints(points, 0), normals: makeBlendedNormals(points, 0) };
  return {
    mesh: { ...mesh, ...bent, indices: facingIndices(mesh.indices, start) },
    motion: { kind: 'sampled-points', times: times.map((t) => t / context.codesPerSecond), origin, points },
  };
}

/** By mesh, frame and times. */
const AFFINE_MESHES = new Memo<PlacedMesh>();

/** A mesh whose frame scales or shears it along the way: of one joint, the frame. */
export function placeAffine(context: StageContext, mesh: Mesh, world: StageTransform, times: Float64Array): PlacedMesh {
  return AFFINE_MESHES.getOrCreate(mesh, [world, times], () => {
    const poses = jointPoses(times.length, ONE_JOINT, (k, out) => {
      const m = world.matrixAt(times[k]);
      for (let i = 0; i < MATRIX; i++) out[i] = m[i];
    });
    const { positions, normals } = mesh;
    const rest = { positions, normals };
    const own = blendedSkin({ rest, shapes: [], shapeWeights: NO_WEIGHTS, poses, origin: ZERO });
    return placed(context, withoutQuadric(mesh), own, times, IDENTITY, world.matrixAt(times[0]));
  });
}

const NO_WEIGHTS = new Float64Array(0);

function pointsOf(blend: LinearBlend, { times, poses }: PoseGrid): BlendedPoints {
  const count = blend.shapes.length;
  const shapeWeights = new Float64Array(count * times.length);
  if (count > 0)
    times.forEach((t, k) => {
      shapeWeights.set(blend.shapeWeightsAt(t), count * k);
    });
  return blendedSkin({ ...blend, shapeWeights, poses, origin: ZERO });
}
