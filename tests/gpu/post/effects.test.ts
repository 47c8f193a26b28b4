import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it, test } from 'vitest';
import { type HeadlessDevice, openDevice } from '../../../src/cli/gpu/device.ts';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import type { Gpu } from '../../../src/render/gpu/device.ts';
import { EFFECT_IDS, MIX_MODES } from '../../../src/scene/frameGraph/effects.ts';
import { closeAndAssertHealthy } from '../support/healthyClose.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { EFFECT_CASES, type EffectCase, expected } from './effectCases.ts';
import { runEffect } from './runEffect.ts';

/** Tolerance relative to a value, or to the least value distinguishable from black. */
const TOLERANCE = 2e-3;
const BLACK = 1e-3;
const NEARLY = 0.3;
/** For depth of field: each sample can fall on either of two pixels, of very different light. */
const LENS_TOLERANCE = 0.1;
const LENS_SHARE = 0.01;

function expectSame(of: EffectCase, values: ArrayLike<number>): void {
  const truth = expected(of).values;
  expect(values.length).toBe(truth.length);
  // Texts may subtract large numbers, and turned hues do.
  const isOfColor = of.of === 'hue-shift' || (typeof of.of === 'object' && 'text' in of.of);
  const size = (i: number): number =>
    isOfColor ? Math.hypot(...truth.subarray(i - (i % 3), i - (i % 3) + 3)) + NEARLY : Math.abs(truth[i]) + BLACK;
  const errors = Array.from(truth, (value, i) => Math.abs(values[i] - value) / size(i));
  const lens = of.of === 'depth-of-field';
  const wrong = errors.filter((error) => !(error < (lens ? LENS_TOLERANCE : TOLERANCE))).length / errors.length;
  if (process.env.REPORT) console.log(`${of.name}: most ${Math.max(...errors).toExponential(1)}, wrong ${wrong}`);
  expect(wrong).toBeLessThanOrEqual(lens ? LENS_SHARE : 0);
}

test('the cases cover every effect and every mode', () => {
  const tried = new Set(EFFECT_CASES.map(({ of }) => (typeof of === 'string' ? of : 'mode' in of ? of.mode : 'text')));
  expect([...EFFECT_IDS, ...MIX_MODES].filter((name) => !tried.has(name))).toEqual([]);
});

describe('effects agree with the reference, on WebGPU (Dawn)', () => {
  let headless: HeadlessDevice;
  let gpu: Gpu;
  beforeAll(async () => {
    headless = await openDevice();
    const { openGpu } = await import('../../../src/render/gpu/device.ts');
    gpu = await openGpu({ device: headless.device });
  });
  afterAll(() => closeAndAssertHealthy(headless, gpu.renderer)());
  it.each(EFFECT_CASES)('$name', async (of) => {
    pumpFrame();
    expectSame(of, await runEffect(gpu, of));
  });
});

describe('on WebGL2', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./effectsPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());
  it.each(EFFECT_CASES)('$name', async (of) => {
    const values = await chromium.page.evaluate((name) => window.drawEffect(name), of.name);
    chromium.assertHealthy();
    expectSame(of, values);
  });
});
