import { vec4 } from 'three/tsl';
import { expect, test, vi } from 'vitest';
import { twinRegistry } from '../../../src/shaders/twins/registry.ts';
import type { Twin } from '../../../src/shaders/twins/twin.ts';
import { openRenderer } from '../support/dawn.ts';
import { casesOf, compareTwin, failures } from './compareTwin.ts';
import { computeTwin } from './runTwin.ts';

// Tests of the twin tests themselves.

const [twin] = twinRegistry;

test('a formula with an error of a thousandth, or a NaN result, fails', async () => {
  const headless = await openRenderer();
  const wrong: Twin = { ...twin, gpu: (texel) => twin.gpu(texel).map((value) => value.mul(1.001)) };
  const lost: Twin = { ...twin, gpu: (texel) => [vec4(texel(0).x.sub(1e30).sqrt())] };
  for (const broken of [wrong, lost]) {
    const cases = casesOf(broken, 1);
    expect(failures(compareTwin(broken, cases, await computeTwin(headless.renderer, broken, cases)))).toHaveLength(1);
  }
  await headless.close();
});

test('a shader that does not compile is detected', async () => {
  const headless = await openRenderer();
  headless.gpu.device.createShaderModule({ code: 'this is not WGSL' });
  await expect(headless.close()).rejects.toThrow(/the GPU reported/);
  headless.gpu.release();
});

test('a buffer that no kernel has written is detected by its canaries', async () => {
  const headless = await openRenderer();
  const cases = casesOf(twin, 1);
  vi.spyOn(headless.renderer, 'getArrayBufferAsync').mockResolvedValue(new ArrayBuffer(cases.length * 32));
  await expect(computeTwin(headless.renderer, twin, cases)).rejects.toThrow(/canary/);
  await headless.close();
});
