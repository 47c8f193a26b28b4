import {
  type AttributeSpec,
  type ListOp,
  type MetadataValue,
  NOTHING,
  type PrimSpec,
  type PropertySpec,
  type RelationshipSpec,
  type Specifier,
} from '../layer.ts';
import { composeMetadata } from './composedMetadata.ts';
import { contentOf } from './content.ts';
import type { Opinion, StackLayer } from './layerStack.ts';
import { composeList } from './listOps.ts';
import { localSamples, localValue, type Place } from './localValues.ts';
import { mapToTarget } from './namespaceMap.ts';
import { type Node, strongestFirst } from './node.ts';
import { nameOf } from './paths.ts';
import { mapOp } from './sites.ts';
import { weightOf } from './weight.ts';
import type { Work } from './work.ts';

/** One opinion on a prim, and where it is in the stage's namespace and time. */
class Said implements Place {
  readonly spec: PrimSpec;
  readonly node: Node;
  readonly from: StackLayer;

  constructor(node: Node, { spec, from }: Opinion) {
    this.spec = spec;
    this.node = node;
    this.from = from;
  }
}

/** What is said of a prim, strongest first; as much as may be counted. */
function opinionsOf(index: Node, work: Work): Said[] {
  const out: Said[] = [];
  for (const node of strongestFirst(index)) {
    if (!node.contributes) continue;
    for (const opinion of node.opinions) {
      if (work.isTooMuch) return out;
      work.spend(weightOf(opinion.spec));
      out.push(new Said(node, opinion));
    }
  }
  return out;
}

/** What becomes of the opinions on a prim: one spec without arcs, as if one layer said it all. Children are to be added. */
export function composedPrim(index: Node, path: string, work: Work): PrimSpec {
  const opinions = opinionsOf(index, work);
  const typeName = opinions.find(({ spec }) => spec.typeName !== '')?.spec.typeName ?? '';
  return {
    path,
    name: nameOf(path),
    specifier: specifierOf(opinions),
    typeName,
    content: contentOf(typeName, opinions),
    metadata: metadataOf(opinions),
    properties: composedProperties(opinions),
    children: NOTHING,
    variantSets: NOTHING,
  };
}

interface SaidOf<T extends { readonly metadata: ReadonlyMap<string, MetadataValue> }> {
  readonly spec: T;
  readonly place: Place;
}

function metadataOf(opinions: readonly Said[]): ReadonlyMap<string, MetadataValue> {
  const said = opinions.filter(({ spec }) => spec.metadata !== NOTHING);
  return composeMetadata(said.map((place) => ({ metadata: place.spec.metadata, place })));
}

const propertyMetadata = (stack: readonly SaidOf<PropertySpec>[]): ReadonlyMap<string, MetadataValue> =>
  composeMetadata(stack.map(({ spec, place }) => ({ metadata: spec.metadata, place })));

/** `def` where anything defines the prim; a class that is only inherited or specialized does not make it one. */
function specifierOf(opinions: readonly Said[]): Specifier {
  let found: Specifier = 'over';
  for (const { spec, node } of opinions) {
    if (spec.specifier === 'over') continue;
    if (spec.specifier === 'def' || !isUnderClass(node)) return spec.specifier;
    found = 'class';
  }
  return found;
}

function isUnderClass(node: Node): boolean {
  for (let at: Node | undefined = node; at; at = at.parent) if (at.isClass && at.isDirect) return true;
  return false;
}

type SaidProperty<T extends PropertySpec = PropertySpec> = SaidOf<T>;

function composedProperties(opinions: readonly Said[]): ReadonlyMap<string, PropertySpec> {
  const byName = new Map<string, SaidProperty[]>();
  for (const place of opinions) {
    for (const spec of place.spec.properties.values()) {
      const stack = byName.get(spec.name);
      if (stack) stack.push({ spec, place });
      else byName.set(spec.name, [{ spec, place }]);
    }
  }
  if (byName.size === 0) return NOTHING;
  return new Map([...byName].map(([name, stack]) => [name, composedProperty(stack)]));
}

function composedProperty(stack: readonly SaidProperty[]): PropertySpec {
  // What the strongest calls it, it is.
  if (stack[0].spec.kind === 'attribute') return composedAttribute(stack.filter(isAttribute));
  return composedRelationship(stack.filter(isRelationship));
}

const isAttribute = (said: SaidProperty): said is SaidProperty<AttributeSpec> => said.spec.kind === 'attribute';
const isRelationship = (said: SaidProperty): said is SaidProperty<RelationshipSpec> =>
  said.spec.kind === 'relationship';

/**
 * The default is the strongest one. Samples count where nothing stronger has a default or a spline: of one layer's,
 * samples are first. `None` hides what is weaker; an animation block only the weaker samples and splines.
 */
function composedAttribute(stack: readonly SaidProperty<AttributeSpec>[]): AttributeSpec {
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
  if (fixed) out.value = localValue(fixed.spec.value!, fixed.place);
  const animated = stack.find(({ spec }) => spec.value || isSampled(spec) || spec.spline !== undefined);
  if (animated && isSampled(animated.spec)) out.timeSamples = localSamples(animated.spec.timeSamples!, animated.place);
  else if (animated?.spec.spline !== undefined) out.spline = animated.spec.spline;
  const connections = composedPaths(stack.map(({ spec, place }) => ({ op: spec.connections, place })));
  if (connections) out.connections = connections;
  return out;
}

/** Says the same wherever it is said: most attributes are the stage's as they are a layer's. */
const isPlain = ({ value, timeSamples, connections, metadata, spline }: AttributeSpec): boolean =>
  !timeSamples &&
  !connections &&
  spline === undefined &&
  metadata === NOTHING &&
  (value === undefined || !/^(asset|timecode|dictionary|animationBlock)/.test(value.type));

const isSampled = ({ timeSamples }: AttributeSpec): boolean =>
  timeSamples !== undefined && timeSamples.times.length > 0;

function composedRelationship(stack: readonly SaidProperty<RelationshipSpec>[]): RelationshipSpec {
  const { kind, name, uniform } = stack[0].spec;
  const metadata = propertyMetadata(stack);
  const out: RelationshipSpec = { kind, name, custom: stack.some(({ spec }) => spec.custom), uniform, metadata };
  const targets = composedPaths(stack.map(({ spec, place }) => ({ op: spec.targets, place })));
  if (targets) out.targets = targets;
  return out;
}

/** Targets in the stage's namespace; those outside of what an arc maps are none. */
function composedPaths(said: readonly { op: ListOp<string> | undefined; place: Place }[]): ListOp<string> | undefined {
  const ops = said.flatMap(({ op, place }) => (op ? [mappedOp(op, place)] : []));
  return ops.length === 0 ? undefined : { explicit: composeList(ops, (path) => path) };
}

function mappedOp(op: ListOp<string>, { node }: Place): ListOp<string> {
  const map = node.mapToRoot;
  const mapped = mapOp(op, (path) => mapToTarget(map, path === '/' ? '' : path));
  const out: ListOp<string> = {};
  for (const [key, items] of Object.entries(mapped) as [keyof ListOp<string>, (string | undefined)[]][])
    out[key] = items.flatMap((path) => (path === undefined ? [] : [path || '/']));
  return out;
}
