import { type Message, msg } from '../../../../messages/message.ts';
import type { SkinInfluences } from '../../../read/skinning.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numberOf, numbersOf, textAt, tokensAt, valueAt } from '../../layer/attributes.ts';
import type { AttributeSpec, PrimSpec } from '../../layer/layer.ts';
import { metadataText, primAt } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { nearestAncestor, nearestTarget } from './inheritedProperties.ts';
import { SKELETON } from './maybeSkinned.ts';
import { columnMatrices, readSkeleton, type Skeleton } from './skeleton.ts';

/** Maximum number of influences per point; more is an error in the file. */
export const MAX_INFLUENCES = 4096;

/** How a mesh is bound to its skeleton. */
export interface SkelBinding {
  readonly skeleton: Skeleton;
  /** Absent if no joint influences the mesh; blend shapes may. */
  readonly joints?: JointBinding;
}

export interface JointBinding {
  /** Joint indices are those of the skeleton. */
  readonly influences: SkinInfluences;
  /** All points have the same influences. */
  readonly isRigid: boolean;
  /** Mesh space to bind space, three rows of four. */
  readonly geomBind: Float64Array;
  readonly method: 'classicLinear' | 'dualQuaternion';
}

/** Reads and caches the skeletons of a stage. */
export class Skeletons {
  private readonly context: StageContext;
  private readonly skeletons = new Map<string, Skeleton | undefined>();

  constructor(context: StageContext) {
    this.context = context;
  }

  /** Undefined if the mesh, or a shape without `points`, is not bound, or, with a diagnostic, if its binding is invalid. */
  bindingOf(mesh: PrimSpec, points: number | undefined): SkelBinding | undefined {
    const { layer } = this.context;
    if (!nearestAncestor(layer, mesh.path, (prim) => prim.typeName === 'SkelRoot')) return undefined;
    const path = nearestTarget(layer, mesh.path, SKELETON);
    if (path === undefined) return undefined;
    const skeleton = this.skeletonAt(path, mesh);
    if (!skeleton) return undefined;
    if (!nearestAttribute(this.context, mesh, INDICES)) return { skeleton };
    const joints = jointsOf(this.context, mesh, skeleton, points);
    if (!('template' in joints)) return { skeleton, joints };
    report(this.context, 'warning', 'usd.skin', mesh.path, msg`${joints}; the mesh stays as it is written`);
    return undefined;
  }

  private skeletonAt(path: string, mesh: PrimSpec): Skeleton | undefined {
    const prim = primAt(this.context.layer, path);
    if (prim?.typeName !== 'Skeleton') {
      const message = msg`skel:skeleton leads to ${path}, where no Skeleton is; the mesh stays as it is written`;
      report(this.context, 'warning', 'usd.skin', mesh.path, message);
      return undefined;
    }
    if (!this.skeletons.has(path)) this.skeletons.set(path, readSkeleton(this.context, prim));
    return this.skeletons.get(path);
  }
}

export const INDICES = 'primvars:skel:jointIndices';
const WEIGHTS = 'primvars:skel:jointWeights';

function nearestAttribute({ layer }: StageContext, mesh: PrimSpec, name: string): AttributeSpec | undefined {
  const prim = nearestAncestor(layer, mesh.path, (p) => attributeOf(p, name) !== undefined);
  return prim && attributeOf(prim, name);
}

/** The binding, or an error message that begins with the attribute's name. */
export function jointsOf(
  context: StageContext,
  mesh: PrimSpec,
  skeleton: Skeleton,
  points: number | undefined,
): JointBinding | Message {
  const geomBind = geomBindOf(context, mesh);
  const places = jointPlaces(context, mesh, skeleton);
  if ('template' in geomBind) return geomBind;
  if ('template' in places) return places;
  const [indices, weights] = [nearestAttribute(context, mesh, INDICES), nearestAttribute(context, mesh, WEIGHTS)];
  const at = (attribute: AttributeSpec | undefined) => numbersOf(valueAt(attribute, context.startCode));
  const [joints, shares] = [at(indices), at(weights)];
  if (!joints || !shares) return msg`${joints ? WEIGHTS : INDICES} has no value`;
  if (joints.length !== shares.length)
    return msg`${INDICES} has ${joints.length} values, and ${WEIGHTS} has ${shares.length}`;
  const perPoint = numberOf(indices!.metadata.get('elementSize') as never) ?? 1;
  const isRigid = (metadataText(indices!.metadata, 'interpolation') ?? 'constant') === 'constant';
  if (!(Number.isInteger(perPoint) && perPoint > 0 && perPoint <= MAX_INFLUENCES))
    return msg`${INDICES} has elementSize ${perPoint}, not 1 to ${MAX_INFLUENCES}`;
  if (!isRigid && points === undefined) return msg`${INDICES} is not constant, and a ${mesh.typeName} has no points`;
  const needed = (isRigid ? 1 : points!) * perPoint;
  if (joints.length !== needed)
    return msg`${INDICES} has ${joints.length} values; with elementSize ${perPoint} and interpolation ${isRigid ? 'constant' : 'vertex'} it needs ${needed}`;
  const bad = joints.findIndex((j) => !(j >= 0 && j < places.length));
  if (bad >= 0) return msg`${INDICES}[${bad}] is ${joints[bad]} of ${places.length} joints`;
  const odd = shares.findIndex((w) => !Number.isFinite(w));
  if (odd >= 0) return msg`${WEIGHTS}[${odd}] is ${shares[odd]}`;
  const influences = {
    perPoint,
    joints: Int32Array.from(joints, (j) => places[j]),
    weights: Float64Array.from(shares),
  };
  return { influences, isRigid, geomBind, method: skinningMethodOf(context, mesh) };
}

/** Index in the skeleton of each of the mesh's joints: by `skel:joints`, else in the skeleton's order. */
function jointPlaces(context: StageContext, mesh: PrimSpec, skeleton: Skeleton): number[] | Message {
  const owner = nearestAncestor(context.layer, mesh.path, (prim) => attributeOf(prim, 'skel:joints') !== undefined);
  const own = owner && tokensAt(owner, 'skel:joints', undefined);
  if (!own) return [...skeleton.joints.keys()];
  const byName = new Map(skeleton.joints.map((joint, i) => [joint, i]));
  const missing = own.find((joint) => !byName.has(joint));
  if (missing !== undefined) return msg`skel:joints names '${missing}', which is no joint of ${skeleton.path}`;
  return own.map((joint) => byName.get(joint)!);
}

function geomBindOf(context: StageContext, mesh: PrimSpec): Float64Array | Message {
  const name = 'primvars:skel:geomBindTransform';
  const value = numbersOf(valueAt(nearestAttribute(context, mesh, name), context.startCode));
  if (!value) return Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);
  if (value.length !== 16 || !value.every(Number.isFinite)) return msg`${name} is no matrix of finite numbers`;
  return columnMatrices(value);
}

function skinningMethodOf(context: StageContext, mesh: PrimSpec): JointBinding['method'] {
  const name = 'primvars:skel:skinningMethod';
  const owner = nearestAncestor(context.layer, mesh.path, (prim) => attributeOf(prim, name) !== undefined);
  const method = (owner && textAt(owner, name, undefined)) ?? 'classicLinear';
  if (method === 'dualQuaternion' || method === 'classicLinear') return method;
  report(context, 'warning', 'usd.skin', mesh.path, msg`${name} '${method}' is not known; classicLinear is taken`);
  return 'classicLinear';
}
