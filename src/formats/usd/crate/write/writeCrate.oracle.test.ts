import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { random } from '../../../../math/random.ts';
import { readLayer } from '../../readLayer.ts';
import { readCrate } from '../readCrate.ts';
import { writeCrate } from './writeCrate.ts';

const usd = fileURLToPath(new URL('../../', import.meta.url));
const house = fileURLToPath(new URL('../../../../../', import.meta.url));
const data = join(house, '../shared/data/usd/');

const folder = mkdtempSync(join(tmpdir(), 'slowlight-crate-writer-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** Differences between pairs of layers in the eyes of usd-core. */
const differences = (pairs: readonly string[]): string[] =>
  python(join(usd, 'crate/fixtures/sameLayers.py'), ...pairs)
    .split('\n')
    .filter(Boolean);

const layersUnder = (root: string): string[] =>
  existsSync(root)
    ? readdirSync(root, { recursive: true, encoding: 'utf8' })
        .map((file) => join(root, file))
        .filter((path) => /\.usd[ac]?$/.test(path))
    : [];

/** Writes layers as crates; returns them in pairs. */
function written(sources: readonly string[]): string[] {
  return sources.flatMap((source, i) => {
    const layer = readLayer(new Uint8Array(readFileSync(source)), 'a');
    const bytes = writeCrate(layer);
    expect(readCrate(bytes, 'a'), source).toEqual(layer);
    const path = join(folder, `${i}.usdc`);
    writeFileSync(path, bytes);
    return [source, path];
  });
}

/** Limits of the integers that numbers of a type are made of, and what these are divided by. */
const NUMBERS: Readonly<Record<string, readonly [least: number, most: number, parts: number]>> = {
  int: [-(2 ** 31), 2 ** 31 - 1, 1],
  uint: [0, 2 ** 32 - 1, 1],
  int64: [-(2 ** 53), 2 ** 53, 1],
  uint64: [0, 2 ** 53, 1],
  half: [-2000, 2000, 7],
  float: [-(10 ** 7), 10 ** 7, 3],
  double: [-(2 ** 53), 2 ** 53, 3],
};

/** Of each type arrays of many and of few numbers, of whole ones, near each other, rising. */
function randomArrays(next: () => number): string[] {
  const int = (below: number): number => Math.floor(next() * below);
  return Object.entries(NUMBERS).flatMap(([type, [least, most, parts]]) =>
    [most - least, 300, 70000, 5].flatMap((span, k) => {
      const low = least + int(most - least - span);
      const clamp = (x: number): number => Math.max(least, Math.min(most, x));
      const kinds = [1, parts].map((part) => () => clamp(low + int(span)) / part);
      const rising = (i: number): number => clamp(low + i * (1 + (k % 3)) + int(2));
      return [...kinds, rising].map((number, j) => {
        const items = Array.from({ length: 10 + int(100) }, (_, i) => number(i));
        return `${type}[] ${type}${k}${j} = [${items.map(String).join(', ')}]`;
      });
    }),
  );
}

describe.skipIf(!hasUsdCore())('usd-core', () => {
  it('tells layers apart that differ in a bit', () => {
    const texts = ['float[] a = [0]', 'float[] a = [-0]', 'double[] a = [0]', 'float[] a = [1e-45]', 'float[] b = [0]'];
    const paths = texts.map((text, i) => {
      const path = join(folder, `text${i}.usda`);
      writeFileSync(path, `#usda 1.0\ndef "A"\n{\n${text}\n}\n`);
      return path;
    });
    for (const other of paths.slice(1)) expect(differences([paths[0], other]), other).not.toEqual([]);
    expect(differences([paths[0], paths[0]])).toEqual([]);
  });

  it('reads arrays of any numbers as they are, however they are compressed', () => {
    const next = random(20261123);
    const paths = Array.from({ length: 12 }, (_, k) => {
      const path = join(folder, `random${k}.usda`);
      writeFileSync(path, `#usda 1.0\ndef "A"\n{\n${randomArrays(next).join('\n')}\n}\n`);
      return path;
    });
    expect(differences(written(paths))).toEqual([]);
  });

  it('reads the layers of the fixtures from crates as from the files they are of', () => {
    const sources = layersUnder(usd);
    expect(sources.length).toBeGreaterThan(20);
    expect(differences(written(sources))).toEqual([]);
  });

  it('reads the examples and the corpus alike', () => {
    const sources = ['examples', 'tests/fuzz/corpus'].flatMap((name) => layersUnder(join(house, name)));
    expect(differences(written(sources))).toEqual([]);
  });

  it.skipIf(!existsSync(data))('reads real files alike', () => {
    expect(differences(written(layersUnder(data)))).toEqual([]);
  });
});
