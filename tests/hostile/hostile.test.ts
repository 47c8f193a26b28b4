import { afterAll, describe, expect, it } from 'vitest';
import { bombs } from './bombs.ts';
import { damages } from './damage.ts';
import { Reader } from './reader.ts';
import { seeds } from './seeds.ts';

/** Memory that a bomb, or the readings of all damaged files of a kind, may take beyond what there was before [bytes]. */
const MEMORY = 2 ** 30;

const reader = new Reader();
afterAll(() => reader.end());

const all = await seeds();

describe('a damaged file is read or refused, with its place, in bounded time and memory', () => {
  it.each(all)('$name', async (seed) => {
    await reader.take(seed);
    expect(await reader.read(seed.files[seed.entry])).not.toHaveProperty('refusal');
    const before = process.memoryUsage().rss;
    const wrong: string[] = [];
    let [cases, refused, slowest, most] = [0, 0, 0, 0];
    let slow = '';
    for (const { what, bytes } of damages(seed)) {
      const { fault, refusal, milliseconds } = await reader.read(bytes);
      cases++;
      if (refusal) refused++;
      if (fault) wrong.push(`${what}: ${fault}`);
      if (milliseconds > slowest) [slowest, slow] = [milliseconds, what];
      if (cases % 50 === 0) most = Math.max(most, process.memoryUsage().rss - before);
    }
    const figures = `${cases} cases, ${refused} refused, slowest ${slowest.toFixed(0)} ms (${slow}), ${(most / 2 ** 20).toFixed(0)} MiB`;
    console.log(`${seed.name}: ${figures}`);
    expect(wrong.slice(0, 20)).toEqual([]);
    expect(refused).toBeGreaterThan(0);
    expect(most).toBeLessThan(MEMORY);
  });
});

describe('a small file that asks for much gets little', () => {
  it.each(bombs)('$entry: $name', async (bomb) => {
    await reader.take(bomb);
    const before = process.memoryUsage().rss;
    const { fault, said = '', objects = 0, milliseconds } = await reader.read(bomb.files[bomb.entry]);
    const taken = process.memoryUsage().rss - before;
    const took = `${milliseconds.toFixed(0)} ms, ${(taken / 2 ** 20).toFixed(0)} MiB`;
    console.log(`${bomb.entry}: ${bomb.name}: ${took}, ${said.slice(0, 80)}`);
    expect(fault).toBeUndefined();
    expect(said).toMatch(bomb.said);
    expect(objects).toBeLessThanOrEqual(bomb.objects ?? 1000);
    expect(taken).toBeLessThan(MEMORY);
  });
});
