import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../tests/support/pythonOracles.ts';
import { type Json, layerJson } from '../fixtures/layerJson.ts';
import type { AttributeSpec, Layer } from '../layer/layer.ts';
import { parseLayer } from '../text/parser.ts';
import { readCrate } from './readCrate.ts';

const here = fileURLToPath(new URL('./fixtures/', import.meta.url));
const texts = fileURLToPath(new URL('../fixtures/', import.meta.url));
const data = fileURLToPath(new URL('../../../../../shared/data/usd/', import.meta.url));
const crates = (...args: string[]): string => python(join(here, 'crates.py'), ...args);

const folder = mkdtempSync(join(tmpdir(), 'slowlight-crate-'));
afterAll(() => rmSync(folder, { recursive: true }));

const OWN = ['values', 'arrays', 'structure', 'splines', 'empty'];
const bytesOf = (path: string): Uint8Array => new Uint8Array(readFileSync(path));
const crateAt = (path: string): Layer => readCrate(bytesOf(path), 'a');
const textAt = (path: string): Layer => parseLayer(bytesOf(path), 'a');

/** Without the metadata of unknown keys, which usd-core keeps and does not list. */
function asListed(entry: Json, as: Json): Json {
  const keys = Object.keys((as as { metadata: object }).metadata);
  const { metadata, ...rest } = entry as { metadata: Record<string, Json> };
  return { ...rest, metadata: Object.fromEntries(keys.map((key) => [key, metadata[key]])) };
}

/** Every fixture layer, and the names of its copies. */
function layers(): { source: string; crate: string; text: string }[] {
  const under = (root: string): string[] =>
    existsSync(root) ? readdirSync(root, { recursive: true, encoding: 'utf8' }).map((file) => join(root, file)) : [];
  const found = [here, texts, data].flatMap(under).filter((path) => /\.usd[az]?$/.test(path));
  return found.map((source, i) => ({ source, crate: join(folder, `${i}.usdc`), text: join(folder, `${i}.usda`) }));
}

const PRESENT_NAMES: Readonly<Record<string, string>> = {
  ...{ Vec3f: 'float3', 'Vec3d[]': 'double3[]', Vec4i: 'int4', Point: 'point3d', 'PointFloat[]': 'point3f[]' },
  ...{ 'NormalFloat[]': 'normal3f[]', Vector: 'vector3d', ColorFloat: 'color3f', Matrix4d: 'matrix4d' },
  ...{ Quatf: 'quatf', Frame: 'frame4d' },
};

/** Crates keep the former names of types; the texts that usd-core writes do not. */
function renameFormerTypes({ rootPrims }: Layer): void {
  for (const property of rootPrims.get('Former_names')?.properties.values() ?? [])
    if (property.kind === 'attribute')
      Object.assign(property, { typeName: PRESENT_NAMES[property.typeName] ?? property.typeName });
}

describe.skipIf(!hasUsdCore())('usd-core', () => {
  it('reproduces the committed values of the fixtures, text and crate', () => {
    const paths = OWN.flatMap((name) => [join(here, `${name}.usda`), join(here, `${name}.usdc`)]);
    const now = JSON.parse(crates('layers', ...paths));
    for (const path of paths) {
      const { layer } = JSON.parse(readFileSync(path.replace(/\.usd[ac]$/, '.expected.json'), 'utf8'));
      expect(now[path], path).toEqual(layer);
    }
  });

  it('writes every fixture layer as a crate that both readers and it read alike', () => {
    if (!existsSync(data)) console.warn(`${data} is not there: real files are skipped`);
    const all = layers();
    crates('convert', ...all.flatMap(({ source, crate, text }) => [source, crate, source, text]));
    const expected = JSON.parse(crates('layers', ...all.map(({ crate }) => crate)));
    for (const { source, crate, text } of all) {
      const layer = crateAt(crate);
      if (!source.endsWith('.usdz')) expect(layer, source).toEqual(textAt(source));
      const actual = layerJson(layer);
      expect(Object.keys(actual).sort(), source).toEqual(Object.keys(expected[crate]).sort());
      for (const [path, entry] of Object.entries<Json>(expected[crate]))
        expect(asListed(actual[path], entry), `${source} ${path}`).toEqual(entry);
      renameFormerTypes(layer);
      expect(layer, source).toEqual(textAt(text));
    }
  });

  it('writes numbers of any bit pattern, which round-trip', () => {
    crates('bits', folder);
    const { properties } = crateAt(join(folder, 'bits.usdc')).rootPrims.get('A')!;
    for (const name of ['half', 'float', 'double']) {
      const { value } = properties.get(name) as AttributeSpec & { value: { data: Float32Array | Float64Array } };
      const bits = bytesOf(join(folder, `${name}.bin`)).buffer;
      const numbers = name === 'double' ? new Float64Array(bits) : new Float32Array(bits);
      expect(value.data.length).toBe(numbers.length);
      // For halves all NaNs are equal; for floats and doubles the exact bits are the same.
      if (name === 'half') expect(value.data).toEqual(numbers);
      else expect(Buffer.from(value.data.buffer).equals(Buffer.from(bits)), name).toBe(true);
    }
  });
});
