import type { ByteSink } from './byteSink.ts';
import { writeInt32s, writeSized } from './integers.ts';
import { compress } from './lz4.ts';

/** Ends a set of fields. */
const END = -1;

/** Specs, the sets of their fields, and the fields, each set and field once. */
export class SpecSections {
  private readonly fields = new Map<string, number>();
  private readonly names: number[] = [];
  private readonly reps: bigint[] = [];
  private readonly sets = new Map<string, number>();
  private readonly setItems: number[] = [];
  private readonly paths: number[] = [];
  private readonly setStarts: number[] = [];
  private readonly types: number[] = [];

  /** `fields`: of each the token of its name, and its value's representation. */
  add(path: number, type: number, fields: readonly (readonly [name: number, rep: bigint])[]): void {
    this.paths.push(path);
    this.types.push(type);
    this.setStarts.push(this.setStart(fields.map(([name, rep]) => this.field(name, rep))));
  }

  private field(name: number, rep: bigint): number {
    const key = `${name} ${rep}`;
    const known = this.fields.get(key);
    if (known !== undefined) return known;
    this.fields.set(key, this.names.length);
    this.names.push(name);
    return this.reps.push(rep) - 1;
  }

  private setStart(items: readonly number[]): number {
    const key = items.join();
    const known = this.sets.get(key);
    if (known !== undefined) return known;
    const start = this.setItems.length;
    this.sets.set(key, start);
    for (const item of items) this.setItems.push(item);
    this.setItems.push(END);
    return start;
  }

  writeFields(sink: ByteSink): void {
    sink.u64(this.names.length);
    writeInt32s(sink, this.names);
    writeSized(sink, compress(new Uint8Array(BigUint64Array.from(this.reps).buffer)));
  }

  writeFieldSets(sink: ByteSink): void {
    sink.u64(this.setItems.length);
    writeInt32s(sink, this.setItems);
  }

  writeSpecs(sink: ByteSink): void {
    sink.u64(this.paths.length);
    for (const column of [this.paths, this.setStarts, this.types]) writeInt32s(sink, column);
  }
}
