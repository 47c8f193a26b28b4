import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { type Json, layerJson } from '../fixtures/layerJson.ts';
import { parseLayer } from './parser.ts';

const fixture = (name: string): URL => new URL(`../fixtures/${name}`, import.meta.url);

/** Keys that usd-core keeps only as text of an unknown type. */
const UNREGISTERED = new Set(['autoPlay', 'playbackMode']);

function withoutUnregistered(entry: Json | undefined): Json | undefined {
  if (typeof entry !== 'object' || entry === null || !('metadata' in entry)) return entry;
  const metadata = Object.entries(entry.metadata as object).filter(([key]) => !UNREGISTERED.has(key));
  return { ...entry, metadata: Object.fromEntries(metadata) };
}

describe.each(['grammar', 'xforms', 'meshes', 'written'])('the layer %s.usda is read as by usd-core', (name) => {
  const { layer: expected } = JSON.parse(readFileSync(fixture(`${name}.expected.json`), 'utf8'));
  const actual = layerJson(parseLayer(readFileSync(fixture(`${name}.usda`)), `${name}.usda`));

  it('has the same specs', () => {
    expect(Object.keys(actual).sort()).toEqual(Object.keys(expected).sort());
  });

  it('has the same values, to the last bit', () => {
    for (const [path, entry] of Object.entries(expected))
      expect(withoutUnregistered(actual[path]), path).toEqual(entry);
  });
});
