import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { FileSource } from '../../files/fileSource.ts';
import type { Json } from '../fixtures/layerJson.ts';
import { composedFiles, composedSource } from './fixtures/composedFiles.ts';
import { checkSum, stageJson, variantSetsJson } from './fixtures/stageJson.ts';
import { fixtureStages } from './fixtures/stages.ts';
import type { VariantSelection } from './sessionLayer.ts';

interface Expected {
  readonly prims: Record<string, Json>;
  readonly variantSets: readonly (readonly [path: string, set: string, variants: string[], selected: string])[];
  readonly variants: Record<string, Record<string, Json>>;
}
const fixture = (name: string): string => readFileSync(new URL(`./fixtures/${name}`, import.meta.url), 'utf8');
const expected: Record<string, Expected> = JSON.parse(fixture('stages.expected.json'));

describe.each([...fixtureStages(fixture('stages.txt'))])('the stage %s is composed as by usd-core', (name, files) => {
  const { prims, variantSets, variants } = expected[name];

  it('as authored', async () => {
    const { stage, assets } = await composedFiles(files, 'root.usda');
    expect(await stageJson(stage, assets)).toEqual(prims);
    expect(variantSetsJson(stage)).toEqual(variantSets);
  });

  it.skipIf(Object.keys(variants).length === 0)('with every variant', async () => {
    for (const [key, expectedPrims] of Object.entries(variants)) {
      const { stage, assets } = await composedFiles(files, 'root.usda', choices(key));
      expect(await stageJson(stage, assets), key).toEqual(expectedPrims);
    }
  });
});

/** `/Prim{set=variant}`; empty without a choice. */
function choices(key: string): VariantSelection[] {
  const [, path, set, variant] = /^(.*)\{(.*)=(.*)\}$/.exec(key) ?? [];
  return path === undefined ? [] : [{ path, set, variant }];
}

const data = fileURLToPath(new URL('../../../../../shared/data/usd', import.meta.url));
const present = existsSync(data);
if (!present) console.warn(`${data} is not there: composition of real files is not tested`);

const folderSource = (folder: string): FileSource => ({
  read: async (path) => {
    const file = join(folder, path);
    return existsSync(file) ? new Uint8Array(readFileSync(file)) : undefined;
  },
});

describe.skipIf(!present)('real files are composed as by usd-core, with every variant', () => {
  const sums: Record<string, Record<string, number>> = JSON.parse(fixture('shared.expected.json'));

  it.each(Object.entries(sums))('%s', async (file, byChoice) => {
    for (const [key, sum] of Object.entries(byChoice)) {
      const { stage, assets } = await composedSource(
        folderSource(join(data, dirname(file))),
        basename(file),
        choices(key),
      );
      expect(checkSum(await stageJson(stage, assets)), key).toBe(sum);
    }
  });
});
