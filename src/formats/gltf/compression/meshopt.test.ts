import fc from 'fast-check';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import { beforeAll, describe, expect, it } from 'vitest';
import { random } from '../../../math/random.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { checkMeshopt, decodeMeshopt } from './meshopt.ts';

/** Compared with the authors' own encoder and decoder (WebAssembly). */
beforeAll(() => Promise.all([MeshoptEncoder.ready, MeshoptDecoder.ready]));

const sameBytes = (a: Uint8Array, b: Uint8Array): boolean => Buffer.compare(a, b) === 0;

/** Elements whose neighbours share some bytes, as in meshes. */
const elements = fc
  .record({
    stride: fc.integer({ min: 1, max: 64 }).map((n) => 4 * n),
    count: fc.integer({ min: 1, max: 700 }),
    seed: fc.integer(),
  })
  .map(({ stride, count, seed }) => {
    const next = random(seed);
    const spread = Array.from({ length: stride }, () => [0, 1, 3, 10, 255][Math.floor(next() * 5)]);
    const bytes = new Uint8Array(stride * count);
    for (let i = stride; i < bytes.length; i++) {
      const isJump = next() < 0.02;
      bytes[i] = bytes[i - stride] + (isJump ? next() * 256 : (next() - 0.5) * 2 * spread[i % stride]);
    }
    return { bytes, stride, count };
  });

describe('the codecs of meshopt', () => {
  it.each([0, 1])('decode attributes of version %i, level 0 to 3', (version) => {
    fc.assert(
      fc.property(elements, fc.integer({ min: 0, max: 3 }), ({ bytes, stride, count }, level) => {
        const packed = MeshoptEncoder.encodeVertexBufferLevel(bytes, count, stride, level, version);
        expect(sameBytes(decodeMeshopt(packed, { count, byteStride: stride, mode: 'ATTRIBUTES' }), bytes)).toBe(true);
      }),
      { numRuns: 60 },
    );
  });

  it('decode neighbouring floats, which version 1 encodes by exclusive or', () => {
    const floats = Float32Array.from({ length: 3 * 5000 }, (_, i) => Math.sin(i / 500) * (1 + (i % 3)));
    const bytes = new Uint8Array(floats.buffer);
    const packed = MeshoptEncoder.encodeVertexBufferLevel(bytes, 5000, 12, 3, 1);
    expect(decodeMeshopt(packed, { count: 5000, byteStride: 12, mode: 'ATTRIBUTES' })).toEqual(bytes);
  });

  it('decode triangles and index sequences like the authors’ decoder', () => {
    const grids = fc.record({ n: fc.integer({ min: 1, max: 30 }), seed: fc.integer(), stride: fc.constantFrom(2, 4) });
    fc.assert(
      fc.property(grids, ({ n, seed, stride }) => {
        const indices = shuffledGrid(n, random(seed));
        const own = stride === 2 ? Uint16Array.from(indices) : Uint32Array.from(indices);
        const bytes = new Uint8Array(own.buffer);
        for (const mode of ['TRIANGLES', 'INDICES']) {
          const packed = MeshoptEncoder.encodeGltfBuffer(bytes, own.length, stride, mode);
          const expected = new Uint8Array(bytes.length);
          MeshoptDecoder.decodeGltfBuffer(expected, own.length, stride, packed, mode);
          const got = decodeMeshopt(packed, { count: own.length, byteStride: stride, mode });
          expect(sameBytes(got, expected)).toBe(true);
        }
      }),
      { numRuns: 60 },
    );
  });

  it.each([
    ['OCTAHEDRAL', 4, Int8Array, (v: Float32Array) => MeshoptEncoder.encodeFilterOct(v, v.length / 4, 4, 8)],
    ['OCTAHEDRAL', 8, Int16Array, (v: Float32Array) => MeshoptEncoder.encodeFilterOct(v, v.length / 4, 8, 14)],
    ['QUATERNION', 8, Int16Array, (v: Float32Array) => MeshoptEncoder.encodeFilterQuat(v, v.length / 4, 8, 16)],
    ['EXPONENTIAL', 16, Float32Array, (v: Float32Array) => MeshoptEncoder.encodeFilterExp(v, v.length / 4, 16, 20)],
    [
      'COLOR',
      4,
      Uint8Array,
      (v: Float32Array) => MeshoptEncoder.encodeFilterColor(v.map(Math.abs), v.length / 4, 4, 8),
    ],
    [
      'COLOR',
      8,
      Uint16Array,
      (v: Float32Array) => MeshoptEncoder.encodeFilterColor(v.map(Math.abs), v.length / 4, 8, 12),
    ],
  ])('undo the filter %s of %i bytes', (filter, stride, Numbers, encode) => {
    const next = random(3);
    const count = 500;
    const values = new Float32Array(4 * count);
    for (let i = 0; i < values.length; i += 4) {
      const v = [next() - 0.5, next() - 0.5, next() - 0.5, filter === 'OCTAHEDRAL' ? 0 : next() - 0.5];
      const size = Math.hypot(...v);
      values.set(
        v.map((x) => x / size),
        i,
      );
    }
    const packed = MeshoptEncoder.encodeGltfBuffer(encode(values), count, stride, 'ATTRIBUTES');
    const expected = new Uint8Array(count * stride);
    MeshoptDecoder.decodeGltfBuffer(expected, count, stride, packed, 'ATTRIBUTES', filter);
    const got = decodeMeshopt(packed, { count, byteStride: stride, mode: 'ATTRIBUTES', filter });
    // The authors compute in single precision, so a value between two steps may be rounded to either.
    const [numbers, wanted] = [got, expected].map(({ buffer }) => Array.from(new Numbers(buffer)));
    const worst = numbers.reduce((most, x, i) => Math.max(most, Math.abs(x - wanted[i])), 0);
    expect(worst).toBeLessThanOrEqual(filter === 'EXPONENTIAL' ? 0 : 1);
    const differing = numbers.filter((x, i) => x !== wanted[i]).length;
    expect(differing).toBeLessThan(numbers.length / 100);
  });

  it('report undecodable data', () => {
    const part = { count: 4, byteStride: 4, mode: 'ATTRIBUTES' };
    const packed = MeshoptEncoder.encodeGltfBuffer(new Uint8Array(16), 4, 4, 'ATTRIBUTES');
    expect(() => decodeMeshopt(packed.subarray(1), part)).toThrow('begins with byte');
    expect(() => decodeMeshopt(packed.subarray(0, 20), part)).toThrow('of 20 bytes is shorter than its own end');
    expect(() => decodeMeshopt(packed, { ...part, count: 2000 })).toThrow(/wants \d+ more bytes at byte \d+/);
    expect(() => checkMeshopt({ ...part, mode: 'X' }, 99)).toThrow('has the unknown mode X');
    expect(() => checkMeshopt({ ...part, filter: 'X' }, 99)).toThrow('has the unknown filter X');
    expect(() => checkMeshopt({ ...part, byteStride: 6 }, 99)).toThrow('elements of 6 bytes in mode ATTRIBUTES');
    expect(() => checkMeshopt({ ...part, filter: 'QUATERNION' }, 99)).toThrow('of 4 bytes with filter QUATERNION');
    expect(() => checkMeshopt({ ...part, count: 1e9 }, 99)).toThrow('claims 1000000000 elements in 99 bytes');
    expect(() => checkMeshopt({ ...part, mode: 'TRIANGLES' }, 99)).toThrow('4 corners of triangles');
  });

  it('return or throw an Error for any damaged data', () => {
    const next = random(11);
    for (const mode of ['ATTRIBUTES', 'TRIANGLES', 'INDICES']) {
      const bytes = new Uint8Array(Uint32Array.from(shuffledGrid(6, next)).buffer);
      const part = { count: bytes.length / 4, byteStride: 4, mode };
      const packed = MeshoptEncoder.encodeGltfBuffer(bytes, part.count, 4, mode);
      for (let n = 0; n < 300; n++) {
        const at = Math.floor(next() * packed.length);
        const damaged = packed.with(at, packed[at] ^ (1 << Math.floor(next() * 8)));
        try {
          expect(decodeMeshopt(damaged, part).length).toBe(bytes.length);
        } catch (thrown) {
          expect(thrown).toBeInstanceOf(MessageError);
        }
      }
    }
  });
});

/** Triangles of a grid of n² squares, partly shuffled. */
function shuffledGrid(n: number, next: () => number): number[] {
  const triangles: number[][] = [];
  for (let y = 0; y < n; y++) {
    for (let x = 0; x < n; x++) {
      const a = y * (n + 1) + x;
      triangles.push([a, a + 1, a + n + 1], [a + 1, a + n + 2, a + n + 1]);
    }
  }
  for (let i = 0; i < triangles.length; i++) {
    const j = Math.floor(next() * triangles.length);
    if (next() < 0.1) [triangles[i], triangles[j]] = [triangles[j], triangles[i]];
  }
  return triangles.flat();
}
