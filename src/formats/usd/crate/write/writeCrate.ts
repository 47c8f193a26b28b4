import { type Message, msg } from '../../../../messages/message.ts';
import { inputError } from '../../../diagnostics/inputError.ts';
import { type AttributeSpec, EMPTY_MAP, type Layer, type PrimSpec, type RelationshipSpec } from '../../layer/layer.ts';
import { variantPath } from '../../layer/primPaths.ts';
import { SPECIFIERS, UNIFORM } from '../layerBuilder.ts';
import { SPEC_TYPES } from '../specReader.ts';
import { HEADER_BYTES, IDENT, SECTION_NAME_BYTES, SECTIONS, type SectionName } from '../structure/bootstrap.ts';
import { NON_ARRAY_TYPES } from '../values/crateTypes.ts';
import { ByteSink } from './byteSink.ts';
import { packNames, packPaths } from './listOps.ts';
import { type PackedField, packMetadata } from './metadata.ts';
import { PathTable } from './pathTable.ts';
import { inlined } from './rep.ts';
import { SpecSections } from './specSections.ts';
import { packSpline } from './splines.ts';
import { TokenTable } from './tokenTable.ts';
import { ValuePacker } from './valuePacker.ts';
import { ValueStore } from './valueStore.ts';

/**
 * A layer as a binary USD file (a crate, OpenUSD sdf/crateFile.cpp), of version 0.8 or the earliest that has all that is in
 * it. The same layer gives the same bytes. Throws an InputError for what a crate cannot hold.
 */
export function writeCrate(layer: Layer): Uint8Array {
  const writer = new CrateWriter(layer.name);
  writer.layer(layer);
  return writer.file();
}

class CrateWriter {
  private readonly tokens: TokenTable;
  private readonly paths: PathTable;
  private readonly specs = new SpecSections();
  private readonly values = new ValueStore(HEADER_BYTES);
  private readonly packer: ValuePacker;
  /** Of the spec that is written, for messages. */
  private place = '';

  constructor(name: string) {
    const fail = (message: Message): never => {
      throw inputError(
        'usd.unwritable',
        `${name}${this.place && `<${this.place}>`}`,
        msg`${message}; write it as text, .usda`,
      );
    };
    this.tokens = new TokenTable(fail);
    this.paths = new PathTable(this.tokens, fail);
    this.packer = new ValuePacker(this.tokens, this.paths, this.values, fail);
  }

  layer({ metadata, rootPrims, rootOrder }: Layer): void {
    for (const [path, prim] of childrenOf('', rootPrims)) this.indexPaths(path, prim);
    this.spec('/', SPEC_TYPES.layer, () => [
      ...packMetadata(this.packer, metadata),
      ...this.names('primChildren', rootPrims),
      ...this.names('primOrder', rootOrder),
    ]);
    for (const [path, prim] of childrenOf('', rootPrims)) this.prim(path, prim, SPEC_TYPES.prim);
  }

  /** Paths get their indices in the order in which the tree is written: then these take no room. */
  private indexPaths(path: string, prim: PrimSpec): void {
    this.paths.index(path);
    for (const name of prim.properties.keys()) this.paths.index(`${path}.${name}`);
    for (const [set, variants] of variantSetsOf(prim)) {
      this.paths.index(variantPath(path, set, ''));
      for (const [name, variant] of variants) this.indexPaths(variantPath(path, set, name), variant);
    }
    for (const [childPath, child] of childrenOf(path, prim.children)) this.indexPaths(childPath, child);
  }

  private prim(path: string, prim: PrimSpec, specType: number): void {
    const { packer } = this;
    this.spec(path, specType, () => [
      ...this.primType(prim),
      ...packMetadata(packer, prim.metadata),
      ...this.names('variantSetChildren', variantSetsOf(prim)),
      ...this.names('primChildren', prim.children),
      ...this.names('properties', prim.properties),
      ...this.names('primOrder', prim.childOrder),
      ...this.names('propertyOrder', prim.propertyOrder),
    ]);
    for (const [name, property] of prim.properties) {
      if (property.kind === 'attribute')
        this.spec(`${path}.${name}`, SPEC_TYPES.attribute, () => this.attribute(property));
      else this.spec(`${path}.${name}`, SPEC_TYPES.relationship, () => this.relationship(property));
    }
    for (const [set, variants] of variantSetsOf(prim)) {
      this.spec(variantPath(path, set, ''), SPEC_TYPES.variantSet, () => this.names('variantChildren', variants));
      for (const [name, variant] of variants) this.prim(variantPath(path, set, name), variant, SPEC_TYPES.variant);
    }
    for (const [childPath, child] of childrenOf(path, prim.children)) this.prim(childPath, child, SPEC_TYPES.prim);
  }

  /** What is as it is without being said, is not said: `over`, no type. */
  private *primType({ specifier, typeName, metadata }: PrimSpec): Generator<PackedField> {
    if (metadata.has('relocates'))
      this.packer.fail(msg`relocates of a prim are no longer in USD; the layer can have them`);
    if (specifier !== 'over') yield ['specifier', inlined(NON_ARRAY_TYPES.specifier, SPECIFIERS.indexOf(specifier))];
    if (typeName !== '') yield ['typeName', this.packer.pack({ type: 'token', data: typeName })];
  }

  private *attribute(attribute: AttributeSpec): Generator<PackedField> {
    const { packer } = this;
    const { typeName, value, timeSamples, connections, spline } = attribute;
    yield ['typeName', packer.pack({ type: 'token', data: typeName })];
    yield* this.property(attribute);
    if (value) yield ['default', packer.pack(value)];
    if (timeSamples) yield ['timeSamples', packer.timeSamples(timeSamples)];
    if (spline) yield ['spline', packSpline(packer, spline, typeName)];
    if (connections) yield ['connectionPaths', packPaths(packer, connections)];
  }

  private *relationship(relationship: RelationshipSpec): Generator<PackedField> {
    yield* this.property(relationship);
    if (relationship.targets) yield ['targetPaths', packPaths(this.packer, relationship.targets)];
  }

  private *property({ custom, uniform, metadata }: AttributeSpec | RelationshipSpec): Generator<PackedField> {
    if (custom) yield ['custom', this.packer.pack({ type: 'bool', data: true })];
    if (uniform) yield ['variability', inlined(NON_ARRAY_TYPES.variability, UNIFORM)];
    yield* packMetadata(this.packer, metadata);
  }

  private *names(field: string, names: readonly string[] | ReadonlyMap<string, unknown> = []): Generator<PackedField> {
    const list = names instanceof Map ? [...names.keys()] : (names as readonly string[]);
    if (list.length > 0) yield [field, packNames(this.packer, list)];
  }

  private spec(path: string, specType: number, fields: () => Iterable<PackedField>): void {
    this.place = path;
    const packed = Array.from(fields(), ([name, rep]) => [this.tokens.index(name), rep] as const);
    this.specs.add(this.paths.index(path), specType, packed);
  }

  /** Header, values, the tables, and the table of contents. */
  file(): Uint8Array {
    const { tokens, paths, specs } = this;
    const values = this.values.bytes;
    const sink = new ByteSink(HEADER_BYTES + values.length);
    sink.append(new Uint8Array(HEADER_BYTES));
    sink.append(values);
    // Paths and fields add no tokens any more.
    const sections: Record<SectionName, (sink: ByteSink) => void> = {
      TOKENS: (out) => tokens.writeTokens(out),
      STRINGS: (out) => tokens.writeStrings(out),
      FIELDS: (out) => specs.writeFields(out),
      FIELDSETS: (out) => specs.writeFieldSets(out),
      PATHS: (out) => paths.write(out),
      SPECS: (out) => specs.writeSpecs(out),
    };
    const contents = SECTIONS.map((name) => {
      const start = sink.length;
      sections[name](sink);
      return { name, start, size: sink.length - start };
    });
    const contentsStart = sink.length;
    sink.u64(contents.length);
    for (const { name, start, size } of contents) {
      sink.append(ascii(name.padEnd(SECTION_NAME_BYTES, '\0')));
      sink.u64(start);
      sink.u64(size);
    }
    const header = new ByteSink();
    header.append(ascii(IDENT));
    header.append(Uint8Array.of(0, this.packer.version, 0, 0, 0, 0, 0, 0));
    header.u64(contentsStart);
    sink.bytes.set(header.bytes);
    return sink.bytes;
  }
}

const ascii = (text: string): Uint8Array => new TextEncoder().encode(text);

/** As OpenUSD has them: sets that are listed explicitly, or as added, are there without variants too. */
function variantSetsOf({ metadata, variantSets }: PrimSpec): PrimSpec['variantSets'] {
  const names = metadata.get('variantSets');
  if (names?.type !== 'texts') return variantSets;
  const { explicit = [], added = [] } = names.op;
  const listed = [...explicit, ...added].map((name) => [name, variantSets.get(name) ?? EMPTY_MAP] as const);
  return new Map([...listed, ...variantSets]);
}

/** The prims of a map with their paths: in a variant the parent's ends with its selection, /A{set=v}B. */
function* childrenOf(
  parent: string,
  children: ReadonlyMap<string, PrimSpec>,
): Generator<[path: string, prim: PrimSpec]> {
  const separator = parent.endsWith('}') ? '' : '/';
  for (const [name, prim] of children) yield [parent + separator + name, prim];
}
