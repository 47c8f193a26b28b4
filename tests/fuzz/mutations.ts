import { random } from '../../src/math/random.ts';
import type { Seed } from './seeds.ts';

/** A mutated file and a description of the mutation. */
export interface Mutation {
  readonly what: string;
  readonly bytes: Uint8Array;
}

const TRUNCATIONS = 20;
const FLIPS = 1000;
const MOVES = 60;
/** Values that counts and offsets are set to: just below and above the limits of 31, 32 and 63 bits. */
const COUNTS = [2n ** 31n - 1n, 2n ** 32n - 1n, 2n ** 40n, 2n ** 63n - 1n];
/** Values that numbers in text are set to. */
const NONSENSE = ['-1', '4294967295', '1e999', 'nan', '0.5', '99999999999999999999', '""', ''];
/** Maximum number of positions in a binary file, or numbers in a text, mutated with each value. */
const MAX_POSITIONS = 150;

/** Deterministic mutations: truncation, changed bytes, moved blocks, and too large counts at every position. */
export function* mutations({ files, entry, text }: Seed): Generator<Mutation> {
  const whole = files[entry];
  for (let k = 0; k < TRUNCATIONS; k++) {
    const length = Math.floor((whole.length * k) / TRUNCATIONS);
    yield { what: `cut off after ${length} of ${whole.length} bytes`, bytes: whole.slice(0, length) };
  }
  yield* flips(whole);
  yield* movedBlocks(whole);
  yield* text ? invalidNumbers(whole) : hugeCounts(whole);
}

function* flips(whole: Uint8Array): Generator<Mutation> {
  const next = random(20261121);
  for (let k = 0; k < FLIPS; k++) {
    const at = Math.floor(next() * whole.length);
    const byte = k % 2 === 0 ? whole[at] ^ (1 << Math.floor(next() * 8)) : Math.floor(next() * 256);
    yield { what: `byte ${at} is ${byte}, not ${whole[at]}`, bytes: whole.with(at, byte) };
  }
}

function* movedBlocks(whole: Uint8Array): Generator<Mutation> {
  const next = random(7);
  for (let k = 0; k < MOVES; k++) {
    const [from, to] = [Math.floor(next() * whole.length), Math.floor(next() * whole.length)];
    const length = Math.floor(next() * 200);
    const bytes = whole.slice();
    bytes.copyWithin(to, from, from + length);
    yield { what: `${length} bytes from byte ${from} at byte ${to}`, bytes };
  }
}

function* hugeCounts(whole: Uint8Array): Generator<Mutation> {
  const step = Math.max(1, Math.floor(whole.length / MAX_POSITIONS));
  for (let at = 0; at + 8 <= whole.length; at += step)
    for (const count of COUNTS) {
      const bytes = whole.slice();
      const view = new DataView(bytes.buffer);
      if (count < 2n ** 32n) view.setUint32(at, Number(count), true);
      else view.setBigUint64(at, count, true);
      yield { what: `${count} at byte ${at}`, bytes };
    }
}

function* invalidNumbers(whole: Uint8Array): Generator<Mutation> {
  const text = new TextDecoder().decode(whole);
  const places = [...text.matchAll(/-?\d+(\.\d+)?(e-?\d+)?/g)];
  const step = Math.max(1, Math.floor(places.length / MAX_POSITIONS));
  for (const [i, { index, 0: number }] of places.entries()) {
    if (i % step !== 0) continue;
    for (const nonsense of NONSENSE) {
      const line = text.slice(0, index).split('\n').length;
      const broken = text.slice(0, index) + nonsense + text.slice(index + number.length);
      yield { what: `"${nonsense}" for ${number} in line ${line}`, bytes: new TextEncoder().encode(broken) };
    }
  }
}
