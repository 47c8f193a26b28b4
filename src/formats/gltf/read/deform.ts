import type { Node as GltfNode } from '@gltf-transform/core';
import { determinant } from '../../../math/mat3.ts';
import { IDENTITY, linearPart, type Mat4, multiply } from '../../../math/mat4.ts';
import { normalize } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import type { JointTree } from '../../../scene/streaming/blendedPoints.ts';
import { ONE_JOINT } from '../../read/blendedSkin.ts';
import { type GltfContext, gltfError } from '../context.ts';
import { floatsOf } from './accessors.ts';
import type { AnimationCurve } from './curves.ts';
import type { AnimatedTransform, NodeTree } from './nodes.ts';
import type { Geometry } from './primitives.ts';

/** How one mesh at one node moves and bends: its joints and the weights of its morph targets at any time [s]. */
export interface Deformer {
  /** All curves that affect it. */
  readonly curves: readonly AnimationCurve[];
  /** From the rest shape to the axes of each joint; one for a mesh that follows its node. */
  readonly binds: readonly Mat4[];
  readonly isSkinned: boolean;
  readonly tree: JointTree;
  /** Names its joints, if nothing else moves it, so that it shares their times with other meshes. */
  readonly skeleton?: string;
  /** From the axes of each joint to the world. */
  framesAt(t: number): readonly Mat4[];
  weightsAt(t: number): readonly number[];
  /** Whether the node's transform mirrors the mesh at a time. */
  isMirroredAt(t: number): boolean;
}

interface Joint {
  readonly node: GltfNode;
  readonly inverseBind: Mat4;
}

/** `frame`: the node's frame, for meshes without joints. */
export function makeDeformer(
  context: GltfContext,
  tree: NodeTree,
  node: GltfNode,
  frame: AnimatedTransform,
  geometry: Geometry,
): Deformer {
  const joints = geometry.skin ? readJoints(context, tree, node, geometry.skin.joints) : undefined;
  const weightsCurve = geometry.morphs.length > 0 ? tree.weightsCurve(node) : undefined;
  const weightsAt = (t: number): readonly number[] => weightsCurve?.at(t) ?? givenWeights(node);
  const movers = new Set(joints ? joints.flatMap((j) => tree.curvesAbove(j.node)) : frame.curves);
  // A skinned mesh follows its joints alone; its own node does not move it (glTF 2.0, 3.7.3.3).
  const framesAt = (t: number): Mat4[] =>
    joints?.map((j) => tree.transformAt(j.node, t).matrix) ?? [frame.transformAt(t).matrix];
  const binds = joints?.map((j) => j.inverseBind) ?? [IDENTITY];
  return {
    curves: [...movers, ...(weightsCurve ? [weightsCurve] : [])],
    binds,
    isSkinned: joints !== undefined,
    tree: joints ? jointTree(joints.map((j) => j.node)) : ONE_JOINT,
    ...(joints && !weightsCurve && { skeleton: skeletonOf(tree, node) }),
    framesAt,
    weightsAt,
    isMirroredAt: (t) => determinant(linearPart(multiply(framesAt(t)[0], binds[0]))) < 0,
  };
}

/** A joint's parent is the nearest node above it that is a joint. */
function jointTree(joints: readonly GltfNode[]): JointTree {
  const places = new Map(joints.map((node, j) => [node, j]));
  const parentOf = (joint: GltfNode): number => {
    for (let node = joint.getParentNode(); node; node = node.getParentNode()) {
      const place = places.get(node);
      if (place !== undefined) return place;
    }
    return -1;
  };
  return { names: joints.map((node, j) => node.getName() || `Joint${j}`), parents: joints.map(parentOf) };
}

/** Names the joints of a node's skin: skins with the same joints move together. */
export const skeletonOf = (tree: NodeTree, node: GltfNode): string =>
  node
    .getSkin()
    ?.listJoints()
    .map((joint) => tree.placeOf(joint))
    .join(' ') ?? '';

const givenWeights = (node: GltfNode): readonly number[] =>
  node.getWeights().length > 0 ? node.getWeights() : (node.getMesh()?.getWeights() ?? []);

/** The mesh with constant morph weights applied. */
export function settleMorphs(node: GltfNode, geometry: Geometry): Geometry {
  const weights = givenWeights(node);
  const { mesh, morphs } = geometry;
  if (!morphs.some((_, i) => weights[i])) return { ...geometry, morphs: [] };
  const settled = (values: Float32Array, of: 'positions' | 'normals'): Float32Array =>
    values.map((x, i) => morphs.reduce((sum, morph, m) => sum + (weights[m] ?? 0) * morph[of][i], x));
  const normals = settled(mesh.normals, 'normals');
  for (let i = 0; i < normals.length; i += 3) {
    normals.set(normalize([normals[i], normals[i + 1], normals[i + 2]], [0, 0, 1]), i);
  }
  return { ...geometry, mesh: { ...mesh, positions: settled(mesh.positions, 'positions'), normals }, morphs: [] };
}

function readJoints(context: GltfContext, tree: NodeTree, node: GltfNode, used: Uint16Array): Joint[] | undefined {
  const what = tree.path(node);
  const skin = node.getSkin();
  if (!skin) return undefined;
  const nodes = skin.listJoints();
  const highest = used.reduce((a, b) => Math.max(a, b), 0);
  if (highest >= nodes.length) {
    const message = msg`a vertex follows joint ${highest} of ${nodes.length}; the file is damaged, export it again`;
    throw gltfError(context.entry, 'gltf.bad-skin', what, message);
  }
  const accessor = skin.getInverseBindMatrices();
  const binds = accessor ? floatsOf(accessor) : undefined;
  if (binds && binds.length < nodes.length * 16) {
    const message = msg`${binds.length / 16} inverse bind matrices for ${nodes.length} joints; export it again`;
    throw gltfError(context.entry, 'gltf.bad-skin', what, message);
  }
  const bind = (j: number): Mat4 =>
    Array.from({ length: 16 }, (_, i) => (binds ? binds[j * 16 + (i % 4) * 4 + (i >> 2)] : i % 5 === 0 ? 1 : 0));
  return nodes.map((joint, j) => ({ node: joint, inverseBind: bind(j) }));
}
