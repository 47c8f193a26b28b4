import type { Accessor, Buffer, Document, Node as GltfNode, Skin as GltfSkin } from '@gltf-transform/core';
import { determinant } from '../../../math/mat3.ts';
import { fromPose, IDENTITY, invert, linearPart, type Mat4, multiply, transpose } from '../../../math/mat4.ts';
import { matrixOfParts, partsOf, type TransformParts } from '../../../math/transformParts.ts';
import { msg } from '../../../messages/message.ts';
import { flippedWinding } from '../../../scene/mesh/meshOps.ts';
import { shapeWeightsAt } from '../../../scene/streaming/blendedPoints.ts';
import type { Scene } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { orientationYUp, vectorYUp } from '../../write/exportMotion.ts';
import { distanceOf } from '../../write/jointTracks.ts';
import {
  areClose,
  frameAtStart,
  type VertexInfluences,
  vertexInfluences,
  type WrittenSkeleton,
  type WrittenSkin,
} from '../../write/skeletons.ts';
import type { AnimationWriter } from './writeAnimation.ts';
import type { MeshWriter } from './writeMeshes.ts';

/** Inverse bind matrices that differ less are the same: files have f32. */
const SAME_BIND = 1e-6;

/** Whether glTF has a skeleton: nodes do not shear, and weights are not negative. */
export const isGltfSkeleton = ({ placement, skins }: WrittenSkeleton): boolean =>
  distanceOf(matrixOfParts(partsOf(placement)), placement, 1) <= 1e-6 * Math.hypot(...linearPart(placement)) &&
  skins.every(({ points }) => points.weights.every((w) => w >= 0));

/** Writes skeletons as nodes with skins; a mesh that follows one joint as a whole is at that node. */
export class SkinWriter {
  private readonly document: Document;
  private readonly buffer: Buffer;
  private readonly scene: Scene;
  private readonly losses: DiagnosticLog;
  private readonly meshes: MeshWriter;
  private readonly animations: AnimationWriter;

  constructor(
    place: {
      readonly document: Document;
      readonly buffer: Buffer;
      readonly scene: Scene;
      readonly losses: DiagnosticLog;
    },
    meshes: MeshWriter,
    animations: AnimationWriter,
  ) {
    this.document = place.document;
    this.buffer = place.buffer;
    this.scene = place.scene;
    this.losses = place.losses;
    this.meshes = meshes;
    this.animations = animations;
  }

  /** Writes what follows one joint as a whole as a node that moves; false if it is something else. `nodeAt`: a new node for a mesh at its path. */
  writeCarried(skeleton: WrittenSkeleton, nodeAt: (path: string) => GltfNode): boolean {
    const [skin] = skeleton.skins;
    const parts = carriedParts(skeleton, this.toYUp);
    if (!parts) return false;
    const node = nodeAt(skin.object.path);
    setParts(node, parts[0]);
    const keys = skeleton.keysOf(0);
    this.addParts(
      node,
      keys.map((k) => skeleton.times[k]),
      keys.map((k) => parts[k]),
    );
    this.addMesh(node, skin, matrixOfParts(parts[0]), skeleton.times);
    return true;
  }

  /** From the scene's axes to the file's. */
  private get toYUp(): Mat4 {
    return fromPose({ position: [0, 0, 0], orientation: orientationYUp(this.scene, [0, 0, 0, 1]) });
  }

  private addParts(node: GltfNode, times: readonly number[], parts: readonly TransformParts[]): void {
    this.animations.addKeys(node, times, {
      translation: parts.map(({ translation }) => translation),
      rotation: parts.map(({ rotation }) => rotation),
      scale: parts.map(({ scale }) => scale),
    });
  }

  /** `nodeAt`: a new node for a mesh at its path. `root`: where the skeleton begins. */
  write(skeleton: WrittenSkeleton, root: GltfNode, nodeAt: (path: string) => GltfNode): void {
    const placement = this.placeRoot(skeleton, root);
    const joints = this.addJoints(skeleton, root);
    const skins: SharedSkin[] = [];
    for (const skin of skeleton.skins) {
      const made = sharedSkin(skins, skin.binds, () => this.document.createSkin(root.getName()));
      const node = nodeAt(skin.object.path);
      const first = skin.binds.findIndex((bind) => bind !== undefined);
      const start = multiply(placement, frameAtStart(skeleton.tracks, skeleton.tree.parents, first));
      this.addMesh(
        node,
        skin,
        multiply(start, skin.binds[first] ?? IDENTITY),
        skeleton.times,
        vertexInfluences(skin.points, 4, true),
      );
      node.setSkin(made.skin);
    }
    for (const { skin, binds } of skins) this.finish(skin, binds, skeleton, joints, root);
  }

  /** The frame of all joints; returns its matrix in the axes of the file. */
  private placeRoot({ placement, shifts, times }: WrittenSkeleton, root: GltfNode): Mat4 {
    const matrix = multiply(this.toYUp, placement);
    const parts = partsOf(matrix);
    setParts(root, parts);
    if (!shifts) return matrix;
    const [x, y, z] = parts.translation;
    const translation = Array.from(times, (_, k) => {
      const [dx, dy, dz] = vectorYUp(this.scene, [shifts[3 * k], shifts[3 * k + 1], shifts[3 * k + 2]]);
      return [x + dx, y + dy, z + dz];
    });
    root.setTranslation(translation[0] as [number, number, number]);
    this.animations.addKeys(root, times, { translation });
    return matrix;
  }

  private addJoints(skeleton: WrittenSkeleton, root: GltfNode): readonly GltfNode[] {
    const { tree, tracks, times } = skeleton;
    const nodes = tree.names.map((name) => this.document.createNode(name));
    nodes.forEach((node, j) => {
      (nodes[tree.parents[j]] ?? root).addChild(node);
      setParts(node, tracks[j][0]);
      const keys = skeleton.keysOf(j);
      this.addParts(
        node,
        keys.map((k) => times[k]),
        keys.map((k) => tracks[j][k]),
      );
    });
    return nodes;
  }

  /** `start`: from the rest shape to the world, at the first sample. */
  private addMesh(
    node: GltfNode,
    { object, points, shapeKeys }: WrittenSkin,
    start: Mat4,
    times: Float64Array,
    influences?: VertexInfluences,
  ): void {
    if (influences && influences.perVertex > 4) {
      const message = msg`vertices follow more than 4 joints; programs that read only the first 4 show it otherwise`;
      this.losses.add('info', 'convert.points', object.path, message);
    }
    const { mesh } = object;
    // The frame that mirrors a mesh turns its triangles round.
    const indices = determinant(linearPart(start)) < 0 ? flippedWinding(mesh.indices) : mesh.indices;
    const shape = { rest: points.rest, targets: points.shapes, ...(influences && { influences }) };
    this.meshes.addShape(node, { ...mesh, indices }, shape);
    if (points.shapes.length === 0) return;
    const weights = shapeKeys.map((k) => [...shapeWeightsAt(points, k)]);
    node.getMesh()?.setWeights(weights[0]);
    this.animations.addKeys(
      node,
      shapeKeys.map((k) => times[k]),
      { weights },
    );
  }

  /** Joints that no mesh follows are bound as they are at the start. */
  private finish(
    skin: GltfSkin,
    binds: readonly (Mat4 | undefined)[],
    { tracks, tree }: WrittenSkeleton,
    joints: readonly GltfNode[],
    root: GltfNode,
  ): void {
    const matrices = joints.flatMap((joint, j) => {
      skin.addJoint(joint);
      return transpose(binds[j] ?? invert(frameAtStart(tracks, tree.parents, j)) ?? IDENTITY);
    });
    skin.setSkeleton(root).setInverseBindMatrices(this.matrices(matrices));
  }

  private matrices(numbers: readonly number[]): Accessor {
    return this.document.createAccessor().setType('MAT4').setArray(Float32Array.from(numbers)).setBuffer(this.buffer);
  }
}

interface SharedSkin {
  readonly skin: GltfSkin;
  readonly binds: (Mat4 | undefined)[];
}

/** The first of skins that has the same inverse bind matrices for all joints that both have, with those of the mesh added. */
function sharedSkin(skins: SharedSkin[], binds: WrittenSkin['binds'], create: () => GltfSkin): SharedSkin {
  const fits = (known: SharedSkin): boolean =>
    binds.every((bind, j) => !bind || !known.binds[j] || areClose(bind, known.binds[j], SAME_BIND));
  let found = skins.find(fits);
  if (!found) {
    found = { skin: create(), binds: [] };
    skins.push(found);
  }
  for (const [j, bind] of binds.entries()) found.binds[j] ??= bind;
  return found;
}

/** The parts of the one joint of a mesh that follows it as a whole, in the world; undefined if there is more to it. */
function carriedParts(
  { tracks, placement, shifts, skins }: WrittenSkeleton,
  toYUp: Mat4,
): readonly TransformParts[] | undefined {
  const isCarried =
    tracks.length === 1 && skins.length === 1 && !shifts && areClose(skins[0].binds[0] ?? IDENTITY, IDENTITY);
  if (!isCarried) return undefined;
  const outer = multiply(toYUp, placement);
  const parts: TransformParts[] = [];
  for (const local of tracks[0]) {
    const matrix = multiply(outer, matrixOfParts(local));
    const own = partsOf(matrix, parts.at(-1)?.rotation);
    if (!areClose(matrixOfParts(own), matrix, SAME_BIND)) return undefined;
    parts.push(own);
  }
  return parts;
}

function setParts(node: GltfNode, { translation, rotation, scale }: TransformParts): void {
  node
    .setTranslation([...translation])
    .setRotation([...rotation])
    .setScale([...scale]);
}
