import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { numbersAt } from '../../layer/attributes.ts';
import type { Layer } from '../../layer/layer.ts';
import { parseLayer } from '../../text/parser.ts';
import { readCrate } from '../readCrate.ts';
import { writeCrate } from './writeCrate.ts';

const fixture = (name: string): Layer =>
  parseLayer(new Uint8Array(readFileSync(new URL(`../../${name}.usda`, import.meta.url))), 'a');
const layerOf = (body: string): Layer => parseLayer(new TextEncoder().encode(`#usda 1.0\n${body}`), 'a.usda');
const refusal = (body: string): unknown => {
  try {
    return writeCrate(layerOf(body));
  } catch (thrown) {
    return (thrown as Error).message;
  }
};

const LAYERS = [
  ...['grammar', 'xforms', 'meshes', 'written'].map((name) => `fixtures/${name}`),
  ...['values', 'arrays', 'structure', 'splines', 'empty'].map((name) => `crate/fixtures/${name}`),
  'schema/instancer/fixtures/instancers',
];

describe.each(LAYERS)('the layer %s, written as a crate,', (name) => {
  const layer = fixture(name);
  const bytes = writeCrate(layer);

  it('is read back, to the last bit and type', () => {
    expect(readCrate(bytes, 'a')).toEqual(layer);
  });

  it('has the same bytes each time', () => {
    expect(Buffer.from(writeCrate(fixture(name))).equals(bytes)).toBe(true);
  });
});

it.each<[minor: number, body: string]>([
  [8, 'def "A" { int a = 1 }'],
  [9, 'def "A" { timecode a = 1 }'],
  [10, 'def "A" { pathExpression a = "/A" }'],
  [11, '( relocates = { </A/B>: </A/C> } )'],
  [12, 'def "A" { double a.spline = { 1: 5 } }'],
  [13, 'def "A" { double a.spline = { 1: 5; pre (1, 2, autoEase) } }'],
  [15, 'def "A" { timecode a.spline = { 1: 5 } }'],
])('is of the earliest version that has what is in it: 0.%i', (minor, body) => {
  const bytes = writeCrate(layerOf(body));
  expect([...bytes.subarray(8, 11)]).toEqual([0, minor, 0]);
  expect(readCrate(bytes, 'a.usda')).toEqual(layerOf(body));
});

describe('what is the same is there once', () => {
  const numbers = Array.from({ length: 1000 }, (_, i) => Math.sqrt(i)).join(', ');
  const size = (body: string): number => writeCrate(layerOf(body)).length;

  it('of arrays of several attributes and samples', () => {
    const one = size(`def "A" { double[] a = [${numbers}] }`);
    const more = `double[] b = [${numbers}]\n double[] c.timeSamples = { 1: [${numbers}], 2: [${numbers}] }`;
    expect(size(`def "A" { double[] a = [${numbers}]\n${more} }`)).toBeLessThan(one + 300);
  });

  it('of times that attributes share', () => {
    const samples = (name: string, value: number): string =>
      `int ${name}.timeSamples = { ${Array.from({ length: 200 }, (_, i) => `${Math.sqrt(i)}: ${value}`).join(', ')} }`;
    const one = size(`def "A" { ${samples('a', 1)} }`);
    expect(size(`def "A" { ${samples('a', 1)}\n${samples('b', 1)} }`)).toBeLessThan(one + 100);
  });
});

it('keeps −0, every kind of NaN and subnormal numbers, inlined, in tables and as they lie', () => {
  const bits = Uint32Array.from({ length: 64 }, (_, i) => [0x80000000, 0x7fc00001, 0xffc00000, 1, 0][i % 5]);
  const data = new Float32Array(bits.buffer);
  const attribute = { kind: 'attribute', custom: false, uniform: false, metadata: new Map() } as const;
  const values = [data, data.slice(0, 5)].map((part, i) => [
    `a${i}`,
    { ...attribute, name: `a${i}`, typeName: 'float[]', value: { type: 'float[]', data: part } } as const,
  ]);
  const empty = { metadata: new Map(), children: new Map(), variantSets: new Map() };
  const properties = new Map(values as never);
  const prim = { path: '/A', name: 'A', specifier: 'def', typeName: '', properties, ...empty } as const;
  const layer: Layer = { name: 'a', metadata: new Map(), rootPrims: new Map([['A', prim as never]]) };
  const back = readCrate(writeCrate(layer), 'a').rootPrims.get('A')!;
  for (const [name, { value }] of values as [string, { value: { data: Float32Array } }][]) {
    const read = numbersAt(back, name, undefined)!;
    expect(new Uint32Array(read.buffer, read.byteOffset, read.length)).toEqual(
      new Uint32Array(value.data.buffer, value.data.byteOffset, value.data.length),
    );
  }
});

it.each([
  ['def "A" { string s = "a\\x00b" }', 'a.usda</A.s>: the text "a\\u0000b" has the character U+0000'],
  ['def "A" ( payload = @a@ ( customData = { int a = 1 } ) ) { }', 'a.usda</A>: a payload has customData'],
  ['def "A" ( inactiveIds = [-1, 18446744073709551615] ) { }', 'a.usda</A>: of the integers -1, 18446744073709551615'],
  ['def "A" ( relocates = { <B>: <C> } ) { }', 'a.usda</A>: relocates of a prim'],
])('refuses what a crate cannot hold: %s', (body, message) => {
  expect(refusal(body)).toContain(message);
});
