import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { AxeBuilder } from '@axe-core/playwright';
import type { Page, Request } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { colorCount, difference, Program, sharedPage, WINDOW } from './program.ts';
import { drop } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const modules = fileURLToPath(new URL('../../node_modules', import.meta.url));
const assets = fileURLToPath(new URL('../../dist/app/assets', import.meta.url));
/** The content of all files of the built page with an extension. */
const built = (ending: string): string =>
  readdirSync(assets)
    .filter((file) => file.endsWith(ending))
    .map((file) => readFileSync(join(assets, file), 'utf8'))
    .join('\n');

const SMALL = '?backend=webgl&scene=examples/sphere.usdc';
const shared = sharedPage(async () => (await program.open(SMALL)).ready());

async function seriousViolations(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`);
}

const dice = sharedPage(async () => (await program.open('?backend=webgl&scene=examples/dice.usdc')).ready());

describe('the page', () => {
  it('has no serious accessibility violation, in dark and light colours', async () => {
    const visit = await shared();
    await visit.page.setViewportSize({ width: 1280, height: 720 });
    for (const colorScheme of ['light', 'dark'] as const) {
      await visit.page.emulateMedia({ colorScheme });
      await visit.page.locator(`html[data-mantine-color-scheme=${colorScheme}]`).waitFor();
      await visit.shot(`page-${colorScheme}`);
      expect(await seriousViolations(visit.page)).toEqual([]);
      await visit.page.getByRole('button', { name: 'Scenes' }).click();
      await visit.page.getByRole('dialog').waitFor();
      await visit.page.locator('[data-example]').first().waitFor();
      await visit.settled(); // Until the dialogue has faded in its contrast is poor.
      await visit.shot(`gallery-${colorScheme}`);
      expect(await seriousViolations(visit.page)).toEqual([]);
      await visit.page.keyboard.press('Escape');
      await visit.page.getByRole('dialog').waitFor({ state: 'detached' });
      await visit.page.keyboard.press('F1');
      await visit.page.getByRole('dialog', { name: 'Keys' }).waitFor();
      await visit.settled();
      await visit.shot(`help-${colorScheme}`);
      expect(await seriousViolations(visit.page)).toEqual([]);
      await visit.page.keyboard.press('Escape');
      await visit.page.getByRole('dialog').waitFor({ state: 'detached' });
    }
    await visit.page.setViewportSize(WINDOW);
  });

  it('fits large and small windows, also when resized', async () => {
    const visit = await shared();
    for (const [width, height] of [
      [1920, 1080],
      [800, 600],
      [600, 800],
    ] as const) {
      await visit.page.setViewportSize({ width, height });
      await expect.poll(() => visit.page.evaluate(() => innerWidth)).toBe(width);
      await visit.shot(`page-${width}x${height}`);
      const overflow = () => visit.page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      await expect.poll(overflow).toBeLessThanOrEqual(0);
      const pictureFraction = async (): Promise<number> => {
        const picture = await visit.viewport.boundingBox();
        return (picture!.width * picture!.height) / (width * height);
      };
      await expect.poll(pictureFraction).toBeGreaterThan(0.3);
    }
    await visit.page.setViewportSize(WINDOW);
  });

  it('can be switched to Chinese, which is remembered', async () => {
    const visit = await (await program.open(SMALL)).ready();
    await visit.chooseLanguage('中文');
    await visit.page.getByText('光速').first().waitFor();
    expect(await visit.page.evaluate(() => document.documentElement.lang)).toBe('zh-CN');
    await visit.shot('page-zh');
    await visit.page.reload();
    await visit.page.getByText('相对论控制台').waitFor();
    await visit.ready();
    const broken = Buffer.from('#usda 1.0\ndef Mesh "a" {\n  int[] x = [1, 2\n');
    await drop(visit, [{ name: 'broken.usda', content: broken }]);
    await expect.poll(() => visit.refusals.textContent()).toMatch(/broken\.usda.*此处应为列表中的.*文件却已结束/);
    await visit.shot('page-zh-refused');
    await visit.chooseLanguage('English');
    // What is shown already changes its language too.
    await expect.poll(() => visit.refusals.textContent()).toMatch(/broken\.usda.*found the end of the file/);
    expect(await visit.page.evaluate(() => document.documentElement.lang)).toBe('en-GB');
    await visit.close();
  });

  it('undo and redo cover every edit; a slider drag is one edit', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const undo = visit.page.getByRole('button', { name: /^Undo/ });
    const redo = visit.page.getByRole('button', { name: /^Redo/ });
    expect(await undo.isDisabled()).toBe(true);
    const before = await visit.status('c');
    const track = (await visit.page.getByRole('slider', { name: 'Speed of light' }).boundingBox())!;
    await visit.page.mouse.move(track.x + track.width / 2, track.y + track.height / 2);
    await visit.page.mouse.down();
    await visit.page.mouse.move(track.x + 60, track.y, { steps: 8 });
    await visit.page.mouse.up();
    await expect.poll(() => visit.status('c')).not.toBe(before);
    const after = await visit.status('c');
    await visit.page.keyboard.press('Control+z');
    await expect.poll(() => visit.status('c')).toBe(before);
    expect(await undo.isDisabled()).toBe(true);
    await redo.click();
    await expect.poll(() => visit.status('c')).toBe(after);
    await visit.close();
  });

  it('a worker plans the tessellation, and the status bar counts what is drawn', async () => {
    const visit = await dice();
    expect(visit.page.workers().filter((worker) => worker.url().includes('tessellation.worker'))).toHaveLength(1);
    await expect.poll(() => visit.status('triangles')).toMatch(/^[1-9][\d\s]* triangles$/);
  });

  it('views differ, and switching back restores the picture', async () => {
    const visit = await (await dice()).finest();
    const show = (view: string) =>
      visit.page.getByRole('radiogroup', { name: 'View' }).getByText(view, { exact: true }).click();
    const seen = await visit.pixels();
    await show('Simultaneity');
    await expect.poll(async () => difference(await visit.pixels(), seen)).toBeGreaterThan(0.5);
    await visit.shot('view-simultaneity');
    const moment = await visit.finest().then(() => visit.pixels());
    await show('Between');
    await expect.poll(async () => difference(await visit.pixels(), moment)).toBeGreaterThan(0.5);
    // At its ends it is one of the others, reached by the keyboard.
    const slider = visit.page.getByRole('slider', { name: 'From slice to cone' });
    await slider.press('ArrowLeft');
    expect(await slider.getAttribute('aria-valuetext')).toBe('0.49');
    await slider.press('Home');
    await expect.poll(async () => difference(await visit.pixels(), moment)).toBeLessThan(0.5);
    await slider.press('End');
    await expect.poll(async () => difference(await visit.pixels(), seen)).toBeLessThan(0.5);
    await show('Seen');
    await expect.poll(async () => difference(await visit.pixels(), seen)).toBeLessThan(0.5);
  });

  it('recovers its state after the loss of the WebGL context', async () => {
    const visit = await (await shared()).finest();
    const before = await visit.pixels();
    await visit.page.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
      canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    });
    await visit.page.getByText('was lost and has been restarted').waitFor();
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeLessThan(1);
    expect(await visit.status('backend')).toBe('WebGL 2');
    visit.expectComplaint(/Device Lost/);
  });

  it('draws with WebGPU where available, and recovers from the loss of its device', async () => {
    // The crash is of all pages of a browser, so that this has one of its own. Software WebGPU is slow for large pictures.
    const own = await Program.start();
    const options = { viewport: { width: 800, height: 480 } };
    const visit = await (await own.open('?backend=webgpu&scene=examples/sphere.usdc', options)).ready();
    expect(await visit.status('backend')).toBe('WebGPU');
    await visit.finest();
    const before = await visit.pixels();
    expect(colorCount(before)).toBeGreaterThan(50);
    await own.crashGraphics();
    await visit.page.getByText('was lost and has been restarted').waitFor();
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeLessThan(1);
    visit.expectComplaint(/Device Lost/);
    await visit.close();
    await own.stop();
  });

  it('says what to do where no GPU API is available', async () => {
    const visit = await program.open('', {}, async (page) => {
      await page.addInitScript(() => {
        HTMLCanvasElement.prototype.getContext = () => null;
        Object.defineProperty(navigator, 'gpu', { value: undefined });
      });
    });
    await visit.page.getByRole('heading', { name: /needs WebGPU or WebGL 2/ }).waitFor();
    await visit.page.getByText('graphics driver').waitFor();
    await visit.shot('unsupported');
    expect(await seriousViolations(visit.page)).toEqual([]);
    await visit.close();
  });

  it('contains the styles of all its controls, and no others', () => {
    const scripts = built('.js');
    const styles = built('.css');
    const names = (css: string): readonly string[] => [...new Set(css.match(/\bm_[0-9a-f]+\b/g))];
    const mantineClasses = names(readFileSync(join(modules, '@mantine/core/styles.css'), 'utf8'));
    const used = mantineClasses.filter((name) => scripts.includes(name));
    expect(used.length).toBeGreaterThan(50);
    expect(names(styles).toSorted()).toEqual(used.toSorted());
  });

  it('shows the thumbnail of an example until its first picture', async () => {
    let release = () => {};
    const released = new Promise<void>((done) => {
      release = done;
    });
    const visit = await program.open(SMALL, {}, async (page) => {
      await page.route('**/examples/sphere.usdc', async (route) => {
        await released;
        await route.continue();
      });
    });
    const poster = visit.page.locator('.sl-poster');
    await poster.waitFor();
    await expect.poll(() => poster.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBe(480);
    await visit.shot('poster');
    release();
    await visit.ready();
    await poster.waitFor({ state: 'detached' });
    await visit.close();
  });

  it('who flies already when the panels come flies on, with the focus', async () => {
    let release = () => {};
    const released = new Promise<void>((done) => {
      release = done;
    });
    const visit = await program.open(SMALL, {}, async (page) => {
      await page.route('**/DockLayout-*.js', async (route) => {
        await released;
        await route.continue();
      });
    });
    await visit.ready();
    const { page } = visit;
    await visit.viewport.focus();
    await page.keyboard.down('w');
    await expect.poll(() => visit.speed()).toBeGreaterThan(0.4);
    const { width } = (await visit.viewport.boundingBox())!;
    release();
    await page.getByRole('textbox', { name: 'Speed of light', exact: true }).waitFor();
    await visit.ticked();
    expect(await visit.speed()).toBeGreaterThan(0.4);
    expect(await visit.viewport.evaluate((picture) => picture === document.activeElement)).toBe(true);
    expect((await visit.viewport.boundingBox())!.width).toBe(width);
    await page.keyboard.up('w');
    await expect.poll(() => visit.speed()).toBe(0);
    await visit.close();
  });

  it('draws nothing where nothing changes, and again when one flies', async () => {
    const visit = await program.open(SMALL, {}, async (page) => {
      await page.addInitScript(() => {
        const counted = globalThis as unknown as { draws: number };
        counted.draws = 0;
        const { prototype } = WebGL2RenderingContext;
        for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'] as const) {
          const draw = prototype[name] as (...args: unknown[]) => void;
          Object.assign(prototype, {
            [name](...args: unknown[]) {
              counted.draws++;
              draw.apply(this, args);
            },
          });
        }
      });
    });
    await visit.finest();
    const { page } = visit;
    const draws = () => page.evaluate(() => (globalThis as unknown as { draws: number }).draws);
    const duringFrames = async (count: number) => {
      const before = await draws();
      await page.evaluate(
        (frames) =>
          new Promise<void>((done) => {
            const next = (left: number) => (left === 0 ? done() : requestAnimationFrame(() => next(left - 1)));
            next(frames);
          }),
        count,
      );
      return (await draws()) - before;
    };
    expect(await draws()).toBeGreaterThan(0);
    // Shaders that flights will need are tried out first.
    await expect.poll(() => duringFrames(120)).toBe(0);
    await page.getByRole('button', { name: 'Keys and help' }).hover();
    expect(await duringFrames(120)).toBe(0);
    await visit.viewport.focus();
    await page.keyboard.down('w');
    await expect.poll(() => duringFrames(10)).toBeGreaterThan(0);
    await page.keyboard.up('w');
    await visit.close();
  });

  it('loads little before its first picture: each part at most its share', async () => {
    const requests: Request[] = [];
    const visit = await program.open(SMALL, {}, async (page) => {
      page.on('request', (request) => requests.push(request));
    });
    await visit.ready();
    const [timeOrigin, drawn, own] = await visit.page.evaluate(() => {
      const asked = performance.getEntriesByType('resource').map(({ name, startTime }) => [name, startTime] as const);
      return [performance.timeOrigin, performance.getEntriesByName('first-picture')[0]!.startTime, asked] as const;
    });
    // The page's clock, except for what workers ask for: the browser's clock may be some milliseconds off.
    const begun = new Map(own);
    const asked = new Set(
      requests
        .filter((request) => /^https?:/.test(request.url()) && !request.url().includes('/examples/'))
        .filter((request) => (begun.get(request.url()) ?? request.timing().startTime - timeOrigin) < drawn)
        .map((request) => request.url()),
    );
    const weights = await weightsOf(asked);
    const total = sum(Object.values(weights));
    console.log(`${Math.round(total)} kB`);
    const grown = Object.entries(weights).filter(([part, weight]) => weight > (MAX_WEIGHTS[part] ?? MAX_OTHER_WEIGHT));
    expect(grown).toEqual([]);
    expect(total).toBeGreaterThan(200);
    expect(total).toBeLessThan(MAX_TOTAL_WEIGHT);
    // Neither the other language nor font subsets of unused alphabets.
    expect([...asked].filter((url) => /chinese|greek-wght|latin-wght/.test(url))).toEqual([]);
    await visit.close();
  });
});

/** What parts of the page may weigh before its first picture, compressed [kB]: packages, and folders of ours. */
const MAX_WEIGHTS: Readonly<Record<string, number>> = {
  three: 240,
  'react-dom': 80,
  '@mantine': 75,
  '@floating-ui': 16,
  'src/editor': 60,
  'src/formats': 100,
  'src/graph': 25,
  'src/nodes': 45,
  'src/physics': 20,
  'src/render': 110,
  'src/scene': 90,
  'src/spectrum': 40,
  typefaces: 40,
  styles: 24,
};
const MAX_OTHER_WEIGHT = 12;
const MAX_TOTAL_WEIGHT = 915;

const sum = (values: readonly number[]): number => values.reduce((total, value) => total + value, 0);

/** Weights of files of the page by their parts, compressed [kB]; code as the build notes of what it consists (scripts/page/weights.ts). */
async function weightsOf(urls: ReadonlySet<string>): Promise<Record<string, number>> {
  const parts = JSON.parse(readFileSync('dist/app.weights.json', 'utf8')) as Record<string, Record<string, number>>;
  const weights: Record<string, number> = {};
  for (const url of urls) {
    // From the server, because the browser drops bodies that it has read and may still be loading.
    const body = new Uint8Array(await (await fetch(url)).arrayBuffer());
    const size = (url.endsWith('.woff2') ? body.length : gzipSync(body).length) / 1000;
    const path = new URL(url).pathname.slice(1);
    const shares = parts[path] ?? {
      [path.endsWith('.woff2') ? 'typefaces' : path.endsWith('.css') ? 'styles' : 'page']: 1,
    };
    const whole = sum(Object.values(shares)) || 1;
    for (const [part, share] of Object.entries(shares)) weights[part] = (weights[part] ?? 0) + (size * share) / whole;
  }
  return weights;
}
