import { msg } from '../../../messages/message.ts';
import {
  type AttributeSpec,
  EMPTY_MAP,
  type Layer,
  type PrimSpec,
  type PropertySpec,
  type RelationshipSpec,
  type Specifier,
  withEntry,
} from '../layer/layer.ts';
import { isPrimName, isPropertyName } from '../layer/paths.ts';
import { metadataOf } from './metadata.ts';
import { SPEC_TYPES, type SpecFields, type SpecReader } from './specReader.ts';
import type { CrateSource } from './structure/crateSource.ts';
import type { PathNode } from './structure/pathTree.ts';

export const SPECIFIERS: readonly Specifier[] = ['def', 'over', 'class'];
const BUILT_SPEC_TYPES: ReadonlySet<number> = new Set(Object.values(SPEC_TYPES));

/** Makes a layer of a crate's specs. Each must be where its parent lists it: none is left out in silence. */
export class LayerBuilder {
  private readonly reader: SpecReader;
  /** In the order of the file. */
  private readonly specs: readonly PathNode[];

  constructor(reader: SpecReader) {
    this.reader = reader;
    // Specs of single targets and connections say nothing that the lists of targets do not.
    this.specs = [...reader.specs()].filter((node) => BUILT_SPEC_TYPES.has(node.specType));
  }

  layer(): Layer {
    const { source } = this.reader;
    const root = this.specs.find((node) => !node.parent);
    if (root?.specType !== SPEC_TYPES.layer) return source.fail(msg`there is no spec of the layer itself`);
    root.isBuilt = true;
    const fields = this.reader.read(root);
    const children = fields.names('primChildren') ?? [];
    const rootOrder = fields.names('primOrder');
    const rootPrims = this.prims(new ChildPaths(source, root), children);
    const layer: Layer = { name: source.file, metadata: metadataOf(fields), rootPrims };
    if (rootOrder) layer.rootOrder = rootOrder;
    source.node = this.specs.find((node) => !node.isBuilt);
    if (source.node) source.fail(msg`there is a spec of this path, which is in no list of what is in its parent`);
    return layer;
  }

  private prims(siblings: ChildPaths, names: readonly string[]): ReadonlyMap<string, PrimSpec> {
    let prims: ReadonlyMap<string, PrimSpec> = EMPTY_MAP;
    for (const name of names) {
      const node = siblings.take(name, false, [SPEC_TYPES.prim]);
      if (!isPrimName(name)) this.reader.source.fail(msg`'${name}' is not a prim name`);
      const fields = this.reader.read(node);
      const specifier = SPECIFIERS[fields.choice('specifier') ?? 1];
      if (!specifier) fields.fail(msg`its specifier is not def, over or class`);
      prims = withEntry(prims, name, this.prim(node, name, specifier, fields.text('typeName') ?? '', fields));
    }
    return prims;
  }

  private prim(node: PathNode, name: string, specifier: Specifier, typeName: string, fields: SpecFields): PrimSpec {
    const children = fields.names('primChildren') ?? [];
    const properties = fields.names('properties') ?? [];
    const variantSets = fields.names('variantSetChildren') ?? [];
    const childOrder = fields.names('primOrder');
    const propertyOrder = fields.names('propertyOrder');
    const empty = { properties: EMPTY_MAP, children: EMPTY_MAP, variantSets: EMPTY_MAP };
    const prim: PrimSpec = { path: node.path, name, specifier, typeName, metadata: metadataOf(fields), ...empty };
    if (childOrder) prim.childOrder = childOrder;
    if (propertyOrder) prim.propertyOrder = propertyOrder;
    const siblings = new ChildPaths(this.reader.source, node);
    for (const property of properties)
      prim.properties = withEntry(prim.properties, property, this.property(siblings, property));
    for (const set of variantSets) {
      const variants = this.variants(siblings, set);
      if (variants.size > 0) prim.variantSets = withEntry(prim.variantSets, set, variants);
    }
    prim.children = this.prims(siblings, children);
    return prim;
  }

  private variants(siblings: ChildPaths, set: string): Map<string, PrimSpec> {
    const fields = this.reader.read(siblings.take(`{${set}=}`, false, [SPEC_TYPES.variantSet]));
    const names = fields.names('variantChildren') ?? [];
    return new Map(
      names.map((name) => {
        const node = siblings.take(`{${set}=${name}}`, false, [SPEC_TYPES.variant]);
        const own = this.reader.read(node);
        own.drop('specifier', 'typeName');
        return [name, this.prim(node, name, 'over', '', own)];
      }),
    );
  }

  private property(siblings: ChildPaths, name: string): PropertySpec {
    const node = siblings.take(name, true, [SPEC_TYPES.attribute, SPEC_TYPES.relationship]);
    if (!isPropertyName(name)) this.reader.source.fail(msg`'${name}' is not a property name`);
    const fields = this.reader.read(node);
    return node.specType === SPEC_TYPES.attribute ? attribute(name, fields) : relationship(name, fields);
  }
}

/** Fewer are looked through one by one. */
const MIN_MAPPED_CHILDREN = 12;

/** What lies directly below one path, to be found by its name. */
class ChildPaths {
  private readonly source: CrateSource;
  private readonly parent: PathNode;
  private readonly mapped: ReadonlyMap<string, PathNode> | undefined;

  constructor(source: CrateSource, parent: PathNode) {
    this.source = source;
    this.parent = parent;
    const { children } = parent;
    if (children.length >= MIN_MAPPED_CHILDREN) this.mapped = new Map(children.map((node) => [elementKey(node), node]));
  }

  /** The spec that the parent lists. */
  take(element: string, isProperty: boolean, types: readonly number[]): PathNode {
    const node = this.mapped
      ? this.mapped.get(isProperty ? `.${element}` : element)
      : this.parent.children.find((child) => child.element === element && child.isProperty === isProperty);
    if (!node || node.isBuilt || !types.includes(node.specType)) {
      this.source.node = this.parent;
      return this.source.fail(msg`it lists '${element}', of which there is no spec, or lists it twice`);
    }
    node.isBuilt = true;
    return node;
  }
}

/** Of a path among its siblings: a prim and a property may share a name. */
const elementKey = ({ element, isProperty }: PathNode): string => (isProperty ? `.${element}` : element);

/** How a property varies, by number: 0 varying, else uniform. */
export const UNIFORM = 1;

function attribute(name: string, fields: SpecFields): AttributeSpec {
  const typeName = fields.text('typeName') ?? fields.fail(msg`the attribute has no type`);
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

function relationship(name: string, fields: SpecFields): RelationshipSpec {
  const custom = fields.bool('custom') ?? false;
  const uniform = (fields.choice('variability') ?? 0) >= UNIFORM;
  const targets = fields.take('targetPaths', 'paths')?.op;
  fields.drop('targetChildren');
  return { kind: 'relationship', name, custom, uniform, metadata: metadataOf(fields), ...(targets ? { targets } : {}) };
}
