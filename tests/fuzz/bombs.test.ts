import { afterAll, describe, expect, it } from 'vitest';
import { bombs } from './bombs.ts';
import { MEMORY_LIMIT, ReaderThread } from './readerThread.ts';

const reader = new ReaderThread();
afterAll(() => reader.end());

describe('a decompression bomb is rejected or limited', () => {
  it.each(bombs)('$entry: $name', async (bomb) => {
    await reader.setSeed(bomb);
    const before = process.memoryUsage().rss;
    const { fault, said = '', objects = 0, milliseconds } = await reader.read(bomb.files[bomb.entry]);
    const taken = process.memoryUsage().rss - before;
    const took = `${milliseconds.toFixed(0)} ms, ${(taken / 2 ** 20).toFixed(0)} MiB`;
    console.log(`${bomb.entry}: ${bomb.name}: ${took}, ${said.slice(0, 80)}`);
    expect(fault).toBeUndefined();
    expect(said).toMatch(bomb.said);
    expect(objects).toBeLessThanOrEqual(bomb.objects ?? 1000);
    expect(taken).toBeLessThan(MEMORY_LIMIT);
  });
});
