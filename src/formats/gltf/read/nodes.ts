import type { Animation, Node as GltfNode } from '@gltf-transform/core';
import { decomposeRigid, IDENTITY, type Mat4, multiply } from '../../../math/mat4.ts';
import { multiply as after, normalizeQuat, type Quat } from '../../../math/quat.ts';
import { matrixOfParts, type TransformParts } from '../../../math/transformParts.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import { UniquePrimPaths } from '../../read/primPaths.ts';
import { type GltfContext, gltfError } from '../context.ts';
import { type AnimationCurve, makeCurve } from './curves.ts';

type AnimatedProperty = 'translation' | 'rotation' | 'scale' | 'weights';

interface NodeTreeEntry {
  /** Index in the file. */
  readonly place: number;
  readonly source: GltfNode;
  readonly parent: NodeTreeEntry | undefined;
  readonly curves: Readonly<Partial<Record<AnimatedProperty, AnimationCurve>>>;
  /** In its parent, as far as no curve moves it. */
  readonly rest: RestTransform;
  readonly path: string;
}

/** A transform with the parts that animation replaces, which cannot shear as a matrix can. */
interface RestTransform extends NodeTransform {
  readonly parts: TransformParts;
}

/** A frame at a time: its matrix to the world, and the product of the rotations alone. */
export interface NodeTransform {
  readonly matrix: Mat4;
  readonly rotation: Quat;
}

/** The frame of a node, or one fixed in it. */
export interface AnimatedTransform {
  /** For messages. */
  readonly path: string;
  /** All curves that affect it. */
  readonly curves: readonly AnimationCurve[];
  transformAt(t: number): NodeTransform;
}

/** The node tree with one animation: frames at any time [s]. */
export class NodeTree {
  private readonly nodes = new Map<GltfNode, NodeTreeEntry>();
  private readonly names = new UniquePrimPaths();
  /** The nodes' frames at the time that was last asked for. */
  private readonly frames = new Map<NodeTreeEntry, NodeTransform>();
  private time = Number.NaN;
  constructor(context: GltfContext, animation: Animation | undefined) {
    const all = context.document.getRoot().listNodes();
    const curves = animation
      ? readChannels(context, animation)
      : new Map<GltfNode, Partial<Record<AnimatedProperty, AnimationCurve>>>();
    const places = new Map(all.map((node, i) => [node, i]));
    const build = (source: GltfNode, parent: NodeTreeEntry | undefined): void => {
      const place = places.get(source) ?? 0;
      const written = context.json.nodes?.[place].matrix;
      const path = this.names.of(parent?.path ?? '', source.getName() || `Node${place}`);
      const own = curves.get(source) ?? {};
      const rest = restTransform(source, written && rowMajor(written));
      const node = { place, source, parent, curves: own, rest, path };
      this.nodes.set(source, node);
      for (const child of source.listChildren()) build(child, node);
    };
    const children = new Set(all.flatMap((node) => node.listChildren()));
    for (const node of all) if (!children.has(node)) build(node, undefined);
  }

  /** Index among the nodes of the file. */
  placeOf(node: GltfNode): number {
    return this.of(node).place;
  }

  /** A unique path below a node. */
  pathBelow(node: GltfNode, name: string): string {
    return this.names.of(this.path(node), name);
  }

  path(node: GltfNode): string {
    return this.of(node).path;
  }

  /** All curves that affect a node: its own and its ancestors'. */
  curvesAbove(node: GltfNode): AnimationCurve[] {
    const found: AnimationCurve[] = [];
    for (let n: NodeTreeEntry | undefined = this.of(node); n; n = n.parent) {
      const { translation, rotation, scale } = n.curves;
      for (const curve of [translation, rotation, scale]) if (curve) found.push(curve);
    }
    return found;
  }

  weightsCurve(node: GltfNode): AnimationCurve | undefined {
    return this.of(node).curves.weights;
  }

  /** The frame of a node; with `within`, one fixed in it. */
  frame(node: GltfNode, within?: NodeTransform): AnimatedTransform {
    return {
      path: this.path(node),
      curves: this.curvesAbove(node),
      transformAt: (t) => {
        const own = this.transformAt(node, t);
        return within ? composeTransforms(own, within) : own;
      },
    };
  }

  transformAt(node: GltfNode, t: number): NodeTransform {
    if (t !== this.time) this.frames.clear();
    this.time = t;
    return this.entryTransform(this.of(node), t);
  }

  private entryTransform(entry: NodeTreeEntry, t: number): NodeTransform {
    const known = this.frames.get(entry);
    if (known) return known;
    const own = localTransformAt(entry, t);
    const world = entry.parent
      ? composeTransforms(this.entryTransform(entry.parent, t), own)
      : composeTransforms(WORLD, own);
    this.frames.set(entry, world);
    return world;
  }

  private of(node: GltfNode): NodeTreeEntry {
    return this.nodes.get(node)!;
  }
}

const WORLD: NodeTransform = { matrix: IDENTITY, rotation: [0, 0, 0, 1] };

const composeTransforms = (above: NodeTransform, own: NodeTransform): NodeTransform => ({
  matrix: multiply(above.matrix, own.matrix),
  rotation: after(above.rotation, own.rotation),
});

function localTransformAt({ rest, curves }: NodeTreeEntry, t: number): NodeTransform {
  if (!curves.translation && !curves.rotation && !curves.scale) return rest;
  const parts = {
    translation: (curves.translation?.at(t) as Vec3 | undefined) ?? rest.parts.translation,
    rotation: (curves.rotation?.at(t) as Quat | undefined) ?? rest.parts.rotation,
    scale: (curves.scale?.at(t) as Vec3 | undefined) ?? rest.parts.scale,
  };
  return { matrix: matrixOfParts(parts), rotation: parts.rotation };
}

/** `matrix`: the authored one. */
function restTransform(source: GltfNode, matrix: Mat4 | undefined): RestTransform {
  const [x, y, z, w] = source.getRotation();
  const rotation = normalizeQuat([x, y, z, w]);
  const parts = { translation: source.getTranslation(), rotation, scale: source.getScale() };
  if (!matrix) return { matrix: matrixOfParts(parts), rotation, parts };
  return { matrix, rotation: decomposeRigid(matrix).pose.orientation, parts };
}

/** glTF matrices are column-major. */
const rowMajor = (m: readonly number[]): Mat4 => Array.from({ length: 16 }, (_, i) => m[(i % 4) * 4 + (i >> 2)]);

const WIDTHS: Readonly<Record<string, number>> = { translation: 3, rotation: 4, scale: 3 };

function readChannels(
  context: GltfContext,
  animation: Animation,
): Map<GltfNode, Partial<Record<AnimatedProperty, AnimationCurve>>> {
  const byNode = new Map<GltfNode, Partial<Record<AnimatedProperty, AnimationCurve>>>();
  for (const channel of animation.listChannels()) {
    const [node, sampler, path] = [channel.getTargetNode(), channel.getSampler(), channel.getTargetPath() ?? ''];
    const what = msg`animation ${animation.getName() || msg`without a name`}, ${node?.getName() || msg`a node`}.${path}`;
    const width = path === 'weights' ? morphCount(node) : WIDTHS[path];
    if (!node || width === undefined) {
      context.notes.add('warning', 'gltf.channel', what, msg`this kind of animation is not read; it is left out`);
      continue;
    }
    if (!sampler?.getInput() || !sampler.getOutput()) {
      throw gltfError(context.entry, 'gltf.bad-animation', what, msg`has no keys; export it again`);
    }
    if (width === 0) continue;
    const curves = byNode.get(node) ?? {};
    curves[path as AnimatedProperty] = makeCurve(context.entry, what, sampler, width, path === 'rotation');
    byNode.set(node, curves);
  }
  return byNode;
}

const morphCount = (node: GltfNode | null): number =>
  Math.max(
    0,
    ...(node
      ?.getMesh()
      ?.listPrimitives()
      .map((p) => p.listTargets().length) ?? []),
  );
