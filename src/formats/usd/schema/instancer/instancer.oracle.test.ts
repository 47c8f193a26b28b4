import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';
import { agreement, type Places } from './fixtures/agreement.ts';
import { randomInstancer } from './fixtures/randomInstancer.ts';

const fixture = (name: string): string => fileURLToPath(new URL(`./fixtures/${name}`, import.meta.url));
const TIMES = [-6, 0, 5, 12, 17.5, 24, 30, 36, 41, 48];
const placesOf = (...paths: string[]): Record<string, Places> =>
  JSON.parse(python(fixture('instancers.py'), TIMES.join(','), ...paths));

const folder = mkdtempSync(join(tmpdir(), 'slowlight-instances-'));
afterAll(() => rmSync(folder, { recursive: true }));

describe.skipIf(!hasUsdCore())('usd-core', () => {
  /** `REFRESH=1 npx vitest run --project oracle src/formats/usd/instancer` */
  it('reproduces the committed instances of instancers.usda', () => {
    const path = fixture('instancers.usda');
    const fresh = placesOf(path)[path];
    const committed = fixture('instancers.expected.json');
    if (process.env.REFRESH) writeFileSync(committed, `${JSON.stringify(fresh)}\n`);
    expect(fresh).toEqual(JSON.parse(readFileSync(committed, 'utf8')));
  });

  it('agrees with this reader on random instancers', async () => {
    const texts = Array.from({ length: 40 }, (_, seed) => randomInstancer(seed));
    const paths = texts.map((text, seed) => {
      const path = join(folder, `${seed}.usda`);
      writeFileSync(path, text);
      return path;
    });
    const all = placesOf(...paths);
    for (const [seed, text] of texts.entries()) {
      const source = memorySource({ 'a.usda': new TextEncoder().encode(text) });
      const scene = await readUsd(source, 'a.usda', { chordTolerance: 1e-5 });
      const found = agreement(scene, all[paths[seed]], /./, (code) => code >= 0);
      expect(found, `seed ${seed}`).toMatchObject({ missing: [], extra: [] });
      expect(found.off, `seed ${seed}`).toBeLessThan(2e-4);
    }
  });
});
