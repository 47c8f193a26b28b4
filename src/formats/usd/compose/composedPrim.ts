import type { AttributeSpec, ListOp, PrimSpec, PropertySpec, RelationshipSpec, Specifier } from '../layer.ts';
import { composeMetadata } from './composedMetadata.ts';
import { contentOf } from './content.ts';
import type { Opinion } from './layerStack.ts';
import { composeList } from './listOps.ts';
import { localSamples, localValue, type Place } from './localValues.ts';
import { mapToTarget } from './namespaceMap.ts';
import { byStrength, type Node } from './node.ts';
import { nameOf } from './paths.ts';
import { mapOp } from './sites.ts';

/** One opinion on a prim, and where it is in the stage's namespace and time. */
interface Said extends Place {
  readonly spec: PrimSpec;
  readonly node: Node;
}

/** All that is said of a prim, strongest first. */
export function opinionsOf(index: Node): Said[] {
  return byStrength(index)
    .filter((node) => node.contributes)
    .flatMap((node) => node.opinions.map((opinion) => said(node, opinion)));
}

const said = (node: Node, { spec, from }: Opinion): Said => ({ spec, node, from, map: node.mapToRoot });

/** What becomes of the opinions on a prim: one spec without arcs, as if one layer said it all. Children are to be added. */
export function composedPrim(index: Node, path: string): PrimSpec {
  const opinions = opinionsOf(index);
  const typeName = opinions.find(({ spec }) => spec.typeName !== '')?.spec.typeName ?? '';
  return {
    path,
    name: nameOf(path),
    specifier: specifierOf(opinions),
    typeName,
    content: contentOf(typeName, opinions),
    metadata: composeMetadata(opinions.map((o) => ({ metadata: o.spec.metadata, place: o }))),
    properties: composedProperties(opinions),
    children: new Map(),
    variantSets: new Map(),
  };
}

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

interface SaidProperty<T extends PropertySpec = PropertySpec> extends Place {
  readonly spec: T;
}

function composedProperties(opinions: readonly Said[]): Map<string, PropertySpec> {
  const byName = new Map<string, SaidProperty[]>();
  for (const { spec, from, map } of opinions) {
    for (const property of spec.properties.values()) {
      const stack = byName.get(property.name);
      if (stack) stack.push({ spec: property, from, map });
      else byName.set(property.name, [{ spec: property, from, map }]);
    }
  }
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
  const { kind, name, typeName } = stack[0].spec;
  const out: AttributeSpec = {
    kind,
    name,
    typeName,
    custom: stack.some(({ spec }) => spec.custom),
    uniform: stack.some(({ spec }) => spec.uniform),
    metadata: composeMetadata(stack.map((s) => ({ metadata: s.spec.metadata, place: s }))),
  };
  const fixed = stack.find(({ spec }) => spec.value && spec.value.type !== 'animationBlock');
  if (fixed) out.value = localValue(fixed.spec.value!, fixed);
  const animated = stack.find(({ spec }) => spec.value || isSampled(spec) || spec.spline !== undefined);
  if (animated && isSampled(animated.spec)) out.timeSamples = localSamples(animated.spec.timeSamples!, animated);
  else if (animated?.spec.spline !== undefined) out.spline = animated.spec.spline;
  const connections = composedPaths(stack.map((s) => ({ op: s.spec.connections, place: s })));
  if (connections) out.connections = connections;
  return out;
}

const isSampled = ({ timeSamples }: AttributeSpec): boolean =>
  timeSamples !== undefined && timeSamples.times.length > 0;

function composedRelationship(stack: readonly SaidProperty<RelationshipSpec>[]): RelationshipSpec {
  const { kind, name, uniform } = stack[0].spec;
  const metadata = composeMetadata(stack.map((s) => ({ metadata: s.spec.metadata, place: s })));
  const out: RelationshipSpec = { kind, name, custom: stack.some(({ spec }) => spec.custom), uniform, metadata };
  const targets = composedPaths(stack.map((s) => ({ op: s.spec.targets, place: s })));
  if (targets) out.targets = targets;
  return out;
}

/** Targets in the stage's namespace; those outside of what an arc maps are none. */
function composedPaths(said: readonly { op: ListOp<string> | undefined; place: Place }[]): ListOp<string> | undefined {
  const ops = said.flatMap(({ op, place }) => (op ? [mappedOp(op, place)] : []));
  return ops.length === 0 ? undefined : { explicit: composeList(ops, (path) => path) };
}

function mappedOp(op: ListOp<string>, { map }: Place): ListOp<string> {
  const mapped = mapOp(op, (path) => mapToTarget(map, path === '/' ? '' : path));
  const out: ListOp<string> = {};
  for (const [key, items] of Object.entries(mapped) as [keyof ListOp<string>, (string | undefined)[]][])
    out[key] = items.flatMap((path) => (path === undefined ? [] : [path || '/']));
  return out;
}
