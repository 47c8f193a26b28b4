import type { Value } from '../layer.ts';
import { ENTRY_BYTES, type FieldValue } from './kinds.ts';
import type { PathNode } from './paths.ts';
import { repOf } from './rep.ts';
import type { CrateSource } from './source.ts';
import type { Structure } from './structure.ts';
import { ValueReader } from './values.ts';

/** Kinds of specs by number (OpenUSD, SdfSpecType), those that a layer is made of. */
export const SPEC = { attribute: 1, prim: 6, layer: 7, relationship: 8, variant: 10, variantSet: 11 } as const;

export interface Spec {
  readonly node: PathNode;
  readonly type: number;
  /** Where its set of fields begins. */
  readonly fieldSet: number;
}

/** Finds specs by their place and reads their fields. */
export class SpecReader {
  readonly source: CrateSource;
  private readonly structure: Structure;
  private readonly values: ValueReader;

  constructor(source: CrateSource, structure: Structure) {
    this.source = source;
    this.structure = structure;
    this.values = new ValueReader(source, structure);
  }

  /** Every spec, in the order of the file. */
  *specs(): Generator<Spec> {
    const { source } = this;
    const { paths, specs } = this.structure;
    const seen = new Set<PathNode>();
    source.place = 'SPECS';
    for (let i = 0; i < specs.paths.length; i++) {
      const node = paths[specs.paths[i]];
      if (!node) return source.fail(`spec ${i} is of path ${specs.paths[i]}, which is none`);
      if (seen.has(node)) source.fail(`there are two specs of ${node.path}`);
      seen.add(node);
      yield { node, type: specs.types[i], fieldSet: specs.fieldSets[i] };
    }
  }

  read({ node, fieldSet }: Spec): Fields {
    const { source, values } = this;
    const { fieldSets, fields } = this.structure;
    source.place = node.path;
    const found = new Map<string, FieldValue>();
    for (let i = fieldSet; fieldSets[i] !== -1; i++) {
      const field = fieldSets[i];
      if (!(field >= 0 && field < fields.names.length))
        source.fail(`of its fields, from ${fieldSet} on, one is field ${field} of ${fields.names.length}`);
      source.spend(ENTRY_BYTES, 'a field');
      source.field = values.token(fields.names[field]);
      const rep = repOf(source, fields.values[2 * field], fields.values[2 * field + 1]);
      found.set(source.field, values.read(rep));
    }
    source.field = '';
    return new Fields(source, values, node.path, found);
  }
}

type FieldOf<K, F = FieldValue> = F extends { readonly type: infer T } ? (K extends T ? F : never) : never;

/** The fields of one spec, taken out one by one; what is left is metadata. */
export class Fields {
  private readonly source: CrateSource;
  private readonly values: ValueReader;
  private readonly path: string;
  private readonly map: Map<string, FieldValue>;

  constructor(source: CrateSource, values: ValueReader, path: string, map: Map<string, FieldValue>) {
    this.source = source;
    this.values = values;
    this.path = path;
    this.map = map;
  }

  /** Takes out a field of one kind; undefined where there is none. */
  take<K extends FieldValue['type']>(name: string, type: K): FieldOf<K> | undefined {
    const field = this.map.get(name);
    if (field === undefined) return undefined;
    this.map.delete(name);
    if (field.type !== type) return this.fail(`its ${name} is of kind ${field.type}, not ${type}`);
    return field as FieldOf<K>;
  }

  names = (name: string): readonly string[] | undefined => this.take(name, 'names')?.data;
  text = (name: string): string | undefined => this.take(name, 'token')?.data;
  bool = (name: string): boolean | undefined => this.take(name, 'bool')?.data;

  choice(name: 'specifier' | 'variability'): number | undefined {
    return this.take(name, name)?.data;
  }

  /** Takes out a field that holds a value. */
  value(name: string): Value | undefined {
    const field = this.map.get(name);
    this.map.delete(name);
    return field && this.values.plain(field);
  }

  drop(...names: readonly string[]): void {
    for (const name of names) this.map.delete(name);
  }

  rest(): Iterable<[string, FieldValue]> {
    return this.map;
  }

  fail(message: string): never {
    this.source.place = this.path;
    return this.source.fail(message);
  }
}
