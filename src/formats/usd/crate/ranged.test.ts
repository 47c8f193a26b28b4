import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { random } from '../../../math/random.ts';
import { InputError } from '../../../scene/types.ts';
import { type FileContent, RangedFile } from '../../files/rangedFile.ts';
import { readCrate } from './readCrate.ts';

const ranged = (handle: Uint8Array): RangedFile => new RangedFile({ name: 'a.usdc', handle }, handle.length);

/** The layer, or the error. */
function outcome(content: FileContent): unknown {
  try {
    return readCrate(content, 'a.usdc');
  } catch (thrown) {
    if (thrown instanceof InputError) return thrown.message;
    throw thrown;
  }
}

describe.each(['values', 'arrays', 'arrays-0.4', 'structure', 'splines', 'written', 'meshes'])('%s.usdc', (name) => {
  const whole = new Uint8Array(readFileSync(new URL(`./fixtures/${name}.usdc`, import.meta.url)));

  it('is the same layer when read in parts', () => {
    expect(readCrate(ranged(whole), 'a.usdc')).toEqual(readCrate(whole, 'a.usdc'));
  });

  it('is read or rejected alike with any byte changed, or truncated', () => {
    const next = random(20261121);
    const damaged = whole.slice();
    for (let k = 0; k < 60; k++) {
      const at = Math.floor(next() * whole.length);
      damaged[at] = Math.floor(next() * 256);
      expect(outcome(ranged(damaged))).toEqual(outcome(damaged));
      damaged[at] = whole[at];
      const part = whole.slice(0, at);
      expect(outcome(ranged(part))).toEqual(outcome(part));
    }
  });
});
