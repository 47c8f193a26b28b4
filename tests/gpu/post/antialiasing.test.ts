import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { turning } from '../../support/cameraPaths.ts';
import { openModulePage } from '../support/modulePage.ts';
import { openPictures } from '../support/openPictures.ts';
import { type Figures, figuresOf, SIZE } from './antialiasingFigures.ts';

/** What holds of every flight, and on each backend. */
function checks(figures: () => Figures): void {
  it('a picture at rest comes to that of 8 × 8 samples, byte by byte, and then is done', () => {
    expect(figures().unlike).toBe(0);
    expect(figures().refined).toBe(64);
  });

  it('numbers stay those of the pixels’ centres', () => {
    expect(figures().shifted).toBe(0);
  });

  it('without antialiasing there is what the centres show', () => {
    expect(figures().unsmooth).toBeLessThanOrEqual(1);
  });

  it('a moving picture is nearer to the truth than with smoothed edges, at its worst too', () => {
    const { edges, temporal } = figures();
    expect(temporal.error).toBeLessThan(0.7 * edges.error);
    expect(temporal.worst).toBeLessThan(edges.worst);
  });
}

describe('antialiasing: WebGPU (Dawn), a turning head over what is finer than pixels', () => {
  let figures: Figures;
  beforeAll(async () => {
    const headless = await openPictures(SIZE.width, SIZE.height);
    figures = await figuresOf(headless.renderer, turning(0.5), pumpFrame);
    await headless.close();
  }, 120_000);
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
  }, 120_000);
  afterAll(() => close?.());
  checks(() => figures);
});
