import { expect, test } from 'vitest';
import { openDevice } from '../../src/cli/device.ts';
import { runOnGpu } from '../../src/compute/run.ts';
import { springs } from '../../src/dynamics/forces/springs.ts';
import { uniform } from '../../src/dynamics/forces/uniform.ts';
import { METHODS } from '../../src/dynamics/methods/library.ts';
import { meshSprings } from '../../src/dynamics/nets.ts';
import { run } from '../../src/dynamics/run.ts';
import { makeSystem, restingAt } from '../../src/dynamics/system.ts';

test('cloth', async () => {
  const gpu = await openDevice();
  const side = 10;
  const x = new Float64Array(3 * side * side);
  const corners: number[] = [];
  for (let i = 0; i < side; i++)
    for (let j = 0; j < side; j++) {
      const at = i * side + j;
      x.set([j / (side - 1), 0, i / (side - 1)], 3 * at);
      if (i + 1 < side && j + 1 < side) corners.push(at, at + 1, at + side + 1, at + side);
    }
  const masses = new Float64Array(side * side).fill(0.01);
  const pinned = new Uint8Array(side * side);
  pinned[0] = pinned[side - 1] = 1;
  const faces = { counts: new Uint8Array((side - 1) ** 2).fill(4), corners };
  const net = meshSprings(x, faces, { structural: 1000, shear: 1000, bending: 1000 });
  const system = makeSystem({ masses, pinned, c: 10, forces: [springs(net), uniform(masses, [0, -9.8, 0])] });
  const order = { system, start: restingAt(x), method: METHODS.get('leapfrog')!, duration: 1, every: 0.04, step: 2e-4 };
  const frames = [];
  const t0 = performance.now();
  for await (const frame of runOnGpu(gpu.device, order)) frames.push(frame);
  const t1 = performance.now();
  const truth = [...run(order)];
  console.log(t1 - t0, performance.now() - t1, frames.length, truth.length);
  gpu.assertHealthy();
  frames.forEach(({ state, ledger, steps }, k) => {
    const off = state.x.reduce((m, v, j) => Math.max(m, Math.abs(v - truth[k].state.x[j])), 0);
    console.log(k, steps, off, ledger.total, truth[k].ledger.total, ledger.kinetic, ledger.fastest);
  });
  gpu.release();
  expect(1).toBe(1);
});
