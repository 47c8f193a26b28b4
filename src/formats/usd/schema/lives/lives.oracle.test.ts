import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';
import { writeUsda } from '../../write/writeUsd.ts';
import { type TrianglesAtTimes, trianglesApart } from './fixtures/visibleTriangles.ts';

const fixture = (name: string): string => fileURLToPath(new URL(`./fixtures/${name}`, import.meta.url));
const trianglesOf = (path: string, codes: string): TrianglesAtTimes =>
  JSON.parse(python(fixture('lives.py'), 'read', path, codes));

const folder = mkdtempSync(join(tmpdir(), 'slowlight-lives-'));
afterAll(() => rmSync(folder, { recursive: true }));

describe.skipIf(!hasUsdCore())('usd-core', () => {
  const expected = JSON.parse(readFileSync(fixture('lives.expected.json'), 'utf8')) as TrianglesAtTimes;
  const codes = Object.keys(expected).sort((a, b) => Number(a) - Number(b));

  it('reproduces the committed triangles of lives.usda', () => {
    expect(trianglesOf(fixture('lives.usda'), codes.join())).toEqual(expected);
  });

  it('sees the same in what this program writes', async () => {
    const scene = await readUsd(memorySource({ 'lives.usda': readFileSync(fixture('lives.usda')) }), 'lives.usda');
    const path = join(folder, 'written.usda');
    writeFileSync(path, writeUsda(scene));
    const again = trianglesOf(path, codes.join());
    // Before the start pieces with velocities rest in this program, and not in usd-core.
    for (const code of codes.filter((each) => Number(each) >= 0))
      expect(trianglesApart(again[code], expected[code]), code).toBeLessThan(1e-5);
  });
});
