import { determinant } from '../../../../math/mat3.ts';
import {
  fromParts,
  IDENTITY,
  invert,
  linearPart,
  type Mat4,
  multiply,
  scaledUniformly,
  transpose,
} from '../../../../math/mat4.ts';
import { matrixOfParts, type TransformParts } from '../../../../math/transformParts.ts';
import { scale } from '../../../../math/vec3.ts';
import { flippedWinding } from '../../../../scene/mesh/meshOps.ts';
import { type RestShape, shapeWeightsAt } from '../../../../scene/streaming/blendedPoints.ts';
import type { SceneObject } from '../../../../scene/types.ts';
import { ancestors, commonAncestor } from '../../../write/paths.ts';
import {
  areClose,
  frameAtStart,
  vertexInfluences,
  type WrittenSkeleton,
  type WrittenSkin,
} from '../../../write/skeletons.ts';
import {
  attribute,
  type PrimContent,
  type Properties,
  perVertexOf,
  relationship,
  sampled,
  schemas,
  uniform,
} from '../../layer/specs.ts';
import { floats, floatTuples, halfTuples, ints, matrices, quaternions, tokens, tuple } from '../../layer/values.ts';
import { orderOf, TRANSLATE, type WriteContext } from '../motions.ts';
import type { MeshForm } from '../prims.ts';
import { type PrimTree, primName } from '../primTree.ts';

/** Bind matrices that differ less, relative to their largest number, are the same: files have f32. */
const SAME_BIND = 1e-5;

/** A mesh with the path of its prim. */
interface PlacedSkin {
  readonly skin: WrittenSkin;
  readonly path: string;
}

/** A skeleton below a SkelRoot, with the meshes that follow it there. */
interface RootedSkeleton {
  readonly skeleton: WrittenSkeleton;
  readonly skins: readonly PlacedSkin[];
  readonly root: string;
}

/** A Skeleton prim: the joints as some meshes are bound to them. */
interface SkeletonPrim {
  readonly path: string;
  readonly skeleton: WrittenSkeleton;
  readonly animation: string;
  /** By joint from the axes in which meshes are bound to the joint's; undefined for those that none follows. */
  readonly binds: (Mat4 | undefined)[];
  /** By joint, how much larger its axes are written: UsdSkel has scales as halves, which 1 is exactly. */
  readonly sizes: readonly number[];
}

interface BoundSkin extends PlacedSkin {
  readonly prim: SkeletonPrim;
  /** From the mesh's axes to those in which meshes are bound. */
  readonly geomBind: Mat4;
  /** Of its blend shapes. */
  readonly shapeNames: readonly string[];
}

/**
 * The SkelRoot, Skeleton and SkelAnimation prims of a scene, and how the meshes that follow them are written. Meshes have the transform of their skeleton, which
 * is that of all their points.
 */
export class SkeletonPrims {
  private readonly tree: PrimTree;
  private readonly bound = new Map<SceneObject, BoundSkin>();
  private readonly prims: SkeletonPrim[] = [];
  private readonly roots: ReadonlySet<string>;

  /**
   * @param claimed Paths of the objects that follow joints.
   * @param placed Paths of all prims with a place of their own, which cannot be a SkelRoot.
   */
  constructor(
    tree: PrimTree,
    skeletons: readonly WrittenSkeleton[],
    claimed: ReadonlyMap<SceneObject, string>,
    placed: ReadonlySet<string>,
  ) {
    this.tree = tree;
    const rooted = skeletons.flatMap((skeleton) => this.rooted(skeleton, claimed, placed));
    const wanted = new Set(rooted.map(({ root }) => root));
    // SkelRoots are not in each other.
    const outermost = (root: string): string => ancestors(root).findLast((above) => wanted.has(above)) ?? root;
    this.roots = new Set([...wanted].map(outermost));
    for (const each of rooted) this.bind({ ...each, root: outermost(each.root) });
  }

  /** The path of an object's prim. */
  pathOf(object: SceneObject): string | undefined {
    return this.bound.get(object)?.path;
  }

  formOf(object: SceneObject, placement: WriteContext): MeshForm | undefined {
    const bound = this.bound.get(object);
    return bound && skinForm(bound, placement, (wanted) => this.tree.innerName(bound.path, wanted));
  }

  /** Writes all but the meshes. */
  write(placement: (path: string) => WriteContext): void {
    for (const root of this.roots) this.tree.set(root, { type: 'SkelRoot', properties: [] });
    for (const prim of this.prims) this.tree.set(prim.path, skeletonContent(prim, placement(prim.path)));
    for (const [path, prim] of new Map(this.prims.map((each) => [each.animation, each]))) {
      const skins = [...this.bound.values()].filter((skin) => skin.prim.animation === path);
      this.tree.set(path, animationContent(prim, skins, placement(path)));
    }
  }

  /** The SkelRoots of a skeleton's meshes: what all are below, or else each by itself. */
  private rooted(
    skeleton: WrittenSkeleton,
    claimed: ReadonlyMap<SceneObject, string>,
    placed: ReadonlySet<string>,
  ): readonly RootedSkeleton[] {
    const skins = skeleton.skins.map((skin) => ({ skin, path: claimed.get(skin.object)! }));
    const inside = ({ skin, path }: PlacedSkin): PlacedSkin => ({ skin, path: this.tree.claim(`${path}/Mesh`) });
    const common = commonAncestor(skins.map(({ path }) => path));
    const root = [common, ...ancestors(common)].find((path) => path !== '' && !placed.has(path));
    if (root === undefined) return skins.map((each) => ({ skeleton, skins: [inside(each)], root: each.path }));
    // What follows joints is inherited by all that is below.
    const parents = new Set([...placed].flatMap(ancestors));
    return [{ skeleton, skins: skins.map((each) => (parents.has(each.path) ? inside(each) : each)), root }];
  }

  /** Meshes whose bind matrices do not go together have Skeleton prims of their own, which share the animation. */
  private bind({ skeleton, skins, root }: RootedSkeleton): void {
    const sizes = axesSizes(skeleton);
    const prims: SkeletonPrim[] = [];
    for (const [i, { skin, path }] of skins.entries()) {
      const binds = skin.binds.map((bind, j) => bind && scaledUniformly(bind, sizes[j]));
      let [prim, geomBind] = firstFitting(prims, binds);
      if (!prim) {
        const own = this.tree.claim(`${root}/Skeleton`);
        const animation = prims[0]?.animation ?? this.tree.claim(`${own}/Animation`);
        prim = { path: own, skeleton, animation, binds: [], sizes };
        prims.push(prim);
        geomBind = IDENTITY;
      }
      const undo = invert(geomBind)!;
      for (const [j, bind] of binds.entries()) prim.binds[j] ??= bind && multiply(bind, undo);
      const name = path.slice(path.lastIndexOf('/') + 1);
      const shapeNames = skin.points.shapes.map((_, s) => `${name}_${i}_${s}`);
      this.bound.set(skin.object, { skin, path, prim, geomBind, shapeNames });
    }
    this.prims.push(...prims);
  }
}

/** The first prim whose joints a mesh can be bound to, and from its axes to those of the others. */
function firstFitting(
  prims: readonly SkeletonPrim[],
  binds: readonly (Mat4 | undefined)[],
): readonly [SkeletonPrim | undefined, Mat4] {
  for (const prim of prims) {
    const factor = commonFactor(prim.binds, binds);
    if (factor) return [prim, factor];
  }
  return [undefined, IDENTITY];
}

/** G with bⱼ = aⱼ G for all joints that both have; undefined if there is none. */
function commonFactor(a: readonly (Mat4 | undefined)[], b: readonly (Mat4 | undefined)[]): Mat4 | undefined {
  const shared = b.flatMap((bind, j) => (bind && a[j] ? [{ a: a[j], b: bind }] : []));
  if (shared.length === 0) return IDENTITY;
  const undo = invert(shared[0].a);
  const factor = undo && multiply(undo, shared[0].b);
  if (!factor || !invert(factor)) return undefined;
  return shared.every((each) => areClose(multiply(each.a, factor), each.b, SAME_BIND)) ? factor : undefined;
}

/** By joint the size of its axes at the start; 1 where they have none. */
const axesSizes = ({ tracks, tree }: WrittenSkeleton): readonly number[] =>
  tracks.map((_, j) => Math.cbrt(Math.abs(determinant(linearPart(frameAtStart(tracks, tree.parents, j))))) || 1);

/** A joint in its parent's axes, where those of both have size 1 at the start. */
function normalized(parts: TransformParts, own: number, above: number): TransformParts {
  return { ...parts, translation: scale(parts.translation, above), scale: scale(parts.scale, above / own) };
}

const localAt = ({ skeleton, sizes }: SkeletonPrim, j: number, k: number): TransformParts =>
  normalized(skeleton.tracks[j][k], sizes[j], sizes[skeleton.tree.parents[j]] ?? 1);

function skeletonContent(prim: SkeletonPrim, placement: WriteContext): PrimContent {
  const { skeleton, binds, sizes, animation } = prim;
  const { tracks, tree } = skeleton;
  const rest = tracks.map((_, j) => matrixOfParts(localAt(prim, j, 0)));
  // Joints that no mesh follows are bound as they are at the start.
  const atStart = (j: number): Mat4 => {
    const frame = multiply(
      frameAtStart(tracks, tree.parents, j),
      fromParts(
        UNIT.map((x) => x / sizes[j]),
        [0, 0, 0],
      ),
    );
    return invert(frame) ? frame : IDENTITY;
  };
  const bind = tracks.map((_, j) => (binds[j] && invert(binds[j])) ?? atStart(j));
  return {
    type: 'Skeleton',
    metadata: schemas('SkelBindingAPI'),
    properties: [
      uniform('matrix4d[]', 'bindTransforms', rowVectors(bind)),
      uniform('token[]', 'joints', tokens(jointPaths(skeleton))),
      uniform('matrix4d[]', 'restTransforms', rowVectors(rest)),
      relationship('skel:animationSource', animation),
      ...transformOfAll(skeleton, placement),
    ],
  };
}

const UNIT = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Matrices as USD has them, for row vectors. */
const rowVectors = (all: readonly Mat4[]) => matrices(Float64Array.from(all.flatMap((m) => transpose(m))));

/** The paths of joints, by their names. */
function jointPaths({ tree: { names, parents } }: WrittenSkeleton): readonly string[] {
  const paths: string[] = [];
  const taken = new Set<string>();
  const pathOf = (j: number): string => {
    if (paths[j] !== undefined) return paths[j];
    const above = parents[j] < 0 ? '' : `${pathOf(parents[j])}/`;
    const wanted = `${above}${primName(names[j])}`;
    let path = wanted;
    for (let n = 1; taken.has(path); n++) path = `${wanted}_${n}`;
    taken.add(path);
    paths[j] = path;
    return path;
  };
  return names.map((_, j) => pathOf(j));
}

/** Where the joints' axes are in the world. */
function transformOfAll({ placement, shifts, times }: WrittenSkeleton, context: WriteContext): Properties {
  const perUnit = 1 / context.metersPerUnit;
  const matrix = attribute('matrix4d', MATRIX_OP, tuple('matrix4d', transpose(scaledUniformly(placement, perUnit))));
  if (!shifts) return [matrix, orderOf(context, MATRIX_OP)];
  const codes = times.map((t) => t * context.codesPerSecond);
  const shift = (k: number) =>
    tuple(
      'double3',
      Array.from(shifts.subarray(3 * k, 3 * k + 3), (x) => x * perUnit),
    );
  return [matrix, sampled('double3', TRANSLATE, codes, shift), orderOf(context, TRANSLATE, MATRIX_OP)];
}

const MATRIX_OP = 'xformOp:transform';

function animationContent(
  prim: SkeletonPrim,
  skins: readonly BoundSkin[],
  { codesPerSecond }: WriteContext,
): PrimContent {
  const { skeleton } = prim;
  const { tracks, times } = skeleton;
  const keys = skeleton.commonKeys();
  const codes = Float64Array.from(keys, (k) => times[k] * codesPerSecond);
  const values = (k: number, of: (parts: TransformParts) => readonly number[]): Float32Array =>
    Float32Array.from(tracks.flatMap((_, j) => of(localAt(prim, j, k))));
  return {
    type: 'SkelAnimation',
    properties: [
      uniform('token[]', 'joints', tokens(jointPaths(skeleton))),
      sampled('quatf[]', 'rotations', codes, (i) => quaternions(values(keys[i], ({ rotation }) => rotation))),
      sampled('half3[]', 'scales', codes, (i) => halfTuples(values(keys[i], (parts) => parts.scale))),
      sampled('float3[]', 'translations', codes, (i) =>
        floatTuples(
          'float3',
          values(keys[i], ({ translation }) => translation),
        ),
      ),
      ...shapeWeights(skins, times, codesPerSecond),
    ],
  };
}

/** The weights of all blend shapes at the samples that one of them keeps. */
function shapeWeights(skins: readonly BoundSkin[], times: Float64Array, codesPerSecond: number): Properties {
  const names = skins.flatMap(({ shapeNames }) => shapeNames);
  if (names.length === 0) return [];
  const keys = [
    ...new Set(skins.flatMap(({ skin, shapeNames }) => (shapeNames.length > 0 ? skin.shapeKeys : []))),
  ].sort((a, b) => a - b);
  const codes = Float64Array.from(keys, (k) => times[k] * codesPerSecond);
  const weights = (k: number): Float32Array =>
    Float32Array.from(skins.flatMap(({ skin: { points } }) => [...shapeWeightsAt(points, k)]));
  return [
    uniform('token[]', 'blendShapes', tokens(names)),
    sampled('float[]', 'blendShapeWeights', codes, (i) => floats(weights(keys[i]))),
  ];
}

function skinForm(bound: BoundSkin, placement: WriteContext, innerName: (wanted: string) => string): MeshForm {
  const { skin, prim, geomBind, shapeNames, path } = bound;
  const { points, object } = skin;
  const { joints, weights, perVertex } = vertexInfluences(points);
  const shapes = points.shapes.map((shape, s) => [innerName(`Shape${s}`), blendShape(shape)] as const);
  const isMirrored = determinant(linearPart(prim.skeleton.placement)) < 0;
  return {
    rest: points.rest,
    indices: isMirrored ? flippedWinding(object.mesh.indices) : object.mesh.indices,
    schemas: ['SkelBindingAPI'],
    bindings: [
      attribute('matrix4d', 'primvars:skel:geomBindTransform', tuple('matrix4d', transpose(geomBind))),
      attribute('int[]', 'primvars:skel:jointIndices', ints(Int32Array.from(joints)), {
        metadata: perVertexOf(perVertex),
      }),
      attribute('float[]', 'primvars:skel:jointWeights', floats(weights), { metadata: perVertexOf(perVertex) }),
      ...(shapes.length > 0
        ? [
            uniform('token[]', 'skel:blendShapes', tokens(shapeNames)),
            relationship('skel:blendShapeTargets', ...shapes.map(([name]) => `${path}/${name}`)),
          ]
        : []),
      relationship('skel:skeleton', prim.path),
    ],
    transform: transformOfAll(prim.skeleton, placement),
    inner: new Map(shapes),
  };
}

/** The points that a shape moves, and how far. */
function blendShape({ positions, normals }: RestShape): PrimContent {
  const moved: number[] = [];
  for (let v = 0; v < positions.length / 3; v++) {
    let moves = false;
    for (let i = 3 * v; i < 3 * v + 3; i++) moves ||= positions[i] !== 0 || normals[i] !== 0;
    if (moves) moved.push(v);
  }
  const own = (all: Float32Array): Float32Array =>
    Float32Array.from(moved.flatMap((v) => [...all.subarray(3 * v, 3 * v + 3)]));
  return {
    type: 'BlendShape',
    properties: [
      uniform('vector3f[]', 'normalOffsets', floatTuples('float3', own(normals))),
      uniform('vector3f[]', 'offsets', floatTuples('float3', own(positions))),
      uniform('int[]', 'pointIndices', ints(Int32Array.from(moved))),
    ],
  };
}
