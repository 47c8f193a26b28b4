import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Json } from '../fixtures/layerJson.ts';
import { composedFiles } from './fixtures/composedFiles.ts';
import { stageJson, variantSetsJson } from './fixtures/stageJson.ts';
import { fixtureStages } from './fixtures/stages.ts';

interface Expected {
  readonly prims: Record<string, Json>;
  readonly variantSets: readonly (readonly [path: string, set: string, variants: string[], selected: string])[];
  readonly variants: Record<string, Record<string, Json>>;
}
const fixture = (name: string): string => readFileSync(new URL(`./fixtures/${name}`, import.meta.url), 'utf8');
const expected: Record<string, Expected> = JSON.parse(fixture('stages.expected.json'));

describe.each([...fixtureStages(fixture('stages.txt'))])('the stage %s is what usd-core composes', (name, files) => {
  const { prims, variantSets, variants } = expected[name];

  it('as it is written', async () => {
    const { stage, assets } = await composedFiles(files, 'root.usda');
    expect(await stageJson(stage, assets)).toEqual(prims);
    expect(variantSetsJson(stage)).toEqual(variantSets);
  });

  it.skipIf(Object.keys(variants).length === 0)('with every variant', async () => {
    for (const [key, expectedPrims] of Object.entries(variants)) {
      const [, path, set, variant] = /^(.*)\{(.*)=(.*)\}$/.exec(key)!;
      const { stage, assets } = await composedFiles(files, 'root.usda', [{ path, set, variant }]);
      expect(await stageJson(stage, assets), key).toEqual(expectedPrims);
    }
  });
});
