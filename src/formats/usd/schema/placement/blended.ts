import { IDENTITY } from '../../../../math/mat4.ts';
import { lerp, ZERO } from '../../../../math/vec3.ts';
import { boundingBox } from '../../../../scene/bounds/bounds.ts';
import {
  type BlendedPoints,
  makeBlendedNormals,
  makeBlendedPoints,
} from '../../../../scene/streaming/blendedPoints.ts';
import { blendedSkin } from '../../../read/blendedSkin.ts';
import type { StageContext } from '../context.ts';
import type { JointGrid, LinearBlend, PlacedMesh, PrimGeometry } from '../geometry/primGeometry.ts';
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
  const box = boundingBox(makeBlendedPoints({ ...own, outer: frame }, 0));
  const origin = box ? lerp(box.min, box.max, 0.5) : ZERO;
  const points = { ...own, outer: relativeTo(origin, frame) };
  const bent = { positions: makeBlendedPoints(points, 0), normals: makeBlendedNormals(points, 0) };
  return {
    mesh: { ...mesh, ...bent, indices: facingIndices(mesh.indices, start) },
    motion: { kind: 'sampled-points', times: times.map((t) => t / context.codesPerSecond), origin, points },
  };
}

function pointsOf(blend: LinearBlend, { times, poses }: JointGrid): BlendedPoints {
  const count = blend.shapes.length;
  const shapeWeights = new Float64Array(count * times.length);
  if (count > 0)
    times.forEach((t, k) => {
      shapeWeights.set(blend.shapeWeightsAt(t), count * k);
    });
  return blendedSkin({ ...blend, shapeWeights, poses, origin: ZERO });
}
