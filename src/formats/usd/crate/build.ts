import type { AttributeSpec, Layer, PrimSpec, PropertySpec, RelationshipSpec, Specifier } from '../layer.ts';
import { isPrimName, isPropertyName } from '../paths.ts';
import { type Fields, SPEC, type Spec, type SpecReader } from './fields.ts';
import { metadataOf } from './metadata.ts';
import type { PathNode } from './paths.ts';

const SPECIFIERS: readonly Specifier[] = ['def', 'over', 'class'];
const BUILT: ReadonlySet<number> = new Set(Object.values(SPEC));

/** Makes a layer of a crate's specs. Each must be where its parent lists it: none is left out in silence. */
export class LayerBuilder {
  private readonly reader: SpecReader;
  /** What lies directly below a path, by its key there; what is built is taken out. */
  private readonly below = new Map<PathNode, Map<string, Spec>>();
  private root: Spec | undefined;

  constructor(reader: SpecReader) {
    this.reader = reader;
    for (const spec of reader.specs()) {
      const { parent } = spec.node;
      // Specs of single targets and connections say nothing that the lists of targets do not.
      if (!BUILT.has(spec.type)) continue;
      if (!parent) this.root = spec;
      else this.siblings(parent).set(keyOf(spec.node), spec);
    }
  }

  private siblings(parent: PathNode): Map<string, Spec> {
    const siblings = this.below.get(parent) ?? new Map<string, Spec>();
    this.below.set(parent, siblings);
    return siblings;
  }

  layer(): Layer {
    const { source } = this.reader;
    if (this.root?.type !== SPEC.layer) return source.fail('there is no spec of the layer itself');
    const fields = this.reader.read(this.root);
    const children = fields.names('primChildren') ?? [];
    const rootOrder = fields.names('primOrder');
    const layer: Layer = { name: source.file, metadata: metadataOf(fields), rootPrims: new Map() };
    if (rootOrder) layer.rootOrder = rootOrder;
    this.addPrims(this.root.node, children, layer.rootPrims);
    this.checkNothingIsLeft();
    return layer;
  }

  private checkNothingIsLeft(): void {
    for (const specs of this.below.values())
      for (const { node } of specs.values()) {
        this.reader.source.place = node.path;
        this.reader.source.fail('there is a spec of this path, which is in no list of what is in its parent');
      }
  }

  /** The spec that a parent lists. */
  private take(parent: PathNode, key: string, types: readonly number[]): Spec {
    const { source } = this.reader;
    const specs = this.below.get(parent);
    const spec = specs?.get(key);
    source.place = parent.path;
    if (!spec || !types.includes(spec.type)) return source.fail(`it lists '${key}' once more than there is one`);
    specs!.delete(key);
    return spec;
  }

  private addPrims(parent: PathNode, names: readonly string[], into: Map<string, PrimSpec>): void {
    for (const name of names) {
      const spec = this.take(parent, name, [SPEC.prim]);
      if (!isPrimName(name)) this.reader.source.fail(`'${name}' is not a prim name`);
      const fields = this.reader.read(spec);
      const specifier = SPECIFIERS[fields.choice('specifier') ?? 1];
      if (!specifier) fields.fail(`its specifier is not def, over or class`);
      into.set(name, this.prim(spec.node, name, specifier, fields.text('typeName') ?? '', fields));
    }
  }

  private prim(node: PathNode, name: string, specifier: Specifier, typeName: string, fields: Fields): PrimSpec {
    const children = fields.names('primChildren') ?? [];
    const properties = fields.names('properties') ?? [];
    const variantSets = fields.names('variantSetChildren') ?? [];
    const childOrder = fields.names('primOrder');
    const propertyOrder = fields.names('propertyOrder');
    const empty = { properties: new Map(), children: new Map(), variantSets: new Map() };
    const prim: PrimSpec = { path: node.path, name, specifier, typeName, metadata: metadataOf(fields), ...empty };
    if (childOrder) prim.childOrder = childOrder;
    if (propertyOrder) prim.propertyOrder = propertyOrder;
    for (const property of properties) prim.properties.set(property, this.property(node, property));
    for (const set of variantSets) {
      const variants = this.variants(node, set);
      if (variants.size > 0) prim.variantSets.set(set, variants);
    }
    this.addPrims(node, children, prim.children);
    return prim;
  }

  private variants(parent: PathNode, set: string): Map<string, PrimSpec> {
    const fields = this.reader.read(this.take(parent, `{${set}=}`, [SPEC.variantSet]));
    const names = fields.names('variantChildren') ?? [];
    return new Map(
      names.map((name) => {
        const spec = this.take(parent, `{${set}=${name}}`, [SPEC.variant]);
        const own = this.reader.read(spec);
        own.drop('specifier', 'typeName');
        return [name, this.prim(spec.node, name, 'over', '', own)];
      }),
    );
  }

  private property(parent: PathNode, name: string): PropertySpec {
    const spec = this.take(parent, `.${name}`, [SPEC.attribute, SPEC.relationship]);
    if (!isPropertyName(name)) this.reader.source.fail(`'${name}' is not a property name`);
    const fields = this.reader.read(spec);
    return spec.type === SPEC.attribute ? attribute(name, fields) : relationship(name, fields);
  }
}

/** Of a path among its siblings: prims, properties and variants of one prim may share a name. */
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
