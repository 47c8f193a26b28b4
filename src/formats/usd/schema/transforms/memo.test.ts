import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import type { Scene } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import type { ReadOptions } from '../../../readOptions.ts';
import { readUsd } from '../../read.ts';
import { Memo } from './memo.ts';

describe('a memoized value', () => {
  it('is reused for the same keys only', () => {
    const once = new Memo<object>();
    const [a, b] = [{}, {}];
    const made = (...things: readonly unknown[]): object => once.getOrCreate(a, things, () => ({}));
    expect(made(b, 1)).toBe(made(b, 1));
    for (const other of [made(b), made(b, 2), made(a, 1), made(1, b), once.getOrCreate(b, [b, 1], () => ({}))])
      expect(other).not.toBe(made(b, 1));
  });

  it('may be undefined', () => {
    const make = vi.fn(() => undefined);
    const once = new Memo<undefined>();
    const owner = {};
    expect([once.getOrCreate(owner, [], make), once.getOrCreate(owner, [], make)]).toEqual([undefined, undefined]);
    expect(make).toHaveBeenCalledTimes(1);
  });
});

/** The reader with a `Memo` that never reuses a value. */
async function forgetful(): Promise<typeof readUsd> {
  vi.resetModules();
  vi.doMock('./memo.ts', () => ({
    Memo: class {
      getOrCreate<V>(_owner: object, _things: readonly unknown[], make: () => V): V {
        return make();
      }
    },
  }));
  const { readUsd: read } = await import('../../read.ts');
  vi.doUnmock('./memo.ts');
  return read;
}
const unshared = await forgetful();

const samplesOf = (values: readonly string[]): string => values.map((value, i) => `${i}: ${value}`).join(', ');
const op = (type: string, kind: string, values: readonly string[]): string =>
  `${type} xformOp:${kind}.timeSamples = { ${samplesOf(values)} }\nuniform token[] xformOpOrder = ["xformOp:${kind}"]\n`;

const number = fc.integer({ min: -9, max: 9 });
const vector = fc.tuple(number, number, number).map((v) => `(${v.join(', ')})`);
const sheared = fc
  .tuple(number, number)
  .map(([a, b]) => `((1, ${a}, 0, 0), (0, 1, 0, 0), (0, ${b}, 2, 0), (${b}, 0, ${a}, 1))`);
const few = { minLength: 2, maxLength: 4 };
const moving = fc.oneof(
  fc.array(vector, few).map((values) => op('double3', 'translate', values)),
  fc.array(number.map(String), few).map((values) => op('double', 'rotateX', values)),
  fc.array(vector, few).map((values) => op('double3', 'scale', values)),
  fc.array(sheared, few).map((values) => op('matrix4d', 'transform', values)),
);
const POINTS = '[(0, 0, 0), (1, 0, 0), (0, 1, 0)]';
const MESH = `int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2]\npoint3f[] points = ${POINTS}\n`;
const BENDING = `point3f[] points.timeSamples = { 0: ${POINTS}, 3: [(0, 0, 1), (1, 0, 0), (0, 3, 0)] }\n`;
const MOVED = 'double3 xformOp:translate = (1, 2, 3)\nuniform token[] xformOpOrder = ["xformOp:translate"]\n';
const kinds = [
  ['Cube', ''],
  ['Camera', ''],
  ['RectLight', ''],
  ['Mesh', MESH],
  ['Mesh', MESH + BENDING],
] as const;
const things = fc.array(fc.tuple(fc.constantFrom(...kinds), fc.constantFrom('', MOVED)), {
  minLength: 2,
  maxLength: 5,
});
const stage = fc.tuple(moving, fc.option(moving), things, fc.constantFrom(1, 0.01)).map(([outer, inner, all, unit]) => {
  const children = all.map(([[type, body], own], i) => `def ${type} "T${i}" {\n${body}${own}}\n`).join('');
  const within = inner === null ? children : `def Xform "B" {\n${inner}${children}}\n${children}`;
  return `#usda 1.0\n( metersPerUnit = ${unit} )\ndef Xform "A" {\n${outer}${within}}\n`;
});

const read = (reader: typeof readUsd, text: string, options: ReadOptions = {}): Promise<Scene> =>
  reader(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda', options);

const cubes = (count: number): string => Array.from({ length: count }, (_, i) => `def Cube "C${i}" {\n}\n`).join('');

/** A scene with every bit of its arrays, as text. */
const written = (scene: Scene): string =>
  JSON.stringify(scene, (_, value) =>
    ArrayBuffer.isView(value)
      ? Buffer.from(value.buffer, value.byteOffset, value.byteLength).toString('base64')
      : value,
  );

describe('objects with a common motion', () => {
  it(
    'are placed as if each moved alone',
    () =>
      fc.assert(
        fc.asyncProperty(stage, fc.constantFrom('linear', 'cubic'), async (text, interpolation) => {
          const options = { interpolation, chordTolerance: 0.01 } as const;
          const shared = written(await read(readUsd, text, options));
          expect(shared === written(await read(unshared, text, options)), text).toBe(true);
        }),
        { numRuns: 20 },
      ),
    120_000,
  );

  it('keep it if their samples are limited', async () => {
    const wild = `#usda 1.0\ndef Xform "A" {\n${op('double', 'rotateY', ['0', '1e7', '3e6'])}${cubes(12)}}\n`;
    const shared = await read(readUsd, wild);
    expect(shared.diagnostics.map(({ code }) => code)).toContain('usd.resampling');
    expect(written(shared) === written(await read(unshared, wild))).toBe(true);
  });

  it('share one motion object', async () => {
    for (const outer of [op('double', 'rotateX', ['0', '90']), op('double3', 'scale', ['(1, 1, 1)', '(2, 1, 1)'])]) {
      const { objects } = await read(readUsd, `#usda 1.0\ndef Xform "A" {\n${outer}${cubes(20)}}\n`);
      expect(objects).toHaveLength(20);
      expect(new Set(objects.map(({ motion }) => motion)).size).toBe(1);
      expect(new Set(objects.map(({ mesh }) => mesh)).size).toBe(1);
    }
  });
});
