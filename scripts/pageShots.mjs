// Screenshots of the page for the docs: `npm run pictures -- graph`.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { join } from 'node:path';
import { root } from './setup.mjs';
import { toWebp } from './webp.mjs';

/** The graph with a box added to the scene, and the console node in the inspector. */
export async function shootGraph() {
  const [{ chromium }, { findChromium, SOFTWARE_GPU_FLAGS }] = await Promise.all([
    import('playwright-core'),
    import(join(root, 'dist/lib/cli/gpu/gpuDrivers.js')),
  ]);
  const server = spawn(process.execPath, [join(root, 'bin/slowlight.js'), 'serve', '--port', '0', '--json']);
  const [line] = await once(server.stdout, 'data');
  const browser = await chromium.launch({ executablePath: findChromium(), args: [...SOFTWARE_GPU_FLAGS] });
  try {
    const viewport = { width: 1440, height: 900 };
    const page = await browser.newPage({ viewport, colorScheme: 'dark', reducedMotion: 'reduce', locale: 'en-GB' });
    await page.goto(`${JSON.parse(line.toString()).url}/?backend=webgl&scene=examples/sphere.usdc`);
    await page.locator('[data-status="backend"]', { hasText: 'Web' }).waitFor();
    await page.getByRole('button', { name: 'Hide' }).click();
    await page.keyboard.press('Control+Shift+G');
    const node = (id) => page.locator(`.react-flow__node[data-id="${id}"]`);
    await node('scene').waitFor();
    await addBox(page, node);
    await node('console').click();
    await page.waitForTimeout(3000);
    await page.screenshot({ path: join(root, '.cache/pictures/graph.png') });
    toWebp('.cache/pictures/graph.png', 'docs/pictures/graph.webp');
  } finally {
    await browser.close();
    server.kill();
  }
}

async function addBox(page, node) {
  const add = async (name) => {
    await page.locator('.sl-flow').focus();
    await page.keyboard.press('Shift+A');
    await page.keyboard.type(name);
    await page.keyboard.press('Enter');
  };
  await add('box');
  await node('box').waitFor();
  await add('transform');
  await node('transform').waitFor();
  const feed = async (label, source) => {
    await page.getByRole('combobox', { name: label }).first().click();
    await page.getByRole('option', { name: source }).click();
  };
  await feed('Geometry', 'Box');
  const width = page.getByRole('textbox', { name: 'Position x' });
  await width.fill('-2');
  await width.press('Enter');
  await node('scene').click();
  await feed('Geometry 2', 'Transform');
  await page.locator('.sl-flow').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('l');
}
