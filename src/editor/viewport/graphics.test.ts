import { afterEach, expect, it, vi } from 'vitest';
import { chooseGraphics } from './graphics.ts';

afterEach(() => vi.unstubAllGlobals());

function browser(webgl: boolean, adapter?: 'real' | 'emulated'): void {
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => (webgl ? {} : null) }) });
  const info = { isFallbackAdapter: adapter === 'emulated' };
  vi.stubGlobal('navigator', adapter ? { gpu: { requestAdapter: async () => ({ info }) } } : {});
}

it.each([
  [true, 'real', 'auto', 'auto'],
  [true, 'emulated', 'auto', 'webgl'],
  [false, 'emulated', 'auto', 'auto'],
  [true, undefined, 'auto', 'auto'],
  [false, undefined, 'auto', undefined],
  [true, 'emulated', 'webgpu', 'webgpu'],
  [true, undefined, 'webgpu', undefined],
  [false, 'real', 'webgl', undefined],
] as const)('WebGL2 %s, WebGPU %s, wanted %s: %s', async (webgl, adapter, wanted, chosen) => {
  browser(webgl, adapter);
  expect(await chooseGraphics(wanted)).toBe(chosen);
});
