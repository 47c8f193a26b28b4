// Screenshots of the page for the docs, and its icons: `npm run pictures -- graph icons`.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './setup.mjs';
import { toWebp } from './webp.mjs';

/** Icons of the installed program: sizes [px], and the part of each that the drawing fills; masks cut circles out of theirs. */
const ICONS = {
  'icon-192': [192, 1],
  'icon-512': [512, 1],
  'icon-maskable-512': [512, 0.6],
  'apple-touch-icon': [180, 0.8],
};

/** Draws src/app/icon.svg as the PNGs that systems ask for. */
export async function drawIcons() {
  const [{ chromium }, { findChromium }] = await Promise.all([
    import('playwright-core'),
    import(join(root, 'dist/lib/cli/gpu/gpuDrivers.js')),
  ]);
  const drawing = readFileSync(join(root, 'src/app/icon.svg'), 'utf8');
  const browser = await chromium.launch({ executablePath: findChromium() });
  try {
    for (const [name, [size, part]] of Object.entries(ICONS)) {
      const page = await browser.newPage({ viewport: { width: size, height: size } });
      const ground = part < 1 ? '#1b2029' : 'transparent';
      await page.setContent(
        `<body style="margin:0;height:100vh;display:grid;place-items:center;background:${ground}">${drawing.replace('<svg', `<svg width="${size * part}"`)}</body>`,
      );
      await page.screenshot({ path: join(root, `src/app/icons/${name}.png`), omitBackground: true });
      await page.close();
    }
  } finally {
    await browser.close();
  }
}

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
