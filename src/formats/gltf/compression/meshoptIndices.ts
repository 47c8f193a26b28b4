import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { ByteReader, unzigzag } from './meshoptBytes.ts';

/** The index codecs of EXT_meshopt_compression (appendix A, modes 1 and 2). Both throw an Error that names the byte where the data is damaged. */

/** A ring buffer of recent numbers, newest at 0; its length is a power of two. */
class RecentQueue {
  private readonly held: Uint32Array;
  private next = 0;
  constructor(size: number) {
    this.held = new Uint32Array(size);
  }
  at(back: number): number {
    return this.held[(this.next - 1 - back) & (this.held.length - 1)];
  }
  push(...numbers: readonly number[]): void {
    for (const n of numbers) {
      this.held[this.next] = n;
      this.next = (this.next + 1) & (this.held.length - 1);
    }
  }
}

const TRIANGLES = 0xe1;
const SEQUENCE = 0xd1;
/** Size of the table of frequent corner code pairs at the end of a triangle stream [bytes]. */
const PAIR_TABLE = 16;
const SEQUENCE_TAIL = 4;
const NO_EDGE = 15;
const EXPLICIT = 15;

/** Mode 1: corners of triangles, three by three; `count` of them. */
export function decodeTriangles(data: Uint8Array, count: number): Uint32Array {
  const triangles = count / 3;
  if (data[0] !== TRIANGLES) throw new MessageError(msg`begins with byte ${data[0]}, not with ${TRIANGLES}`);
  if (data.length < 1 + triangles + PAIR_TABLE) {
    throw new MessageError(msg`has ${data.length} bytes, too few for ${triangles} triangles`);
  }
  const decoder = new TriangleDecoder(data, triangles);
  const out = new Uint32Array(count);
  for (let i = 0; i < triangles; i++) out.set(decoder.triangle(data[1 + i]), 3 * i);
  return out;
}

/** Triangles encoded by recent edges or vertices. */
class TriangleDecoder {
  private readonly reader: ByteReader;
  private readonly pairs: Uint8Array;
  /** Two numbers per edge. */
  private readonly edges = new RecentQueue(32);
  private readonly corners = new RecentQueue(16);
  /** The next new vertex. */
  private next = 0;
  /** The last vertex encoded explicitly. */
  private last = 0;
  constructor(data: Uint8Array, triangles: number) {
    this.reader = new ByteReader(data, 1 + triangles, data.length - PAIR_TABLE);
    this.pairs = data.subarray(data.length - PAIR_TABLE);
  }

  triangle(code: number): readonly [number, number, number] {
    const [edge, corner] = [code >> 4, code & 15];
    return edge === NO_EDGE ? this.fresh(corner) : this.onEdge(edge, corner);
  }

  private onEdge(edge: number, code: number): readonly [number, number, number] {
    const [a, b] = [this.edges.at(2 * edge), this.edges.at(2 * edge + 1)];
    const c = this.third(code);
    if (code === 0 || code > 12) this.corners.push(c);
    this.edges.push(b, c, c, a);
    return [a, b, c];
  }

  private third(code: number): number {
    if (code === 0) return this.next++;
    if (code < 13) return this.corners.at(code);
    if (code === EXPLICIT) return this.explicit();
    this.last = (this.last + (code === 13 ? -1 : 1)) >>> 0;
    return this.last;
  }

  private fresh(code: number): readonly [number, number, number] {
    const isTabled = code < 14;
    const pair = isTabled ? this.pairs[code] : this.reader.byte();
    if (!isTabled && pair === 0) this.next = 0;
    const a = code === EXPLICIT ? this.explicit() : this.next++;
    const [codeB, codeC] = [pair >> 4, pair & 15];
    const b = this.corner(codeB, isTabled);
    const c = this.corner(codeC, isTabled);
    const isNew = (n: number): boolean => n === 0 || (n === EXPLICIT && !isTabled);
    this.corners.push(a);
    if (isNew(codeB)) this.corners.push(b);
    if (isNew(codeC)) this.corners.push(c);
    this.edges.push(a, b, b, c, c, a);
    return [a, b, c];
  }

  private corner(code: number, isTabled: boolean): number {
    if (code === 0) return this.next++;
    return code === EXPLICIT && !isTabled ? this.explicit() : this.corners.at(code - 1);
  }

  private explicit(): number {
    this.last = (this.last + unzigzag(this.reader.varint())) >>> 0;
    return this.last;
  }
}

/** Mode 2: `count` arbitrary indices, delta encoded against one of two baselines. */
export function decodeSequence(data: Uint8Array, count: number): Uint32Array {
  if (data[0] !== SEQUENCE) throw new MessageError(msg`begins with byte ${data[0]}, not with ${SEQUENCE}`);
  if (data.length < 1 + count + SEQUENCE_TAIL)
    throw new MessageError(msg`has ${data.length} bytes, too few for ${count} indices`);
  const reader = new ByteReader(data, 1, data.length - SEQUENCE_TAIL);
  const last = [0, 0];
  const out = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    const code = reader.varint();
    const which = code & 1;
    last[which] = (last[which] + unzigzag(code >>> 1)) >>> 0;
    out[i] = last[which];
  }
  return out;
}
