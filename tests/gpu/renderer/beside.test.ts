import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import type { RenderSettings } from '../../../src/scene/view/view.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import {
  BESIDE,
  CHECKS,
  type Drawn,
  draw,
  drawAll,
  drawInTurns,
  FEW_TEXELS,
  FIRST,
  LARGE,
  OTHER,
  SCENE,
} from './besideScenes.ts';

/** The pictures of a renderer alone on its device, in which something is seen. */
async function drawnAlone(shots: typeof FIRST): Promise<Drawn[]> {
  const { renderer, close } = await openPictures(8, 8, { maxPointTexels: FEW_TEXELS });
  await renderer.setScene(SCENE);
  const drawn = await drawAll(renderer, shots, pumpFrame);
  await close();
  for (const { depth } of drawn) expect(new Set(depth).size).toBeGreaterThan(depth.length / 4);
  return drawn;
}

async function beside(first: SceneRenderer): Promise<SceneRenderer> {
  const second = first.beside({ maxPointTexels: FEW_TEXELS });
  await second.setScene(SCENE);
  return second;
}

describe('two renderers on one device draw, to the byte, what each draws alone', () => {
  let alone: { readonly first: Drawn[]; readonly beside: Drawn[] };
  let headless: HeadlessPictures;
  beforeAll(async () => {
    alone = { first: await drawnAlone(FIRST), beside: await drawnAlone(BESIDE) };
    headless = await openPictures(8, 8, { maxPointTexels: FEW_TEXELS });
  });
  afterAll(() => headless?.close());

  it('in turns, of one scene', async () => {
    const { renderer } = headless;
    await renderer.setScene(SCENE);
    const second = await beside(renderer);
    expect(await drawInTurns(renderer, second, pumpFrame)).toEqual(alone);
    second.dispose();
  });

  it('while the other is given another scene, and when it is disposed of', async () => {
    const { renderer } = headless;
    const [shot, last] = [FIRST[2]!, FIRST[3]!];
    await renderer.setScene(SCENE);
    const second = await beside(renderer);
    const other = await beside(renderer);
    await drawInTurns(renderer, second, pumpFrame);
    await second.setScene(OTHER);
    await draw(second, BESIDE[0]!, pumpFrame);
    expect(await draw(renderer, shot, pumpFrame)).toEqual(alone.first[2]);
    await renderer.setScene(OTHER);
    await draw(renderer, shot, pumpFrame);
    expect(await draw(other, BESIDE[0]!, pumpFrame)).toEqual(alone.beside[0]);
    await renderer.setScene(SCENE);
    for (const each of [second, other]) each.dispose();
    expect(await draw(renderer, last, pumpFrame)).toEqual(alone.first[3]);
  });

  it('also while the first gains samples at rest', async () => {
    const { renderer } = headless;
    const accumulated = async (meanwhile: () => Promise<unknown>): Promise<Uint8Array> => {
      await draw(renderer, { ...FIRST[2]!, size: BESIDE[0]!.size }, pumpFrame);
      do {
        await meanwhile();
        pumpFrame();
      } while (renderer.accumulate(2));
      return renderer.readPixels();
    };
    await renderer.setScene(SCENE);
    const undisturbed = await accumulated(async () => {});
    const second = await beside(renderer);
    let drawn: Drawn | undefined;
    expect(
      await accumulated(async () => {
        drawn = await draw(second, BESIDE[0]!, pumpFrame);
      }),
    ).toEqual(undisturbed);
    expect(drawn).toEqual(alone.beside[0]);
    second.dispose();
  });

  it('and compile their shaders at one time', async () => {
    const { renderer, gpu } = headless;
    await renderer.setScene(SCENE);
    const second = await beside(renderer);
    const dropped = await beside(renderer);
    const [first, small] = [FIRST[2]!, BESIDE[0]!];
    const ask = (of: SceneRenderer, { size, view, settings, sampling }: typeof first) => {
      of.setSize(size.width, size.height);
      return of.precompile([view], settings, sampling);
    };
    const coming = [ask(renderer, first), ask(second, small), ask(dropped, small)];
    expect(coming).not.toContain(undefined);
    dropped.dispose();
    await Promise.all(coming);
    const compiled = vi.spyOn(gpu.device, 'createRenderPipeline');
    for (const [of, { view, settings, sampling }] of [
      [renderer, first],
      [second, small],
    ] as const) {
      pumpFrame();
      of.render([view], settings, sampling);
    }
    expect(compiled).not.toHaveBeenCalled();
    compiled.mockRestore();
    expect(Array.from(await renderer.readPixels())).toEqual(alone.first[2]!.pixels);
    expect(Array.from(await second.readPixels())).toEqual(alone.beside[0]!.pixels);
    second.dispose();
  });
});

/** Bytes of vertex buffers, and number of textures of checks, that the device has been asked for meanwhile. */
async function uploaded({ gpu: { device } }: HeadlessPictures, meanwhile: () => Promise<unknown>) {
  const [createBuffer, createTexture] = [device.createBuffer.bind(device), device.createTexture.bind(device)];
  let [bytes, checks] = [0, 0];
  // three.js uses its descriptors again, so they are read at once.
  const buffers = vi.spyOn(device, 'createBuffer').mockImplementation((asked) => {
    if (asked.usage & GPUBufferUsage.VERTEX && !(asked.usage & GPUBufferUsage.STORAGE)) bytes += asked.size;
    return createBuffer(asked);
  });
  const textures = vi.spyOn(device, 'createTexture').mockImplementation((asked) => {
    if ((asked.size as GPUExtent3DDict).width === CHECKS.width) checks++;
    return createTexture(asked);
  });
  await meanwhile();
  for (const spy of [buffers, textures]) spy.mockRestore();
  return { bytes, checks };
}

describe('what two pictures show is on the GPU once', () => {
  it('with two renderers, and with a ghost', async () => {
    const headless = await openPictures(8, 8);
    const { renderer } = headless;
    await renderer.setScene(LARGE);
    const shot = FIRST[2]!;
    const first = await uploaded(headless, () => draw(renderer, shot, pumpFrame));
    // 25,000 vertices with place, normal, object and material.
    expect(first.bytes).toBeGreaterThan(800_000);
    expect(first.checks).toBe(1);
    const second = renderer.beside();
    await second.setScene(LARGE);
    const again = await uploaded(headless, () => draw(second, shot, pumpFrame));
    expect(again.checks).toBe(0);
    expect(again.bytes).toBeLessThan(first.bytes / 10);
    const settings: RenderSettings = { ...shot.settings, ghost: 'simultaneity' };
    const ghost = await uploaded(headless, async () => {
      do {
        await draw(renderer, { ...shot, settings }, pumpFrame);
        await new Promise(setImmediate);
      } while (renderer.info.waiting);
    });
    expect(ghost.checks).toBe(0);
    expect(ghost.bytes).toBeLessThan(first.bytes / 10);
    // The last user frees it; three.js keeps its full-screen triangle of nine floats.
    const freed = await uploaded(headless, async () => {
      await renderer.setScene(OTHER);
      second.dispose();
      await renderer.setScene(LARGE);
      await draw(renderer, shot, pumpFrame);
    });
    expect(freed).toEqual({ bytes: first.bytes - 36, checks: 1 });
    await headless.close();
  });

  it('and a renderer may be disposed of after the device', async () => {
    const { renderer, gpu } = await openPictures(8, 8);
    await renderer.setScene(SCENE);
    const second = await beside(renderer);
    await draw(second, BESIDE[0]!, pumpFrame);
    renderer.dispose();
    second.dispose();
    gpu.assertHealthy();
    gpu.release();
  });
});

describe('on WebGL2', () => {
  let browser: ModulePage;
  beforeAll(async () => {
    browser = await openModulePage(fileURLToPath(new URL('./besidePage.ts', import.meta.url)));
  });
  afterAll(() => browser?.close());

  it('two renderers draw what each draws alone, and the canvas keeps its size', async () => {
    const first = await browser.page.evaluate(() => window.drawAlone('first'));
    const alone = await browser.page.evaluate(() => window.drawAlone('beside'));
    const together = await browser.page.evaluate(() => window.drawBeside());
    const { width, height } = FIRST.at(-1)!.size;
    expect(together).toEqual({ first, beside: alone, canvas: [width, height] });
    browser.assertHealthy();
  });
});
