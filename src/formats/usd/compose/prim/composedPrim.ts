import {
  type AttributeSpec,
  EMPTY_MAP,
  type ListOp,
  type MetadataValue,
  type PrimSpec,
  type PropertySpec,
  type RelationshipSpec,
  type Specifier,
} from '../../layer/layer.ts';
import { nameOf } from '../../layer/primPaths.ts';
import type { Opinion, StackLayer } from '../layers/layerStack.ts';
import { composeList } from '../layers/listOps.ts';
import { mapOp } from '../layers/siteOpinions.ts';
import type { CompositionBudget } from '../primIndex/compositionBudget.ts';
import { mapToTarget } from '../primIndex/namespaceMap.ts';
import { type PrimIndexNode, strongestFirst } from '../primIndex/primIndexNode.ts';
import { composeMetadata } from './composedMetadata.ts';
import { contentKeyOf } from './contentKey.ts';
import { opinionCost } from './opinionCost.ts';
import { type OpinionSource, stageSamples, stageValue } from './stageValues.ts';

/** One opinion on a prim, and where it is in the stage's namespace and time. */
class SourcedOpinion implements OpinionSource {
  readonly spec: PrimSpec;
  readonly node: PrimIndexNode;
  readonly from: StackLayer;

  constructor(node: PrimIndexNode, { spec, from }: Opinion) {
    this.spec = spec;
    this.node = node;
    this.from = from;
  }
}

/** Opinions on a prim, strongest first, within the budget. */
function opinionsOf(index: PrimIndexNode, work: CompositionBudget): SourcedOpinion[] {
  const out: SourcedOpinion[] = [];
  for (const node of strongestFirst(index)) {
    if (!node.contributes) continue;
    for (const opinion of node.opinions) {
      if (work.isExhausted) return out;
      work.spend(opinionCost(opinion.spec));
      out.push(new SourcedOpinion(node, opinion));
    }
  }
  return out;
}

/** Composes a prim's opinions to one spec without arcs; children are added later. */
export function composedPrim(index: PrimIndexNode, path: string, work: CompositionBudget): PrimSpec {
  const opinions = opinionsOf(index, work);
  const typeName = opinions.find(({ spec }) => spec.typeName !== '')?.spec.typeName ?? '';
  return {
    path,
    name: nameOf(path),
    specifier: specifierOf(opinions),
    typeName,
    content: contentKeyOf(typeName, opinions),
    metadata: metadataOf(opinions),
    properties: composedProperties(opinions),
    children: EMPTY_MAP,
    variantSets: EMPTY_MAP,
  };
}

interface SourcedSpec<T extends { readonly metadata: ReadonlyMap<string, MetadataValue> }> {
  readonly spec: T;
  readonly place: OpinionSource;
}

function metadataOf(opinions: readonly SourcedOpinion[]): ReadonlyMap<string, MetadataValue> {
  const said = opinions.filter(({ spec }) => spec.metadata !== EMPTY_MAP);
  return composeMetadata(said.map((place) => ({ metadata: place.spec.metadata, place })));
}

const propertyMetadata = (stack: readonly SourcedSpec<PropertySpec>[]): ReadonlyMap<string, MetadataValue> =>
  composeMetadata(stack.map(({ spec, place }) => ({ metadata: spec.metadata, place })));

/** `def` if any opinion defines the prim, except `class` opinions of inherited or specialized prims. */
function specifierOf(opinions: readonly SourcedOpinion[]): Specifier {
  let found: Specifier = 'over';
  for (const { spec, node } of opinions) {
    if (spec.specifier === 'over') continue;
    if (spec.specifier === 'def' || !isUnderClass(node)) return spec.specifier;
    found = 'class';
  }
  return found;
}

function isUnderClass(node: PrimIndexNode): boolean {
  for (let at: PrimIndexNode | undefined = node; at; at = at.parent) if (at.isClass && at.isDirect) return true;
  return false;
}

type SourcedProperty<T extends PropertySpec = PropertySpec> = SourcedSpec<T>;

function composedProperties(opinions: readonly SourcedOpinion[]): ReadonlyMap<string, PropertySpec> {
  const byName = new Map<string, SourcedProperty[]>();
  for (const place of opinions) {
    for (const spec of place.spec.properties.values()) {
      const stack = byName.get(spec.name);
      if (stack) stack.push({ spec, place });
      else byName.set(spec.name, [{ spec, place }]);
    }
  }
  if (byName.size === 0) return EMPTY_MAP;
  return new Map([...byName].map(([name, stack]) => [name, composedProperty(stack)]));
}

function composedProperty(stack: readonly SourcedProperty[]): PropertySpec {
  // The strongest opinion decides the kind of property.
  if (stack[0].spec.kind === 'attribute') return composedAttribute(stack.filter(isAttribute));
  return composedRelationship(stack.filter(isRelationship));
}

const isAttribute = (said: SourcedProperty): said is SourcedProperty<AttributeSpec> => said.spec.kind === 'attribute';
const isRelationship = (said: SourcedProperty): said is SourcedProperty<RelationshipSpec> =>
  said.spec.kind === 'relationship';

/**
 * The default is the strongest one. Time samples count unless a stronger opinion has a default or spline; within one
 * layer samples come first. `None` blocks everything weaker; an animation block only weaker samples and splines.
 */
function composedAttribute(stack: readonly SourcedProperty<AttributeSpec>[]): AttributeSpec {
  if (stack.length === 1 && isPlain(stack[0].spec)) return stack[0].spec;
  const { kind, name, typeName } = stack[0].spec;
  const out: AttributeSpec = {
    kind,
    name,
    typeName,
    custom: stack.some(({ spec }) => spec.custom),
    uniform: stack.some(({ spec }) => spec.uniform),
    metadata: propertyMetadata(stack),
  };
  const fixed = stack.find(({ spec }) => spec.value && spec.value.type !== 'animationBlock');
  if (fixed) out.value = stageValue(fixed.spec.value!, fixed.place);
  const animated = stack.find(({ spec }) => spec.value || isSampled(spec) || spec.spline !== undefined);
  if (animated && isSampled(animated.spec)) out.timeSamples = stageSamples(animated.spec.timeSamples!, animated.place);
  else if (animated?.spec.spline !== undefined) out.spline = animated.spec.spline;
  const connections = composedPaths(stack.map(({ spec, place }) => ({ op: spec.connections, place })));
  if (connections) out.connections = connections;
  return out;
}

/** Whether an attribute is the same in layer and stage, as most are. */
const isPlain = ({ value, timeSamples, connections, metadata, spline }: AttributeSpec): boolean =>
  !timeSamples &&
  !connections &&
  spline === undefined &&
  metadata === EMPTY_MAP &&
  (value === undefined || !/^(asset|timecode|dictionary|animationBlock)/.test(value.type));

const isSampled = ({ timeSamples }: AttributeSpec): boolean =>
  timeSamples !== undefined && timeSamples.times.length > 0;

function composedRelationship(stack: readonly SourcedProperty<RelationshipSpec>[]): RelationshipSpec {
  const { kind, name, uniform } = stack[0].spec;
  const metadata = propertyMetadata(stack);
  const out: RelationshipSpec = { kind, name, custom: stack.some(({ spec }) => spec.custom), uniform, metadata };
  const targets = composedPaths(stack.map(({ spec, place }) => ({ op: spec.targets, place })));
  if (targets) out.targets = targets;
  return out;
}

/** Targets mapped to the stage's namespace; unmapped ones are dropped. */
function composedPaths(
  said: readonly { op: ListOp<string> | undefined; place: OpinionSource }[],
): ListOp<string> | undefined {
  const ops = said.flatMap(({ op, place }) => (op ? [mappedOp(op, place)] : []));
  return ops.length === 0 ? undefined : { explicit: composeList(ops, (path) => path) };
}

function mappedOp(op: ListOp<string>, { node }: OpinionSource): ListOp<string> {
  const map = node.mapToRoot;
  const mapped = mapOp(op, (path) => mapToTarget(map, path === '/' ? '' : path));
  const out: ListOp<string> = {};
  for (const [key, items] of Object.entries(mapped) as [keyof ListOp<string>, (string | undefined)[]][])
    out[key] = items.flatMap((path) => (path === undefined ? [] : [path || '/']));
  return out;
}
