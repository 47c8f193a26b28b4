import { expect, it } from 'vitest';
import type { teamThreads } from '../../src/cli/simulate/teamThreads.ts';
import { springForce } from '../../src/dynamics/forces/springs.ts';
import { uniformField } from '../../src/dynamics/forces/uniformField.ts';
import type { integrate, METHODS, RunOptions, SimulationFrame } from '../../src/dynamics/index.ts';
import { meshSprings } from '../../src/dynamics/meshSprings.ts';
import { makeSystem, stateAtRest } from '../../src/dynamics/system.ts';
import { sheet } from '../support/clothKit.ts';

/** The built library, because a thread starts from a file of its own. */
const built = async <T>(path: string): Promise<T> => import(new URL(`../../dist/lib/${path}`, import.meta.url).href);

const STEPS = 8000;

/** 6400 points that hang at two corners, in steps of 0.3 of the stability limit: enough work for threads. */
function cloth(method: RunOptions['method'], more: Partial<RunOptions>): RunOptions {
  const side = 80;
  const { x, faces } = sheet(side);
  const masses = new Float64Array(side * side).fill(1e-4);
  const pinned = new Uint8Array(side * side);
  pinned[0] = pinned[side - 1] = 1;
  const net = meshSprings(x, faces, { structural: 1000, shear: 1000, bending: 1000 });
  const forces = [springForce(net), uniformField(masses, [0, -9.8, 0])];
  const step = 4e-5;
  return {
    ...{ system: makeSystem({ masses, pinned, c: 10, forces, drag: 0 }), start: stateAtRest(x), method },
    ...{ duration: STEPS * step, every: (STEPS / 4) * step, step },
    ...more,
  };
}

it('threads give the same bits as one, whatever their number', async () => {
  const library = await built<{ integrate: typeof integrate; METHODS: typeof METHODS }>('dynamics/index.js');
  const host = (await built<{ teamThreads: typeof teamThreads }>('cli/simulate/teamThreads.js')).teamThreads;
  const leapfrog = library.METHODS.get('leapfrog')!;
  let started = 0;
  const threads = (count: number): RunOptions['threads'] => ({
    count,
    start: (task) => {
      started++;
      host.start(task);
    },
  });
  const run = (more: Partial<RunOptions>): readonly SimulationFrame[] => [...library.integrate(cloth(leapfrog, more))];
  const alone = run({});
  expect(started).toBe(0);
  for (const count of [2, 3]) expect(run({ threads: threads(count) })).toEqual(alone);
  expect(started).toBe(3);
  // A run that is left before its end lets its threads go.
  const left = library.integrate(cloth(leapfrog, { threads: threads(2) }));
  for (let frame = 0; frame < 2; frame++) expect(left.next().value).toEqual(alone[frame]);
  left.return(undefined);
});
