import { IDENTITY, type Mat4, multiply } from '../../../../math/mat4.ts';
import { gatherPoints } from '../../../../scene/mesh/makeMesh.ts';
import { deformedNormals, smoothingGroups } from '../../../../scene/mesh/normals.ts';
import { matrixAt, type RestShape } from '../../../../scene/streaming/blendedPoints.ts';
import type { Mesh } from '../../../../scene/types.ts';
import type { OutlinedMesh } from '../../../read/jointOutline.ts';
import type { SkinInfluences } from '../../../read/skinning.ts';
import type { NumberArray } from '../../layer/layer.ts';
import type { SkelBinding } from './binding.ts';
import type { BlendShapes, ShapeOffsets } from './blendShapes.ts';

/** Joints are numbered with 16 bits, and one more is for what is missing from weights. */
const MAX_JOINTS = 2 ** 16 - 1;
/** Most influences of a mesh, of all its vertices together. */
const MAX_INFLUENCES = 2 ** 25;
/** Most numbers of the blend shapes of a mesh. */
const MAX_OFFSETS = 2 ** 25;

/** Whether a mesh is a blend of one rest shape by its joints, of a size that can be kept so. `points`: or vertices. */
export function isLinearBlend(
  { skeleton, joints }: SkelBinding,
  shapes: BlendShapes | undefined,
  points: number,
): boolean {
  if ((shapes?.parts.length ?? 0) * 6 * points > MAX_OFFSETS) return false;
  if (!joints) return true;
  const few = skeleton.joints.length < MAX_JOINTS && joints.influences.perPoint * points <= MAX_INFLUENCES;
  return few && joints.method === 'classicLinear';
}

/** By joint the matrix from the mesh's points to the joint's axes; the identity for a mesh without joints. */
export function bindsOf({ skeleton, joints }: SkelBinding): readonly Mat4[] {
  if (!joints) return [IDENTITY];
  const { inverseBind } = skeleton;
  const geomBind = [...joints.geomBind, 0, 0, 0, 1];
  return skeleton.joints.map((_, j) => multiply(matrixAt(inverseBind, j), geomBind));
}

/** The influences of vertices, of which each is one of the mesh's points; undefined for a mesh without joints. */
export function influencesOf({ joints }: SkelBinding, pointOfVertex: ArrayLike<number>): SkinInfluences | undefined {
  if (!joints) return undefined;
  const { perPoint, joints: indices, weights } = joints.influences;
  const count = perPoint * pointOfVertex.length;
  const out = { perPoint, joints: new Uint16Array(count), weights: new Float32Array(count) };
  for (let v = 0, to = 0; v < pointOfVertex.length; v++) {
    const from = joints.isRigid ? 0 : perPoint * pointOfVertex[v];
    for (let i = from; i < from + perPoint; i++, to++) {
      out.joints[to] = indices[i];
      out.weights[to] = weights[i];
    }
  }
  return out;
}

/** A mesh by its points, as its joints see it. */
export function outlinedPoints(
  points: NumberArray,
  binding: SkelBinding,
  shapes: BlendShapes | undefined,
): OutlinedMesh {
  const each = Uint32Array.from({ length: points.length / 3 }, (_, i) => i);
  const skin = influencesOf(binding, each);
  return {
    positions: points,
    binds: bindsOf(binding),
    ...(skin && { skin }),
    shapes: (shapes?.parts ?? []).map((part) => ({ positions: offsetsOf(part, part.points, each) })),
    weightsAt: (t) => shapes?.partWeightsAt(t) ?? [],
  };
}

/** The displacements that blend shapes make of a mesh's vertices and normals. */
export function restShapes(
  mesh: Mesh,
  shapes: BlendShapes | undefined,
  pointOfVertex: ArrayLike<number>,
  areNormalsAuthored: boolean,
): RestShape[] {
  if (!shapes || shapes.parts.length === 0) return [];
  const hasNormals = areNormalsAuthored && shapes.haveNormals;
  const groups = hasNormals ? undefined : smoothingGroups(mesh);
  const bare = groups && deformedNormals(mesh.positions, mesh.indices, groups);
  return shapes.parts.map((part) => {
    const positions = offsetsOf(part, part.points, pointOfVertex);
    if (!groups || !bare) return { positions, normals: offsetsOf(part, part.normals!, pointOfVertex) };
    const bent = deformedNormals(
      positions.map((x, i) => x + mesh.positions[i]),
      mesh.indices,
      groups,
    );
    return { positions, normals: bent.map((x, i) => x - bare[i]) };
  });
}

/** Offsets of vertices, 0 for those of points without. */
function offsetsOf(
  { rows }: Pick<ShapeOffsets, 'rows'>,
  offsets: NumberArray,
  pointOfVertex: ArrayLike<number>,
): Float32Array {
  if (!rows) return gatherPoints(offsets, pointOfVertex);
  const out = new Float32Array(3 * pointOfVertex.length);
  for (let v = 0; v < pointOfVertex.length; v++) {
    const row = rows[pointOfVertex[v]];
    if (row >= 0) for (let k = 0; k < 3; k++) out[3 * v + k] = offsets[3 * row + k];
  }
  return out;
}
