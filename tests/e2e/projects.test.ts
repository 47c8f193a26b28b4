import { readFileSync } from 'node:fs';
import { AxeBuilder } from '@axe-core/playwright';
import { unzipSync, zipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { parseDocument } from '../../src/graph/document/parse.ts';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { encodeShareLink } from '../../src/graph/document/shareLink.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';
import { newProject } from '../../src/nodes/project/projectCommands.ts';
import { difference, type MonitoredPage, Program } from './program.ts';
import { ASKED, drop, pinkShare, sceneBytes, serveAsked } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const SQUARE = sceneBytes('textured.usda');
const CHECKER = sceneBytes('textures/checker.png');

/** With manual exposure, so that the same project gives the same picture from the first frame on. */
const manual: Command = { kind: 'set-param', node: 'toneMap', param: 'metering', value: 'manual' };
const still = (source: string) => applyCommand(newProject(source), manual).document;

/** Opens a page on the minimal scene at a URL of the server. */
async function visit(address = '', prepare?: (page: Page) => Promise<void>): Promise<MonitoredPage> {
  return program.open(`?backend=webgl&scene=${ASKED}${address}`, {}, async (page) => {
    await prepare?.(page);
    await serveAsked(page);
  });
}

const exposure = ({ page }: MonitoredPage) => page.getByRole('textbox', { name: 'Exposure' });

async function expose(page: MonitoredPage, value: string): Promise<void> {
  await exposure(page).fill(value);
  await exposure(page).press('Enter');
}

const pink = (page: MonitoredPage) => expect.poll(async () => pinkShare(await page.pixels())).toBeGreaterThan(0.03);
const looksLike = (page: MonitoredPage, picture: Uint8Array) =>
  expect.poll(async () => difference(await page.pixels(), picture)).toBeLessThan(0.5);

async function choose({ page }: MonitoredPage, item: string | RegExp): Promise<void> {
  await page.getByRole('button', { name: 'Project', exact: true }).click();
  await page.getByRole('menuitem', { name: item }).click();
}

async function saved(
  page: MonitoredPage,
  item: string | RegExp,
): Promise<{ readonly name: string; readonly content: Buffer }> {
  const download = page.page.waitForEvent('download');
  await choose(page, item);
  const file = await download;
  return { name: file.suggestedFilename(), content: readFileSync(await file.path()) };
}

describe('a project', () => {
  const project = new TextEncoder().encode(serializeDocument(still('set/square.usda')));
  const files = { 'set/square.usda': new Uint8Array(SQUARE), 'set/textures/checker.png': new Uint8Array(CHECKER) };
  const yard = { name: 'yard.zip', content: Buffer.from(zipSync({ 'project.slowlight.json': project, ...files })) };

  it('opens from a zip, is restored when the page is reloaded, and can be saved and opened again', async () => {
    const page = await (await visit()).ready();
    await drop(page, [yard]);
    await pink(page);
    const name = page.page.getByRole('button', { name: /^Name of the project/ });
    expect(await name.textContent()).toBe('yard');

    await expose(page, '1.5');
    await expect.poll(() => name.getAttribute('data-unsaved')).toBe('true');
    await page.viewport.click();
    await page.page.keyboard.press('ArrowLeft', { delay: 120 });
    await page.page.keyboard.press('Escape');
    await page.page.mouse.move(0, 0);
    const before = await (await page.finest()).pixels();
    // Immediately: the last edit is saved while the page is unloaded.
    await expose(page, '2');
    await expose(page, '1.5');
    await page.page.reload();
    await page.ready();
    await looksLike(page, before);
    expect(await exposure(page).inputValue()).toMatch(/^1\.5/);
    expect(await name.textContent()).toMatch(/^yard/);
    expect(await page.page.getByRole('button', { name: /^Undo/ }).isDisabled()).toBe(true);
    await page.shot('project-restored');

    await expose(page, '0.5');
    await page.page.getByRole('button', { name: /^Undo: Exposure/ }).click();
    const words = await saved(page, 'Save project');
    expect(words.name).toBe('yard.slowlight.json');
    const document = parseDocument(words.content.toString('utf8'));
    expect(document.nodes.read?.params).toEqual({ source: 'set/square.usda' });
    expect(document.nodes.toneMap?.params).toEqual({ exposure: 1.5, metering: 'manual' });
    expect(await name.getAttribute('data-unsaved')).toBe('false');
    const all = await saved(page, 'Save with its files');
    expect(Object.keys(unzipSync(new Uint8Array(all.content))).sort()).toEqual([
      'project.slowlight.json',
      'set/square.usda',
      'set/textures/checker.png',
    ]);

    // Another URL starts anew.
    await page.page.goto(`${program.url}/?scene=${ASKED}&backend=webgl`);
    await page.ready();
    await drop(page, [all]);
    await pink(page);
    expect(await exposure(page).inputValue()).toMatch(/^1\.5/);
    await page.page.getByRole('button', { name: /^Undo: open a project/ }).click();
    await expect.poll(() => exposure(page).inputValue()).toMatch(/^0/);
    await page.close();
  });

  it('that is damaged is rejected with file and place, and the picture stays', async () => {
    const page = await (await visit()).ready();
    await pink(page);
    const broken = JSON.parse(new TextDecoder().decode(project));
    broken.nodes.read.params.source = { no: 'text' };
    await drop(page, [{ name: 'broken.slowlight.json', content: Buffer.from(JSON.stringify(broken)) }]);
    await page.refusals.waitFor();
    expect(await page.refusals.textContent()).toMatch(/broken\.slowlight\.json.*nodes\.read\.params\.source/);
    expect(await page.page.getByRole('button', { name: /^Undo/ }).isDisabled()).toBe(true);
    await page.refusals.getByRole('button', { name: 'Close' }).click();

    // Without its scene: that is reported, and can be supplied.
    await drop(page, [{ name: 'alone.slowlight.json', content: Buffer.from(project) }]);
    await page.refusals.waitFor();
    expect(await page.refusals.textContent()).toMatch(/square\.usda.*last valid scene/);
    await pink(page);
    await drop(page, [
      { name: 'square.usda', content: SQUARE },
      { name: 'checker.png', content: CHECKER },
    ]);
    await expect.poll(() => page.refusals.count()).toBe(0);
    await expect.poll(() => page.page.locator('[data-opened]').getAttribute('data-opened')).toMatch(/alone/);
    await page.close();
  });
});

describe('a link', () => {
  it('contains the project, and shows the same picture', async () => {
    const page = await (await visit()).ready();
    await page.page.getByRole('radiogroup', { name: 'Metering' }).getByText('Manual').click();
    await expose(page, '-1');
    await page.page.mouse.move(0, 0);
    await pink(page);
    const shown = await (await page.finest()).pixels();
    await choose(page, /^Share/);
    const link = await page.page.getByRole('textbox', { name: 'Link' }).inputValue();
    await page.settled();
    await page.shot('project-share');
    const { violations } = await new AxeBuilder({ page: page.page }).analyze();
    expect(violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')).toEqual([]);
    const [, fragment = ''] = link.split('#');

    const other = await (await visit(`#${fragment}`)).ready();
    await looksLike(other, shown);
    expect(await exposure(other).inputValue()).toMatch(/^-1/);
    // Followed within the page, it is an undoable step.
    await other.page.evaluate(
      (next) => {
        location.hash = next;
      },
      encodeShareLink(still(ASKED)),
    );
    await expect.poll(() => exposure(other).inputValue()).toMatch(/^0/);
    await other.page.getByRole('button', { name: /^Undo: open a project/ }).click();
    await other.close();

    await page.close();
  });
});

/** The projects that the page keeps in the browser, as JSON. */
const storedProjects = ({ page }: MonitoredPage): Promise<string> =>
  page.evaluate(
    () =>
      new Promise<string>((resolve, reject) => {
        const opening = indexedDB.open('slowlight');
        opening.onerror = () => reject(opening.error);
        opening.onsuccess = () => {
          const all = opening.result.transaction('sessions').objectStore('sessions').getAll();
          all.onerror = () => reject(all.error);
          all.onsuccess = () => {
            opening.result.close();
            resolve(JSON.stringify(all.result));
          };
        };
      }),
  );

describe('stored sessions', () => {
  it('the session of a closed tab is offered in the next one, not while it is open', async () => {
    const page = await (await visit()).ready();
    await expose(page, '3');
    await expect.poll(() => storedProjects(page)).toContain('"exposure":3');
    const address = '?backend=webgl&scene=examples/sphere.usdc';
    const second = await (await program.beside(page, address)).ready();
    expect(await second.page.getByText('There is unsaved work').count()).toBe(0);
    await second.page.close();
    await page.page.close();
    const third = await (await program.beside(page, address)).ready();
    await third.page.getByText(/There is unsaved work from .*: asked/).waitFor();
    await third.shot('project-earlier');
    await serveAsked(third.page);
    await third.page.getByRole('button', { name: 'Restore' }).click();
    await expect.poll(() => exposure(third).inputValue()).toMatch(/^3/);
    await third.close();
  });

  it('the page reports missing browser storage, or a truncated link, and works on', async () => {
    const damaged = `#${encodeShareLink(still(ASKED)).slice(0, -20)}`;
    const page = await visit(damaged, async (tab) => {
      await tab.addInitScript(() => {
        IDBFactory.prototype.open = () => {
          throw new DOMException('storage is refused', 'SecurityError');
        };
      });
    });
    await page.ready();
    expect(await page.refusals.textContent()).toMatch(/the link: .*cut off or changed/);
    await pink(page);
    await page.shot('project-cut-link');
    await page.refusals.getByRole('button', { name: 'Close' }).click();
    await expose(page, '2');
    await page.refusals.waitFor();
    expect(await page.refusals.textContent()).toMatch(/cannot store your work \(storage is refused\)/);
    await page.page.getByRole('button', { name: /^Undo: Exposure/ }).click();
    await expect.poll(() => exposure(page).inputValue()).toMatch(/^0/);
    await page.close();
  });
});
