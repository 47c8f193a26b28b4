import { readFileSync } from 'node:fs';
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type MonitoredPage, Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const SMALL = '?backend=webgl&scene=examples/sphere.usdc';
const node = (page: Page, id: string) => page.locator(`.react-flow__node[data-id="${id}"]`);
const socket = (page: Page, id: string, name: string) => node(page, id).locator(`[data-socket="${name}"]`);
const edges = (page: Page) => page.locator('.react-flow__edge');
const undone = (page: Page) => page.getByRole('button', { name: /^Undo/ });

async function seriousViolations(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`);
}

/** Dispatches a paste event, as the system clipboard does. */
const paste = (page: Page, words: string) =>
  page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', text);
    document.activeElement?.dispatchEvent(
      new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
    );
  }, words);

const copy = (page: Page): Promise<string> =>
  page.evaluate(() => {
    const clipboardData = new DataTransfer();
    document.activeElement?.dispatchEvent(
      new ClipboardEvent('copy', { clipboardData, bubbles: true, cancelable: true }),
    );
    return clipboardData.getData('text/plain');
  });

async function drag(page: Page, from: readonly [number, number], to: readonly [number, number]): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 4 });
  await page.mouse.move(...to, { steps: 4 });
  await page.mouse.up();
}

async function middle(page: Page, id: string, name?: string): Promise<[number, number]> {
  const box = (await (name ? socket(page, id, name) : node(page, id).locator('.sl-node-head')).boundingBox())!;
  return [box.x + box.width / 2, box.y + box.height / 2];
}

async function opened(options: Parameters<Program['open']>[1]): Promise<MonitoredPage> {
  const visit = await (await program.open(SMALL, options)).ready();
  await visit.page.keyboard.press('Control+Shift+G');
  await node(visit.page, 'output').waitFor();
  return visit;
}

it('nodes are added, connected, set, grouped and copied, by mouse and keyboard, and every step can be undone', async () => {
  const visit = await opened({ viewport: { width: 1280, height: 800 } });
  const { page } = visit;
  const before = await edges(page).count();

  // By keyboard only: a box, connected to the scene in the inspector.
  await page.locator('.sl-flow').focus();
  await page.keyboard.press('Shift+A');
  await page.keyboard.type('box');
  await page.keyboard.press('Enter');
  await expect.poll(() => node(page, 'box').evaluate((card) => card === document.activeElement)).toBe(true);
  const at = (await node(page, 'box').boundingBox())!;
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Shift+ArrowDown');
  await expect.poll(async () => (await node(page, 'box').boundingBox())!.y).toBeGreaterThan(at.y + 20);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await node(page, 'box').boundingBox())!.y).toBeCloseTo(at.y, 0);
  await page.keyboard.press('Enter');
  const name = page.getByRole('textbox', { name: 'Name', exact: true }).first();
  await expect.poll(() => name.evaluate((field) => field === document.activeElement)).toBe(true);
  const width = page.getByRole('textbox', { name: 'Width (x)' });
  await width.fill('50 cm + 2*0.25');
  await width.press('Enter');
  await width.fill('3 s');
  await width.press('Enter');
  expect(await width.getAttribute('aria-invalid')).toBe('true');
  await width.press('Escape');
  expect(await width.inputValue()).toBe('1 m');

  // By mouse: from its socket to the scene's free one; incompatible sockets are not offered.
  const wire = await middle(page, 'box', 'out geometry');
  await page.mouse.move(...wire);
  await page.mouse.down();
  await page.mouse.move(wire[0] + 30, wire[1] + 10, { steps: 3 });
  expect(await socket(page, 'scene', 'in geometry.2').getAttribute('data-unfit')).toBeNull();
  expect(await socket(page, 'scene', 'in lights.1').getAttribute('data-unfit')).toBe('true');
  await page.mouse.move(...(await middle(page, 'scene', 'in geometry.2')), { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => edges(page).count()).toBe(before + 1);
  await expect.poll(() => node(page, 'scene').textContent()).toContain('Objects: 47');
  await visit.shot('graph-connected');

  // An edge dropped on the canvas offers compatible nodes only.
  await drag(page, await middle(page, 'box', 'out geometry'), [wire[0] + 30, wire[1] + 60]);
  const found = page.getByRole('option');
  await expect.poll(() => found.filter({ hasText: 'Transform' }).count()).toBe(1);
  expect(await found.filter({ hasText: 'Tone map' }).count()).toBe(0);
  await page.keyboard.type('transform');
  await page.keyboard.press('Enter');
  await expect.poll(() => edges(page).count()).toBe(before + 2);

  // A drag is one undo step.
  await drag(page, await middle(page, 'transform'), [wire[0] + 60, wire[1] + 90]);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect.poll(() => edges(page).count()).toBe(before + 1);

  // The simple panel marks values driven by a node, too.
  await page.locator('.sl-flow').focus();
  await page.keyboard.press('Space');
  await page.keyboard.type('number');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Home');
  const value = page.getByRole('textbox', { name: 'Value' });
  await value.fill('0.5*c');
  await value.press('Enter');
  expect(await value.getAttribute('aria-invalid')).toBe('true');
  await value.fill('5*sqrt(4)+2');
  await value.press('Enter');
  await drag(page, await middle(page, 'number', 'out number'), await middle(page, 'console'));
  await page.getByRole('option', { name: 'Speed of light' }).click();
  await expect.poll(() => visit.status('c')).toContain('12');
  await page.getByText('Controls', { exact: true }).click();
  await page.getByText('from Number').waitFor();
  await page.getByText('Node', { exact: true }).click();

  // Visible nodes show previews, also to screen readers.
  await page.keyboard.press('Escape');
  const picture = page.getByRole('img', { name: 'Picture of the result of Tone map' });
  await picture.waitFor();
  const kinds = await picture.evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
  expect(kinds).toBeGreaterThan(100);
  await page.getByRole('img', { name: /^Luminance histogram in stops: the median is/ }).waitFor();
  await visit.shot('graph-pictures');
  await page.getByRole('button', { name: 'Pictures on nodes', pressed: true }).click();
  await expect.poll(() => page.locator('.sl-node-picture').count()).toBe(0);
  await page.getByRole('button', { name: 'Pictures on nodes', pressed: false }).click();

  // Groups: connections are preserved, and inside there is a way back.
  await node(page, 'box').locator('.sl-node-head').click();
  await page.keyboard.press('Control+g');
  await node(page, 'group').waitFor();
  await expect.poll(() => edges(page).count()).toBe(before + 2);
  await page.keyboard.press('Control+Enter');
  await node(page, 'box').waitFor();
  await page.getByRole('navigation', { name: 'Groups that are open' }).getByRole('button', { name: 'Project' }).click();
  await page.keyboard.press('Control+Alt+g');
  await node(page, 'box').waitFor();
  await expect.poll(() => visit.status('c')).toContain('12');

  // Mute, frame and copy.
  await node(page, 'box').locator('.sl-node-head').click();
  await page.keyboard.press('m');
  await expect.poll(() => node(page, 'box').locator('[data-muted]').count()).toBe(1);
  await page.keyboard.press('m');
  await page.keyboard.press('f');
  const title = page.getByRole('textbox', { name: 'Title of the frame' });
  await expect.poll(() => title.evaluate((field) => field === document.activeElement)).toBe(true);
  await page.keyboard.type('Mine');
  await page.keyboard.press('Enter');
  await page.locator('.sl-frame', { hasText: 'Mine' }).waitFor();
  await node(page, 'box').locator('.sl-node-head').click();
  const words = await copy(page);
  expect(JSON.parse(words).format).toBe('slowlight-nodes');
  await paste(page, words);
  await node(page, 'box2').waitFor();
  await paste(page, words.replace('"box"', '"no such {"'));
  await visit.refusals.waitFor();
  await page.keyboard.press('Control+k');
  const commands = page.getByRole('combobox', { name: 'Search commands and nodes' });
  await expect.poll(() => commands.evaluate((field) => field === document.activeElement)).toBe(true);
  await page.keyboard.type('select all');
  await page.keyboard.press('Enter');
  await expect.poll(() => page.locator('.react-flow__node.selected').count()).toBeGreaterThan(9);
  await visit.shot('graph-all');
  expect(await seriousViolations(page)).toEqual([]);

  // Undo everything.
  await page.locator('.sl-flow').focus();
  for (let steps = 0; steps < 40 && !(await undone(page).isDisabled()); steps++) await page.keyboard.press('Control+z');
  await expect.poll(() => edges(page).count()).toBe(before);
  expect(await node(page, 'box').count()).toBe(0);
  expect(await visit.status('c')).not.toContain('12');
  await visit.close();
});

it('a large graph on a narrow page, in light colours and in Chinese', async () => {
  const project = JSON.parse(readFileSync(new URL('../../examples/workshop.slowlight.json', import.meta.url), 'utf8'));
  const { version, nodes, edges: wires, layout, notes, frames, groups } = project;
  const held = { version, nodes, edges: wires, layout, notes, frames, groups };
  const words = JSON.stringify({ ...held, format: 'slowlight-nodes' });
  const visit = await opened({ viewport: { width: 390, height: 844 }, colorScheme: 'light', locale: 'zh-CN' });
  const { page } = visit;
  await page.locator('.sl-flow').focus();
  await paste(page, words);
  await paste(page, words);
  await expect.poll(() => page.locator('.react-flow__node').count()).toBeGreaterThan(100);
  await page.keyboard.press('Escape');
  await page.keyboard.press('l');
  await expect.poll(() => page.locator('.sl-flow[data-far]').count()).toBe(1);
  await visit.shot('graph-narrow');
  expect(await seriousViolations(page)).toEqual([]);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);

  // Nodes and commands are found in the page's language and in English.
  const found = page.getByRole('option');
  for (const [keys, query, title] of [
    ['Space', '变换', '变换'],
    ['Space', 'tone map', '色调映射'],
    ['Control+k', '全选', '全选'],
    ['Control+k', 'select all', '全选'],
  ] as const) {
    await page.locator('.sl-flow').focus();
    await page.keyboard.press(keys);
    await page.getByRole('combobox').last().fill(query);
    await expect.poll(() => found.first().textContent(), { message: query }).toContain(title);
    await page.keyboard.press('Escape');
  }
  await visit.close();
});
