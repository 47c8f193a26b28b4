import { float, toneMapping, vec4 } from 'three/tsl';
import { AgXToneMapping } from 'three/webgpu';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { twinRegistry } from '../../../src/shaders/twins/registry.ts';
import type { Twin } from '../../../src/shaders/twins/twin.ts';
import type { Vec4 } from '../../../src/shaders/types.ts';
import { type HeadlessRenderer, openRenderer } from '../support/dawn.ts';
import { casesOf, compareTwin, failures } from './compareTwin.ts';
import { computeTwin } from './runTwin.ts';

let headless: HeadlessRenderer;
beforeAll(async () => {
  headless = await openRenderer();
});
afterAll(() => headless?.close());

test('AgX agrees with three.js', async () => {
  const ours = twinRegistry.find(({ name }) => name === 'toneMapAgx')!;
  const theirs: Twin = {
    ...ours,
    gpu: (texel) => {
      const light = texel(0).xyz.mul(texel(1).x.exp2());
      return [vec4((toneMapping(AgXToneMapping, float(1), light) as unknown as Vec4).rgb, 0)];
    },
  };
  const values = await computeTwin(headless.renderer, theirs, casesOf(theirs, 1));
  headless.gpu.assertHealthy();
  expect(failures(compareTwin(theirs, casesOf(theirs, 1), values))).toEqual([]);
});
