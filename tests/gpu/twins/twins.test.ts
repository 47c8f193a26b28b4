import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { twinRegistry } from '../../../src/shaders/twins/registry.ts';
import type { Twin } from '../../../src/shaders/twins/twin.ts';
import { type HeadlessRenderer, openRenderer } from '../support/dawn.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { casesOf, compareTwin, failures, report } from './compareTwin.ts';
import { pipelines } from './precision.ts';
import { computeTwin } from './runTwin.ts';
import { surfaceCodes } from './surfaceCodes.ts';

/** Use SEED=$RANDOM for a different one per run; failures print it. */
const SEED = Number(process.env.SEED ?? 20260727);
const twins = [...twinRegistry, ...pipelines, ...surfaceCodes];

function expectEqual(twin: Twin, values: ArrayLike<number>): void {
  const verdicts = compareTwin(twin, casesOf(twin, SEED), values);
  if (process.env.REPORT) console.log(report(twin, verdicts));
  expect(failures(verdicts), `seed ${SEED}`).toEqual([]);
}

test('every function of shaders/ has a twin or is part of one', () => {
  const modules = import.meta.glob<Record<string, unknown>>(
    ['../../../src/shaders/**/*.ts', '!../../../src/shaders/{twins,index}/**', '!../../../src/shaders/index.ts'],
    { eager: true },
  );
  const exported = Object.values(modules)
    .flatMap((module) => Object.entries(module))
    .filter(([, value]) => typeof value === 'function')
    .map(([name]) => name);
  const registered = new Set(twinRegistry.flatMap((twin) => [twin.name, ...(twin.parts ?? [])]));
  expect(exported.length).toBeGreaterThan(20);
  expect(exported.filter((name) => !registered.has(name))).toEqual([]);
});

describe('on WebGPU (Dawn)', () => {
  let headless: HeadlessRenderer;
  beforeAll(async () => {
    headless = await openRenderer();
  });
  afterAll(() => headless?.close());

  test.each(twins)('$name', async (twin) => {
    const values = await computeTwin(headless.renderer, twin, casesOf(twin, SEED));
    headless.gpu.assertHealthy();
    expectEqual(twin, values);
  });
});

describe('on WebGL2 (Chromium)', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./twinsPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());

  test.each(twins)('$name', async (twin) => {
    const values = await chromium.page.evaluate(([name, seed]) => window.runTwin(name, seed), [
      twin.name,
      SEED,
    ] as const);
    chromium.assertHealthy();
    expectEqual(twin, values);
  });
});
