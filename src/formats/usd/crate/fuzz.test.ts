import { readFileSync } from 'node:fs';
import { describe, expect, it, vi } from 'vitest';
import { random } from '../../../math/random.ts';
import { InputError } from '../../../scene/types.ts';
import { parseLayer } from '../text/parser.ts';
import { outcome } from './fixtures/outcome.ts';
import { writeCrate } from './write/writeCrate.ts';

// Thousands of reads take seconds, on a busy machine many.
vi.setConfig({ testTimeout: 60_000 });

const fixture = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`./fixtures/${name}.usdc`, import.meta.url)));

/** A text layer as our writer writes it. */
const rewritten = (name: string): Uint8Array =>
  writeCrate(parseLayer(readFileSync(new URL(`./fixtures/${name}.usda`, import.meta.url)), 'a'));

const CRATES: readonly (readonly [name: string, bytes: Uint8Array])[] = [
  ...['values', 'arrays', 'arrays-0.4', 'structure', 'splines', 'written'].map(
    (name) => [`${name}.usdc`, fixture(name)] as const,
  ),
  ...['arrays', 'structure'].map((name) => [`${name}.usda, written here`, rewritten(name)] as const),
];

describe.each(CRATES)('%s, damaged,', (_, whole) => {
  it('is rejected when truncated anywhere', () => {
    for (let k = 0; k < 20; k++)
      expect(outcome(whole.subarray(0, Math.floor((whole.length * k) / 20)))).toBeInstanceOf(InputError);
    expect(outcome(whole.subarray(0, whole.length - 1))).toBeInstanceOf(InputError);
  });

  it('is read or rejected with any byte changed', () => {
    const next = random(20261121);
    const damaged = whole.slice();
    for (let k = 0; k < 2000; k++) {
      const at = Math.floor(next() * whole.length);
      damaged[at] = Math.floor(next() * 256);
      outcome(damaged);
      damaged[at] = whole[at];
    }
  });
});

describe.each(['splines', 'written'])('%s.usdc', (name) => {
  it('is read or rejected with a huge count anywhere', () => {
    const whole = fixture(name);
    const damaged = whole.slice();
    const view = new DataView(damaged.buffer);
    for (let at = 16; at + 8 <= whole.length; at++)
      for (const count of [2n ** 31n - 1n, 2n ** 40n, 2n ** 63n - 1n, -1n]) {
        view.setBigInt64(at, count, true);
        outcome(damaged);
        damaged.set(whole.subarray(at, at + 8), at);
      }
  });
});
