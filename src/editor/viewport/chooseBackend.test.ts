import { afterEach, expect, it, vi } from 'vitest';
import { chooseBackend, isSoftwareRenderer } from './chooseBackend.ts';

afterEach(() => {
  // It forgets the context that it tried.
  isSoftwareRenderer();
  vi.unstubAllGlobals();
});

function browser(webgl: boolean, adapter?: 'real' | 'emulated'): void {
  vi.stubGlobal('document', {
    createElement: () => ({ getContext: () => (webgl ? { getExtension: () => null, getParameter: () => '' } : null) }),
  });
  const info = { isFallbackAdapter: adapter === 'emulated' };
  vi.stubGlobal('navigator', adapter ? { gpu: { requestAdapter: async () => ({ info }) } } : {});
}

it.each([
  ['ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)', true],
  ['llvmpipe (LLVM 15.0.7, 256 bits)', true],
  ['ANGLE (Microsoft, Microsoft Basic Render Driver Direct3D11)', true],
  ['ANGLE (Apple, ANGLE Metal Renderer: Apple M2, Unspecified Version)', false],
])('%s is a software renderer: %s', (name, software) => {
  const gl = { getExtension: () => null, getParameter: () => name };
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => gl }) });
  expect(isSoftwareRenderer()).toBe(software);
});

it.each([
  [true, 'real', 'auto', 'auto'],
  [true, 'emulated', 'auto', 'webgl'],
  [false, 'emulated', 'auto', 'auto'],
  [true, undefined, 'auto', 'auto'],
  [false, undefined, 'auto', undefined],
  [true, 'emulated', 'webgpu', 'webgpu'],
  [true, undefined, 'webgpu', undefined],
  [false, 'real', 'webgl', undefined],
] as const)('WebGL2 %s, WebGPU %s, requested %s: %s', async (webgl, adapter, wanted, chosen) => {
  browser(webgl, adapter);
  expect(await chooseBackend(wanted)).toBe(chosen);
});

it('one context serves the choice and the question for its renderer', async () => {
  let made = 0;
  const gl = { getExtension: () => null, getParameter: () => 'llvmpipe' };
  const getContext = () => {
    made++;
    return gl;
  };
  vi.stubGlobal('document', { createElement: () => ({ getContext }) });
  vi.stubGlobal('navigator', {});
  expect(await chooseBackend('auto')).toBe('auto');
  expect(isSoftwareRenderer()).toBe(true);
  expect(made).toBe(1);
});
