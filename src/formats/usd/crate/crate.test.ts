import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { type Json, layerJson } from '../fixtures/layerJson.ts';
import type { AttributeSpec } from '../layer/layer.ts';
import { parseLayer } from '../text/parser.ts';
import { readCrate } from './readCrate.ts';

const bytesOf = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`./fixtures/${name}`, import.meta.url)));

const OWN = ['values', 'arrays', 'structure', 'splines', 'empty'];
const OTHERS = ['grammar', 'xforms', 'meshes', 'written'];
const text = (name: string): string => (OWN.includes(name) ? `${name}.usda` : `../../fixtures/${name}.usda`);

describe.each([...OWN, ...OTHERS])('the layer %s, text and crate,', (name) => {
  it('is read alike by both readers, to the last bit and type', () => {
    expect(readCrate(bytesOf(`${name}.usdc`), 'a')).toEqual(parseLayer(bytesOf(text(name)), 'a'));
  });
});

/** usd-core does not list metadata of unknown keys, though it keeps them. */
const isListed = (key: string): boolean => !/^unknown|^other$/.test(key);

function listed(entry: Json | undefined): Json | undefined {
  if (typeof entry !== 'object' || entry === null || !('metadata' in entry)) return entry;
  const metadata = Object.entries(entry.metadata as object).filter(([key]) => isListed(key));
  return { ...entry, metadata: Object.fromEntries(metadata) };
}

describe.each([
  ...OWN.map((name) => [name, name]),
  ...['0.4', '0.5', '0.6'].map((version) => [`arrays-${version}`, 'arrays']),
])('the crate %s.usdc is read as by usd-core', (crate, name) => {
  const { layer: expected } = JSON.parse(
    readFileSync(new URL(`./fixtures/${name}.expected.json`, import.meta.url), 'utf8'),
  );
  const actual = layerJson(readCrate(bytesOf(`${crate}.usdc`), 'a'));

  it('has the same specs', () => {
    expect(Object.keys(actual).sort()).toEqual(Object.keys(expected).sort());
  });

  it('has the same values, to the last bit', () => {
    for (const [path, entry] of Object.entries(expected)) expect(listed(actual[path]), path).toEqual(entry);
  });
});

describe('a crate', () => {
  it('keeps metadata of unknown keys as authored', () => {
    const prim = readCrate(bytesOf('structure.usdc'), 'a').rootPrims.get('A')!.children.get('C')!;
    const item = (data: string) => ({ type: 'unregistered', data });
    expect(prim.metadata.get('unknownList')).toEqual(item('[1, "two", (3, 4)]'));
    expect(prim.metadata.get('unknownOp')).toEqual({
      type: 'unregistereds',
      op: { prepended: [item('"a"'), item('"b"')], deleted: [item('"c"')] },
    });
  });

  it('shares one array for samples of equal arrays', () => {
    const { properties } = readCrate(bytesOf('arrays.usdc'), 'a').rootPrims.get('A')!;
    const shared = properties.get('shared') as AttributeSpec;
    const arrays = new Set(shared.timeSamples!.values.map((value) => 'data' in value && value.data));
    expect(arrays.size).toBe(1);
    expect(arrays).toContain((properties.get('floats') as AttributeSpec & { value: { data: unknown } }).value.data);
  });
});
