import { AxeBuilder } from '@axe-core/playwright';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type MonitoredPage, Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const SMALL = '?backend=webgl&scene=examples/sphere.usdc';
const WORDS = {
  'en-GB': { beaming: 'Beaming', mix: 'Doppler mix', c: 'Speed of light', scene: 'Scene' },
  'zh-CN': { beaming: '聚束', mix: '多普勒混合', c: '光速', scene: '场景' },
} as const;

/** Parts of bars and overlays outside of the window or of their container. Names cut with an ellipsis do not count. */
const outside = (visit: MonitoredPage): Promise<string[]> =>
  visit.page.evaluate(() => {
    const bars = '.sl-header, .sl-timeline, .sl-status, .sl-legend, .sl-caption, .sl-hint';
    const found: string[] = [];
    for (const bar of document.querySelectorAll<HTMLElement>(bars)) {
      const edge = bar.getBoundingClientRect();
      for (const part of [bar, ...bar.querySelectorAll<HTMLElement>('*')]) {
        const { left, right, top, bottom, width } = part.getBoundingClientRect();
        const holder = part.parentElement && getComputedStyle(part.parentElement).textOverflow;
        if (width <= 1 || holder === 'ellipsis') continue;
        const isIn =
          left >= -1 &&
          right <= innerWidth + 1 &&
          right <= edge.right + 1 &&
          top >= edge.top - 9 &&
          bottom <= edge.bottom + 9;
        if (!isIn) found.push(`${bar.className.split(' ')[0]}: ${part.textContent || part.outerHTML.slice(0, 60)}`);
      }
    }
    if (document.documentElement.scrollWidth > innerWidth) found.push('the page');
    return found;
  });

/** Opens the panels where they are a sheet below the picture. */
async function openSheet({ page }: MonitoredPage): Promise<void> {
  const button = page.locator('.sl-sheet-button');
  await button.waitFor();
  if ((await button.getAttribute('aria-expanded')) === 'false') await button.click();
}

async function type(visit: MonitoredPage, name: string, value: string): Promise<void> {
  const field = visit.page.getByRole('textbox', { name, exact: true });
  await field.fill(value);
  await field.press('Enter');
}

async function seriousViolations(visit: MonitoredPage): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page: visit.page }).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`);
}

describe('a narrow page', () => {
  it.each([
    [
      'en-GB',
      [
        [390, 844],
        [320, 640],
        [768, 1024],
      ],
    ],
    [
      'zh-CN',
      [
        [390, 844],
        // 1280 × 720 at 200 %.
        [640, 360],
      ],
    ],
  ] as const)('clips nothing, however long the texts: %s', async (locale, sizes) => {
    const colorScheme = locale === 'en-GB' ? 'dark' : 'light';
    const [width, height] = sizes[0];
    const visit = await (await program.open(SMALL, { viewport: { width, height }, locale, colorScheme })).ready();
    const words = WORDS[locale];
    await expectFit(visit, sizes);
    if (locale === 'en-GB') {
      const text = visit.page.locator('.sl-caption-text');
      const hidden = () => text.evaluate((part) => part.scrollHeight - part.clientHeight);
      expect(await hidden()).toBeGreaterThan(10);
      await visit.page.getByRole('button', { name: 'More', exact: true }).click();
      await expect.poll(hidden).toBeLessThan(2);
      await visit.page.getByRole('button', { name: 'Less', exact: true }).click();
      await expect.poll(hidden).toBeGreaterThan(10);
    }
    await openSheet(visit);
    // The longest numbers possible, and every unphysical setting.
    await type(visit, words.c, '299792458');
    await type(visit, words.beaming, '0.5');
    await type(visit, words.mix, '0.5');
    await visit.viewport.focus();
    await visit.page.keyboard.press('c');
    await visit.page.keyboard.down('Shift');
    await visit.page.keyboard.down('w');
    await expect.poll(() => visit.speed()).toBeGreaterThan(0.9);
    await visit.page.keyboard.up('w');
    await visit.page.keyboard.up('Shift');
    for (let i = 0; i < 4; i++) await visit.page.keyboard.press('x');
    await visit.page.keyboard.press('p');
    await visit.page.locator('[data-reading] b').waitFor();
    await expectFit(visit, sizes, `narrow-${locale}`);
    expect(await seriousViolations(visit)).toEqual([]);
    await visit.page.keyboard.press('Escape');
    await openSheet(visit);
    await visit.page.getByText(words.scene, { exact: true }).last().click();
    await expectFit(visit, sizes, `narrow-${locale}-scene`);
    expect(await seriousViolations(visit)).toEqual([]);
    await visit.close();
  });
});

/** Expects nothing to be clipped at any of these window sizes; the window ends at the first. */
async function expectFit(
  visit: MonitoredPage,
  sizes: readonly (readonly [number, number])[],
  shot?: string,
): Promise<void> {
  for (const [width, height] of [...sizes.slice(1), sizes[0]]) {
    await visit.page.setViewportSize({ width, height });
    await expect.poll(() => visit.page.evaluate(() => innerWidth)).toBe(width);
    await expect.poll(() => outside(visit)).toEqual([]);
    expect(await visit.page.locator('[data-status="gamma"]').isVisible()).toBe(true);
    if (shot) await visit.shot(`${shot}-${width}`);
  }
}

it('every control of the page is reachable by Tab, with visible focus', async () => {
  const visit = await (await program.open(SMALL, { viewport: { width: 1280, height: 720 } })).ready();
  await visit.page.getByRole('textbox', { name: 'Speed of light', exact: true }).waitFor();
  const reached: string[] = [];
  const faint: string[] = [];
  for (let i = 0; i < 70; i++) {
    await visit.page.keyboard.press('Tab');
    const [name, visible] = await visit.page.evaluate(() => {
      const at = document.activeElement as HTMLElement;
      const label = at.getAttribute('aria-label') ?? at.closest('label')?.textContent ?? at.textContent ?? '';
      const around = [at, at.parentElement!, ...(at.nextElementSibling ? [at.nextElementSibling] : [])];
      const shows = around.some((part) => {
        const { outlineStyle, boxShadow, borderColor } = getComputedStyle(part);
        return outlineStyle !== 'none' || boxShadow !== 'none' || (at.matches('input') && borderColor !== '');
      });
      return [`${at.tagName} ${label || at.getAttribute('role') || at.id}`.trim(), shows] as const;
    });
    if (name.includes('Picture. W A S D')) await visit.page.keyboard.press('Escape');
    else if (!visible && !name.startsWith('BODY')) faint.push(name);
    reached.push(name);
  }
  for (const label of ['Scenes', 'Save picture', 'Beaming', 'World time', 'Cruise', 'Controls'])
    expect(
      reached.some((name) => name.includes(label)),
      `${label} in ${reached.join('; ')}`,
    ).toBe(true);
  expect(faint).toEqual([]);
  await visit.close();
});
