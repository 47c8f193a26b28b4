import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { turning } from '../../support/cameraPaths.ts';
import { openModulePage } from '../support/modulePage.ts';
import { openPictures } from '../support/openPictures.ts';
import { type Figures, figuresOf, SIZE } from './antialiasingFigures.ts';

/** Checks for every camera path and backend. */
function checks(figures: () => Figures): void {
  it('a still picture converges to that of 8 × 8 samples, to the byte, and is then complete', () => {
    expect(figures().unlike).toBe(0);
    expect(figures().refined).toBe(64);
  });

  it('data stay those of the pixel centres', () => {
    expect(figures().shifted).toBe(0);
  });

  it('without antialiasing the picture shows the pixel centres', () => {
    expect(figures().unsmooth).toBeLessThanOrEqual(1);
  });

  it('a moving picture is closer to the truth than with edge smoothing, also at its worst', () => {
    const { edges, temporal } = figures();
    expect(temporal.error).toBeLessThan(0.7 * edges.error);
    expect(temporal.worst).toBeLessThan(edges.worst);
  });
}

describe('antialiasing: WebGPU (Dawn), a turning camera over details finer than pixels', () => {
  let figures: Figures;
  beforeAll(async () => {
    const headless = await openPictures(SIZE.width, SIZE.height);
    figures = await figuresOf(headless.renderer, turning(0.5), pumpFrame);
    await headless.close();
  });
  checks(() => figures);
  it('flickers less', () => {
    expect(figures.temporal.flicker).toBeLessThan(0.8 * figures.edges.flicker);
  });
});

describe('antialiasing: WebGL2 (Chromium), balls passing', () => {
  let figures: Figures;
  let close: () => Promise<void>;
  beforeAll(async () => {
    const chromium = await openModulePage(fileURLToPath(new URL('./antialiasingPage.ts', import.meta.url)));
    close = chromium.close;
    figures = await chromium.page.evaluate(() => window.antialias());
    chromium.assertHealthy();
  });
  afterAll(() => close?.());
  checks(() => figures);
});
