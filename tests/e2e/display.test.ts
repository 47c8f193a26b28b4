import { AxeBuilder } from '@axe-core/playwright';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { falseColor } from '../../src/spectrum/falseColor/falseColor.ts';
import { colorCount, difference, type MonitoredPage, Program, sharedPage } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const WIDE = { width: 1280, height: 720 };
/** A ball that passes at 0.5 c; without false colours. */
const moving = sharedPage(async () =>
  (await program.open('?backend=webgl&scene=examples/sphere.usdc', { viewport: WIDE })).ready(),
);

const choose = (visit: MonitoredPage, group: string, option: string) =>
  visit.page.getByRole('radiogroup', { name: group }).getByText(option, { exact: true }).click();
const legendOf = (visit: MonitoredPage) => visit.page.getByRole('figure');
const reading = async (visit: MonitoredPage) => (await visit.page.locator('[data-reading]').textContent()) ?? '';

/** Expects the colour in the middle of the picture to be that of the displayed value on the displayed scale; both have three digits. */
function expectColor(shown: readonly number[], told: string, range: string): void {
  const [D, to] = [/D = ([\d.]+)/.exec(told), /to D = ([\d.]+)/.exec(range)].map((match) => Number(match?.[1]));
  falseColor({ kind: 'doppler', from: 1 / to!, to: to! }, D!).forEach((value, k) => {
    expect(Math.abs(value - shown[k]!)).toBeLessThanOrEqual(6);
  });
}

async function seriousViolations(visit: MonitoredPage): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page: visit.page }).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`);
}

/** Mean of all channels, 0 … 255. */
const brightness = (pixels: Uint8Array): number => pixels.reduce((sum, value) => sum + value, 0) / pixels.length;

describe('exposure and tone', () => {
  it('metering follows the light, keeps the exposure of an observer at rest, or is off', async () => {
    const visit = await (await (await program.open('?backend=webgl&scene=examples/lattice.usdc')).ready()).finest();
    const automatic = await visit.pixels();
    await choose(visit, 'Metering', 'Manual');
    const dimmed = async () => Math.abs(brightness(await visit.pixels()) - brightness(automatic));
    await expect.poll(dimmed).toBeGreaterThan(3);
    await choose(visit, 'Metering', 'Automatic');
    // Wait until every pixel has all its samples again.
    const other = async () => difference(await visit.pixels(), automatic);
    await expect.poll(other).toBeLessThan(0.5);
    await choose(visit, 'Tone curve', 'AgX');
    await expect.poll(async () => difference(await visit.pixels(), automatic)).toBeGreaterThan(1);
    await visit.close();
  });
});

describe('a ghost', () => {
  it('is drawn over the picture, with a legend, and marked as not physical', async () => {
    const visit = await (await program.open('?backend=webgl&scene=examples/sphere.usdc', { viewport: WIDE })).ready();
    const before = await (await visit.finest()).pixels();
    await visit.page.getByRole('combobox', { name: 'Ghost' }).click();
    await visit.page.getByRole('option', { name: 'Simultaneity' }).click();
    const legend = visit.page.locator('[data-overlay-legend]');
    await legend.getByText('Ghost: Simultaneity').waitFor();
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeGreaterThan(0.2);
    await visit.page.getByText('Past and future', { exact: true }).waitFor();
    await visit.page.getByRole('switch', { name: 'Past and future' }).press('Space');
    await legend.getByText('Future, by the world’s clocks').waitFor();
    const status = visit.page.locator('[data-status="unphysical"]');
    await expect.poll(() => status.textContent()).toContain('Ghost, Past and future');
    expect(await visit.page.getByText('not physical', { exact: true }).count()).toBe(2);
    expect(await seriousViolations(visit)).toEqual([]);
    await visit.shot('ghost');
    await visit.page.setViewportSize({ width: 420, height: 760 });
    await visit.shot('ghost-narrow');
    await visit.page.setViewportSize(WIDE);
    await visit.page.getByRole('switch', { name: 'Past and future' }).press('Space');
    await visit.page.getByRole('combobox', { name: 'Ghost' }).click();
    await visit.page.getByRole('option', { name: 'None' }).click();
    await legend.waitFor({ state: 'detached' });
    await visit.finest();
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeLessThan(0.5);
    await visit.close();
  });
});

describe('false colours', () => {
  it('have an accessible legend, in dark and light colours', async () => {
    const visit = await moving();
    for (const [option, title] of [
      ['Doppler', 'Doppler factor D'],
      ['Time', 'Happened, from now'],
      ['Light', 'Luminance before exposure'],
      ['Band', 'Seen at 550 nm, emitted at [nm]'],
    ] as const) {
      await choose(visit, 'False colours', option);
      await legendOf(visit).getByText(title).waitFor();
      await expect.poll(async () => colorCount(await visit.pixels())).toBeGreaterThan(5);
      const box = (await visit.viewport.boundingBox())!;
      await visit.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await expect.poll(() => reading(visit)).toMatch(/\d/);
      await visit.shot(`false-${option.toLowerCase()}`);
    }
    for (const colorScheme of ['light', 'dark'] as const) {
      await visit.page.emulateMedia({ colorScheme });
      await visit.page.locator(`[data-mantine-color-scheme="${colorScheme}"]`).waitFor({ state: 'attached' });
      await visit.shot(`false-band-${colorScheme}`);
      expect(await seriousViolations(visit)).toEqual([]);
    }
    await choose(visit, 'False colours', 'Off');
    await legendOf(visit).waitFor({ state: 'detached' });
  });

  it('can be set and read by keyboard only', async () => {
    const visit = await moving();
    await visit.viewport.focus();
    await visit.page.keyboard.press('x');
    await legendOf(visit).waitFor();
    expect(await reading(visit)).toContain('press P');
    await visit.page.keyboard.press('p');
    await expect.poll(() => reading(visit)).toMatch(/D = [\d.]+/);
    const button = visit.page.getByRole('button', { name: 'Value at the crosshair' });
    expect(await button.getAttribute('aria-pressed')).toBe('true');
    await visit.shot('false-crosshair');
    const before = await reading(visit);
    expectColor(await visit.middle(), before, (await visit.page.locator('.sl-legend-bar').getAttribute('aria-label'))!);
    // Another value is to the side.
    await visit.page.keyboard.press('ArrowRight', { delay: 800 });
    await expect.poll(() => reading(visit)).not.toBe(before);
    await visit.page.keyboard.press('p');
    await choose(visit, 'False colours', 'Off');
    await legendOf(visit).waitFor({ state: 'detached' });
  });

  it('fit a phone', async () => {
    const visit = await moving();
    await visit.page.setViewportSize({ width: 390, height: 844 });
    await expect.poll(() => visit.page.evaluate(() => innerWidth)).toBe(390);
    await visit.viewport.focus();
    for (let i = 0; i < 4; i++) await visit.page.keyboard.press('x');
    await legendOf(visit).waitFor();
    await visit.settled();
    await visit.shot('false-band-phone');
    expect(await visit.page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    await visit.page.keyboard.press('x');
    await legendOf(visit).waitFor({ state: 'detached' });
    await visit.page.setViewportSize(WIDE);
  });
});

it('unphysical settings are marked at their controls and in the status bar', async () => {
  const visit = await moving();
  const note = visit.page.locator('[data-status="unphysical"]');
  expect(await note.count()).toBe(0);
  const field = visit.page.getByRole('textbox', { name: 'Beaming' });
  await field.fill('0.5');
  await field.press('Enter');
  await expect.poll(() => note.textContent()).toBe('Not physical: Beaming');
  await visit.page.getByText('not physical', { exact: true }).waitFor();
  await visit.shot('unphysical-en');
  expect(await seriousViolations(visit)).toEqual([]);
  await visit.chooseLanguage('中文');
  await expect.poll(() => note.textContent()).toBe('非物理：聚束');
  await visit.shot('unphysical-zh');
  await visit.page.keyboard.press('Control+z');
  await expect.poll(() => note.count()).toBe(0);
  await visit.page.getByRole('switch', { name: '光的延迟' }).press('Space');
  await expect.poll(() => note.textContent()).toBe('非物理：光的延迟');
  await choose(visit, '视图', 'c = ∞');
  await expect.poll(() => note.count(), { message: 'where it does not matter' }).toBe(0);
});
