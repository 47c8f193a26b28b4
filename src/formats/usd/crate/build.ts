import {
  type AttributeSpec,
  type Layer,
  NOTHING,
  type PrimSpec,
  type PropertySpec,
  type RelationshipSpec,
  type Specifier,
  withEntry,
} from '../layer.ts';
import { isPrimName, isPropertyName } from '../paths.ts';
import { type Fields, SPEC, type SpecReader } from './fields.ts';
import { metadataOf } from './metadata.ts';
import type { PathNode } from './paths.ts';
import type { CrateSource } from './source.ts';

const SPECIFIERS: readonly Specifier[] = ['def', 'over', 'class'];
const BUILT: ReadonlySet<number> = new Set(Object.values(SPEC));

/** Makes a layer of a crate's specs. Each must be where its parent lists it: none is left out in silence. */
export class LayerBuilder {
  private readonly reader: SpecReader;
  /** In the order of the file. */
  private readonly specs: readonly PathNode[];

  constructor(reader: SpecReader) {
    this.reader = reader;
    // Specs of single targets and connections say nothing that the lists of targets do not.
    this.specs = [...reader.specs()].filter((node) => BUILT.has(node.specType));
  }

  layer(): Layer {
    const { source } = this.reader;
    const root = this.specs.find((node) => !node.parent);
    if (root?.specType !== SPEC.layer) return source.fail('there is no spec of the layer itself');
    root.isBuilt = true;
    const fields = this.reader.read(root);
    const children = fields.names('primChildren') ?? [];
    const rootOrder = fields.names('primOrder');
    const rootPrims = this.prims(new Siblings(source, root), children);
    const layer: Layer = { name: source.file, metadata: metadataOf(fields), rootPrims };
    if (rootOrder) layer.rootOrder = rootOrder;
    source.node = this.specs.find((node) => !node.isBuilt);
    if (source.node) source.fail('there is a spec of this path, which is in no list of what is in its parent');
    return layer;
  }

  private prims(siblings: Siblings, names: readonly string[]): ReadonlyMap<string, PrimSpec> {
    let prims: ReadonlyMap<string, PrimSpec> = NOTHING;
    for (const name of names) {
      const node = siblings.take(name, false, [SPEC.prim]);
      if (!isPrimName(name)) this.reader.source.fail(`'${name}' is not a prim name`);
      const fields = this.reader.read(node);
      const specifier = SPECIFIERS[fields.choice('specifier') ?? 1];
      if (!specifier) fields.fail(`its specifier is not def, over or class`);
      prims = withEntry(prims, name, this.prim(node, name, specifier, fields.text('typeName') ?? '', fields));
    }
    return prims;
  }

  private prim(node: PathNode, name: string, specifier: Specifier, typeName: string, fields: Fields): PrimSpec {
    const children = fields.names('primChildren') ?? [];
    const properties = fields.names('properties') ?? [];
    const variantSets = fields.names('variantSetChildren') ?? [];
    const childOrder = fields.names('primOrder');
    const propertyOrder = fields.names('propertyOrder');
    const empty = { properties: NOTHING, children: NOTHING, variantSets: NOTHING };
    const prim: PrimSpec = { path: node.path, name, specifier, typeName, metadata: metadataOf(fields), ...empty };
    if (childOrder) prim.childOrder = childOrder;
    if (propertyOrder) prim.propertyOrder = propertyOrder;
    const siblings = new Siblings(this.reader.source, node);
    for (const property of properties)
      prim.properties = withEntry(prim.properties, property, this.property(siblings, property));
    for (const set of variantSets) {
      const variants = this.variants(siblings, set);
      if (variants.size > 0) prim.variantSets = withEntry(prim.variantSets, set, variants);
    }
    prim.children = this.prims(siblings, children);
    return prim;
  }

  private variants(siblings: Siblings, set: string): Map<string, PrimSpec> {
    const fields = this.reader.read(siblings.take(`{${set}=}`, false, [SPEC.variantSet]));
    const names = fields.names('variantChildren') ?? [];
    return new Map(
      names.map((name) => {
        const node = siblings.take(`{${set}=${name}}`, false, [SPEC.variant]);
        const own = this.reader.read(node);
        own.drop('specifier', 'typeName');
        return [name, this.prim(node, name, 'over', '', own)];
      }),
    );
  }

  private property(siblings: Siblings, name: string): PropertySpec {
    const node = siblings.take(name, true, [SPEC.attribute, SPEC.relationship]);
    if (!isPropertyName(name)) this.reader.source.fail(`'${name}' is not a property name`);
    const fields = this.reader.read(node);
    return node.specType === SPEC.attribute ? attribute(name, fields) : relationship(name, fields);
  }
}

/** Fewer are looked through one by one. */
const LEAST_MAPPED = 12;

/** What lies directly below one path, to be found by its name. */
class Siblings {
  private readonly source: CrateSource;
  private readonly parent: PathNode;
  private readonly mapped: ReadonlyMap<string, PathNode> | undefined;

  constructor(source: CrateSource, parent: PathNode) {
    this.source = source;
    this.parent = parent;
    const { children } = parent;
    if (children.length >= LEAST_MAPPED) this.mapped = new Map(children.map((node) => [keyOf(node), node]));
  }

  /** The spec that the parent lists. */
  take(element: string, isProperty: boolean, types: readonly number[]): PathNode {
    const node = this.mapped
      ? this.mapped.get(isProperty ? `.${element}` : element)
      : this.parent.children.find((child) => child.element === element && child.isProperty === isProperty);
    if (!node || node.isBuilt || !types.includes(node.specType)) {
      this.source.node = this.parent;
      return this.source.fail(`it lists '${element}', of which there is no spec, or lists it twice`);
    }
    node.isBuilt = true;
    return node;
  }
}

/** Of a path among its siblings: a prim and a property may share a name. */
const keyOf = ({ element, isProperty }: PathNode): string => (isProperty ? `.${element}` : element);

/** How a property varies, by number: 0 varying, else uniform. */
const UNIFORM = 1;

function attribute(name: string, fields: Fields): AttributeSpec {
  const typeName = fields.text('typeName') ?? fields.fail('the attribute has no type');
  const custom = fields.bool('custom') ?? false;
  const uniform = (fields.choice('variability') ?? 0) >= UNIFORM;
  const value = fields.value('default');
  const timeSamples = fields.take('timeSamples', 'timeSamples')?.data;
  const connections = fields.take('connectionPaths', 'paths')?.op;
  const spline = fields.take('spline', 'spline')?.data;
  fields.drop('connectionChildren');
  return {
    kind: 'attribute',
    name,
    typeName,
    custom,
    uniform,
    metadata: metadataOf(fields),
    ...(value ? { value } : {}),
    ...(timeSamples ? { timeSamples } : {}),
    ...(connections ? { connections } : {}),
    ...(spline ? { spline } : {}),
  };
}

function relationship(name: string, fields: Fields): RelationshipSpec {
  const custom = fields.bool('custom') ?? false;
  const uniform = (fields.choice('variability') ?? UNIFORM) >= UNIFORM;
  const targets = fields.take('targetPaths', 'paths')?.op;
  fields.drop('targetChildren');
  return { kind: 'relationship', name, custom, uniform, metadata: metadataOf(fields), ...(targets ? { targets } : {}) };
}
