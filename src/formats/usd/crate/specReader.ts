import { type Message, msg } from '../../../messages/message.ts';
import type { Value } from '../layer/layer.ts';
import type { CrateSource } from './structure/crateSource.ts';
import type { PathNode } from './structure/pathTree.ts';
import type { Structure } from './structure/structure.ts';
import { ENTRY_BYTES, type FieldValue } from './values/fieldValue.ts';
import { ValueReader } from './values/valueReader.ts';
import { ValueRep } from './values/valueRep.ts';

/** Kinds of specs by number (OpenUSD, SdfSpecType), those that a layer is made of. */
export const SPEC_TYPES = { attribute: 1, prim: 6, layer: 7, relationship: 8, variant: 10, variantSet: 11 } as const;

const A_FIELD = msg`a field`;

/** Finds specs by their paths and reads their fields. */
export class SpecReader {
  readonly source: CrateSource;
  private readonly structure: Structure;
  private readonly values: ValueReader;

  constructor(source: CrateSource, structure: Structure) {
    this.source = source;
    this.structure = structure;
    this.values = new ValueReader(source, structure);
  }

  /** Every path that has a spec, in the order of the file. */
  *specs(): Generator<PathNode> {
    const { source } = this;
    const { paths, specs } = this.structure;
    source.section = 'SPECS';
    for (let i = 0; i < specs.paths.length; i++) {
      const node = paths[specs.paths[i]];
      if (!node) return source.fail(msg`spec ${i} is of path ${specs.paths[i]}, which is none`);
      if (node.specType !== 0) source.fail(msg`there are two specs of ${node.path}`);
      node.specType = specs.types[i];
      node.fieldSet = specs.fieldSets[i];
      yield node;
    }
  }

  read(node: PathNode): SpecFields {
    const { source, values } = this;
    const { fieldSets, fields } = this.structure;
    const { fieldSet } = node;
    const found = new SpecFields(source, values, node);
    source.node = node;
    for (let i = fieldSet; fieldSets[i] !== -1; i++) {
      if (!(i >= 0 && i < fieldSets.length))
        source.fail(msg`its list of fields begins at ${fieldSet} of ${fieldSets.length} and has no end`);
      const field = fieldSets[i];
      source.field = '';
      if (!(field >= 0 && field < fields.names.length))
        source.fail(msg`of its fields, from ${fieldSet} on, one is field ${field} of ${fields.names.length}`);
      source.spend(ENTRY_BYTES, A_FIELD);
      source.field = values.token(fields.names[field]);
      found.add(
        source.field,
        values.read(new ValueRep(source, fields.values[2 * field], fields.values[2 * field + 1])),
      );
    }
    source.field = '';
    return found;
  }
}

type FieldOf<K, F = FieldValue> = F extends { readonly type: infer T } ? (K extends T ? F : never) : never;

/** The fields of one spec, taken out one by one; what is left is metadata. */
export class SpecFields {
  private readonly source: CrateSource;
  private readonly values: ValueReader;
  private readonly node: PathNode;
  private readonly keys: string[] = [];
  private readonly fields: (FieldValue | undefined)[] = [];

  constructor(source: CrateSource, values: ValueReader, node: PathNode) {
    this.source = source;
    this.values = values;
    this.node = node;
  }

  add(name: string, field: FieldValue): void {
    if (this.keys.includes(name)) this.source.fail(msg`it has this field twice`);
    this.keys.push(name);
    this.fields.push(field);
  }

  private takeOut(name: string): FieldValue | undefined {
    const i = this.keys.indexOf(name);
    if (i < 0) return undefined;
    const field = this.fields[i];
    this.fields[i] = undefined;
    return field;
  }

  /** Takes out a field of one kind; undefined where there is none. */
  take<K extends FieldValue['type']>(name: string, type: K): FieldOf<K> | undefined {
    const field = this.takeOut(name);
    if (field && field.type !== type) return this.fail(msg`its ${name} is of kind ${field.type}, not ${type}`);
    return field as FieldOf<K> | undefined;
  }

  names(name: string): readonly string[] | undefined {
    return this.take(name, 'names')?.data;
  }

  text(name: string): string | undefined {
    return this.take(name, 'token')?.data;
  }

  bool(name: string): boolean | undefined {
    return this.take(name, 'bool')?.data;
  }

  choice(name: 'specifier' | 'variability'): number | undefined {
    return this.take(name, name)?.data;
  }

  /** Takes out a field that holds a value. */
  value(name: string): Value | undefined {
    const field = this.takeOut(name);
    return field && this.values.plain(field);
  }

  drop(...names: readonly string[]): void {
    for (const name of names) this.takeOut(name);
  }

  /** Passes on what is left. */
  forEachRemaining(use: (name: string, field: FieldValue) => void): void {
    for (let i = 0; i < this.keys.length; i++) {
      const field = this.fields[i];
      if (field) use(this.keys[i], field);
    }
  }

  fail(message: Message): never {
    this.source.node = this.node;
    return this.source.fail(message);
  }
}
