import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { random } from '../../math/random.ts';
import stored from './fixtures/flip.json' with { type: 'json' };
import { picture } from './fixtures/pairs.ts';
import { flip } from './flip.ts';
import { hdrFlip } from './hdrFlip.ts';

/** ꟻLIP against the authors' own program (PyPI flip-evaluator). */

const folder = mkdtempSync(join(tmpdir(), 'slowlight-flip-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const python = process.env.SLOWLIGHT_PYTHON ?? 'python3';
const script = fileURLToPath(new URL('fixtures/flip.py', import.meta.url));
const available = spawnSync(python, ['-c', 'import flip_evaluator, numpy']).status === 0;
if (!available)
  console.warn('skipped: FLIP against flip-evaluator; pip install it, or name a Python with it in SLOWLIGHT_PYTHON');

function evaluator<T>(...args: string[]): T {
  const { stdout, stderr, status } = spawnSync(python, [script, ...args], { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (status !== 0) throw new Error(stderr);
  return JSON.parse(stdout) as T;
}

/** The tolerance covers f32 sums in another order on another machine. */
const closeTo = (found: unknown, expected: unknown): void => {
  if (typeof expected === 'number') return void expect(Math.abs(Number(found) - expected)).toBeLessThan(1e-4);
  for (const [key, value] of Object.entries(expected as object))
    closeTo((found as Record<string, unknown>)[key], value);
};

describe.skipIf(!available)('flip-evaluator', () => {
  it('reproduces flip.json', () => closeTo(evaluator(), stored));

  it('agrees on random pictures', () => {
    const next = random(2020);
    const noise = (most: number) => picture(() => most * next(), 61, 47);
    const pairs = [
      { kind: 'LDR', test: noise(1), reference: noise(1) },
      { kind: 'LDR', test: noise(0.02), reference: noise(0.02) },
      { kind: 'HDR', test: noise(30), reference: noise(20) },
    ];
    const path = join(folder, 'pairs.json');
    const plain = pairs.map(({ kind, test, reference }) => ({
      ...{ kind, width: test.width, height: test.height },
      ...{ test: [...test.rgb], reference: [...reference.rgb] },
    }));
    writeFileSync(path, JSON.stringify(plain));
    const found = evaluator<{ map: number[] }[]>(path);
    pairs.forEach(({ kind, test, reference }, n) => {
      const map = kind === 'HDR' ? hdrFlip(test, reference).map : flip(test, reference);
      const worst = map.reduce((most, error, i) => Math.max(most, Math.abs(error - found[n].map[i])), 0);
      expect(worst, kind).toBeLessThan(3e-4);
    });
  });
});
