import { expect, it } from 'vitest';
import type { heavyNodes } from '../../src/cli/project/heavyNodes.ts';

/** The built library, because a thread starts from a file of its own. */
const built = async (): Promise<{ heavyNodes: typeof heavyNodes }> =>
  import(new URL('../../dist/lib/cli/project/heavyNodes.js', import.meta.url).href);

it('a node is evaluated in a worker thread of Node.js', async () => {
  const run = (await built()).heavyNodes();
  const request = (operation: string, a: number) => ({
    type: 'math',
    node: 'm',
    inputs: {},
    params: { operation, a, b: 3, c: 0 },
  });
  const work = { progress: () => {} };
  expect(await run(request('add', 2), work)).toEqual({ number: 5 });
  await expect(run(request('square-root', -1), work)).rejects.toMatchObject({ problem: { code: 'math.undefined' } });
});
