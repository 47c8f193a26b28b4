import { afterAll, describe, expect, it } from 'vitest';
import { mutations } from './mutations.ts';
import { MEMORY_LIMIT, ReaderThread } from './readerThread.ts';
import type { Seed } from './seeds.ts';

/** Tests that mutated files are read or rejected without crash, hang or excess memory. */
export function fuzzSeeds(seeds: readonly Seed[]): void {
  const reader = new ReaderThread();
  afterAll(() => reader.end());
  describe('a damaged file is read, or rejected with file and place, in bounded time and memory', () => {
    it.each(seeds)('$name', async (seed) => {
      await reader.setSeed(seed);
      expect(await reader.read(seed.files[seed.entry])).not.toHaveProperty('refusal');
      const before = process.memoryUsage().rss;
      const wrong: string[] = [];
      let [cases, refused, slowest, most] = [0, 0, 0, 0];
      let slow = '';
      for (const { what, bytes } of mutations(seed)) {
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
      expect(most).toBeLessThan(MEMORY_LIMIT);
    });
  });
}
