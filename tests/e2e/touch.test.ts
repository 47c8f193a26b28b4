import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { difference, type MonitoredPage, Program } from './program.ts';
import { Touches } from './touches.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const PHONE = { width: 390, height: 844 };
const DEVICES = {
  'a small phone': { width: 360, height: 740 },
  'a phone': PHONE,
  'a phone, held across': { width: 844, height: 390 },
  'a tablet': { width: 820, height: 1180 },
  'a handheld console': { width: 1280, height: 800 },
} as const;

const opened = async (scene: string, viewport: { width: number; height: number }): Promise<MonitoredPage> => {
  const options = { hasTouch: true, isMobile: true, viewport };
  const visit = await (await program.open(`?backend=webgl&scene=examples/${scene}.usdc`, options)).ready();
  await controlsOf(visit.page).pad.waitFor();
  return visit;
};

const controlsOf = (page: Page) => ({
  pad: page.getByRole('button', { name: /^Thrust pad/ }),
  brake: page.getByRole('button', { name: 'Brake' }),
  rise: page.getByRole('button', { name: 'Rise' }),
  speed: page.getByRole('slider', { name: 'Speed that is held' }),
});

describe('a touched page', () => {
  it.each(['a phone', 'a tablet'] as const)(
    '%s flies by its pad, looks around beside it, keeps a speed, and brakes',
    async (name) => {
      const visit = await opened('sphere', DEVICES[name]);
      const { page } = visit;
      const { pad, brake, speed } = controlsOf(page);
      const touches = await Touches.on(page);
      // With a velocity and in place: the picture changes by looking alone.
      await page.getByRole('button', { name: 'Lock: Free' }).tap();
      const radius = (await pad.boundingBox())!.width / 2;
      await touches.downOn(1, pad, [0, -20]);
      // Within the rim up to half of the greatest speed, 0.95 c.
      await expect.poll(() => visit.speed()).toBeCloseTo((0.475 * 20) / radius, 2);
      await visit.finest();
      const before = await visit.pixels();
      await touches.downOn(2, visit.viewport, [0, -60]);
      await touches.move(2, 90, 0);
      await visit.finest();
      expect(difference(before, await visit.pixels())).toBeGreaterThan(1);
      await touches.up(2);
      await visit.shot(`touch-flies-${DEVICES[name].width}`);
      await touches.move(1, 0, -120);
      await expect.poll(() => visit.speed()).toBeGreaterThan(0.9);
      await touches.up(1);
      await expect.poll(() => visit.speed()).toBe(0);
      // The slider asks for 0.95 c at its top, and half the rapidity is the speed v with 2v/(1 + v²) = 0.95.
      await speed.fill('0.5');
      const half = (1 - Math.sqrt(1 - 0.95 ** 2)) / 0.95;
      await expect.poll(() => visit.speed()).toBeCloseTo(half, 3);
      expect(await speed.getAttribute('aria-valuetext')).toMatch(/^0\.72\d* c$/);
      await touches.downOn(1, brake);
      await expect.poll(() => visit.speed()).toBe(0);
      await touches.up(1);
      expect(await speed.inputValue()).toBe('0');
      await visit.close();
    },
  );

  it('two fingers change the field of view, which is one step to undo', async () => {
    const visit = await opened('sphere', DEVICES['a tablet']);
    const { page } = visit;
    const field = page.getByRole('textbox', { name: 'Field of view', exact: true });
    const degrees = async () => Number.parseFloat(await field.inputValue());
    const before = await degrees();
    const touches = await Touches.on(page);
    await touches.downOn(1, visit.viewport, [-40, -100]);
    await touches.downOn(2, visit.viewport, [40, -100]);
    // What is within the tolerance of a spread does not count: from 100 px on, to 200 px.
    await touches.move(2, 20, 0, 1);
    await touches.move(2, 100, 0);
    await touches.up(1);
    await touches.up(2);
    const half = (angle: number) => Math.tan((angle * Math.PI) / 360);
    await expect.poll(async () => half(await degrees()) / half(before)).toBeCloseTo(0.5, 2);
    await page.getByRole('button', { name: 'Undo: Field of view' }).tap();
    await expect.poll(degrees).toBe(before);
    await visit.close();
  });

  it('a tap inspects, and a finger that rests opens a menu, by which one is flown to what is there', async () => {
    const visit = await opened('sphere', PHONE);
    const { page } = visit;
    const touches = await Touches.on(page);
    // It lies over the middle of the picture.
    await page.getByRole('button', { name: 'Hide' }).tap();
    const { x, y, width, height } = (await visit.viewport.boundingBox())!;
    const middle = [x + width / 2, y + height / 2] as const;
    const card = page.locator('[data-inspection]');
    await page.touchscreen.tap(...middle);
    await card.getByText('Distance then').waitFor();
    const path = await card.locator('bdi').textContent();
    expect(path).toMatch(/^\//);
    await visit.shot('touch-inspects');
    await card.getByRole('button', { name: 'Close' }).tap();
    await card.waitFor({ state: 'detached' });
    await touches.down(1, ...middle);
    const menu = page.getByRole('menu');
    await menu.waitFor();
    await touches.up(1);
    await visit.settled();
    await visit.shot('touch-menu');
    expect(await menu.getByText(path!).count()).toBe(1);
    const { violations } = await new AxeBuilder({ page }).include('[role=menu]').include('.sl-touch').analyze();
    expect(violations).toEqual([]);
    await menu.getByRole('menuitem', { name: 'Fly there' }).tap();
    await page.getByRole('button', { name: 'Flight: Autopilot' }).waitFor();
    await expect.poll(() => visit.speed()).toBeGreaterThan(0);
    await expect.poll(() => visit.speed()).toBe(0);
    await visit.close();
  });
});

it('the menu opens by a right click and by its key as well', async () => {
  const visit = await (await program.open('?backend=webgl&scene=examples/sphere.usdc')).ready();
  const { page } = visit;
  const menu = page.getByRole('menu');
  await visit.viewport.click({ button: 'right' });
  await menu.getByRole('menuitem', { name: 'Inspect what is seen' }).click();
  await page.locator('[data-inspection]').waitFor();
  await visit.viewport.focus();
  await page.keyboard.press('Shift+F10');
  await menu.waitFor();
  await page.keyboard.press('Escape');
  await menu.waitFor({ state: 'detached' });
  await visit.close();
});

it.each(Object.entries(DEVICES))('on %s the flight controls cover neither texts nor legends', async (_name, size) => {
  const visit = await opened('dice', size);
  const { page } = visit;
  const overlaps = () =>
    page.evaluate(() => {
      const boxes = (selector: string) =>
        [...document.querySelectorAll(selector)].map((part) => ({
          name: part.className,
          ...(part.getBoundingClientRect().toJSON() as DOMRect),
        }));
      const texts = boxes('.sl-caption, .sl-hint, .sl-legend, .sl-top-card');
      return boxes('.sl-touch-pad, .sl-touch-button, .sl-touch-throttle').flatMap((control) =>
        texts
          .filter(
            (text) =>
              text.left < control.right &&
              text.right > control.left &&
              text.top < control.bottom &&
              text.bottom > control.top,
          )
          .map((text) => `${control.name}: ${text.name}`),
      );
    });
  await expect.poll(overlaps).toEqual([]);
  await visit.shot(`touch-${size.width}`);
  await visit.close();
});

/** What a finger 21 px beside the middle of a control would miss: fields, buttons and sliders that are in view. */
const smallTargets = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const controls = 'button, a, input:not([type=file]), [role=tab], [role=slider], [role=switch], [role=combobox]';
    const missed: string[] = [];
    for (const control of document.querySelectorAll<HTMLElement>(controls)) {
      // Switches and segments are hit by their labels.
      const label = control.closest('label') ?? document.querySelector(`label[for="${control.id}"]`);
      const hit = control.matches('[role=switch], [type=radio]') && label ? label : control;
      const { left, top, width, height } = hit.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      const isSeen = width > 1 && hit.checkVisibility({ visibilityProperty: true }) && !control.closest('[inert]');
      const within = document.elementFromPoint(x, y);
      if (!isSeen || !within || !hit.contains(within)) continue;
      const scrolled = control.closest('.mantine-ScrollArea-viewport')?.getBoundingClientRect();
      if (scrolled && (y - 22 < scrolled.top || y + 22 > scrolled.bottom)) continue;
      // A slider is hit along all of its track.
      const target = control.closest('.mantine-Slider-root') ?? hit;
      const beside = [
        [x - 21, y],
        [x + 21, y],
        [x, y - 21],
        [x, y + 21],
      ] as const;
      const name = control.getAttribute('aria-label') ?? control.textContent;
      for (const [px, py] of beside)
        if (
          px > 0 &&
          py > 0 &&
          px < innerWidth &&
          py < innerHeight &&
          !target.contains(document.elementFromPoint(px, py))
        )
          missed.push(`${control.tagName} ${name} at ${px - x}, ${py - y}`);
    }
    return missed;
  });

describe.each(['a small phone', 'a phone', 'a tablet'] as const)('on %s', (name) => {
  it('whatever is tapped is at least 44 px large, and nothing is cut', async () => {
    const visit = await opened('dice', DEVICES[name]);
    const { page } = visit;
    await expect.poll(() => smallTargets(page)).toEqual([]);
    const sheet = page.getByRole('button', { name: 'Panels' });
    if (name !== 'a tablet') {
      await sheet.waitFor();
      // A tab opens the sheet, and closes it.
      const tab = page.getByRole('tab', { name: 'Controls' });
      const pictureHeight = async () => (await visit.viewport.boundingBox())!.height;
      const before = await pictureHeight();
      await tab.tap();
      await expect.poll(() => sheet.getAttribute('aria-expanded')).toBe('true');
      expect(await pictureHeight()).toBeLessThan(0.7 * before);
      await page.getByRole('textbox', { name: 'Speed of light', exact: true }).waitFor();
      await expect.poll(() => smallTargets(page)).toEqual([]);
      await visit.settled();
      await visit.shot(`touch-sheet-${DEVICES[name].width}`);
      await tab.tap();
      await expect.poll(() => sheet.getAttribute('aria-expanded')).toBe('false');
      // A drag up opens it as far as the finger goes.
      const touches = await Touches.on(page);
      await touches.downOn(1, tab);
      await touches.move(1, 0, -200);
      await touches.up(1);
      await expect.poll(pictureHeight).toBeCloseTo(before - 200, -1);
      await page.getByRole('button', { name: 'More' }).tap();
      await page.getByRole('menuitem', { name: 'Keys and help' }).tap();
      await page.getByRole('dialog').getByText('Thrust pad').waitFor();
      await visit.settled();
      await visit.shot(`touch-help-${DEVICES[name].width}`);
      await page.getByRole('dialog').getByRole('button', { name: 'Close' }).tap();
    }
    const wide = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(await wide()).toBeLessThanOrEqual(0);
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]!.html}`)).toEqual([]);
    await visit.close();
  });
});

it('a phone that is turned has its panels beside the picture, and below it again', async () => {
  const visit = await opened('sphere', PHONE);
  const { page } = visit;
  await page.getByRole('button', { name: 'Panels', expanded: false }).waitFor();
  const picture = async () => (await visit.viewport.boundingBox())!;
  const upright = await picture();
  await page.setViewportSize({ width: PHONE.height, height: PHONE.width });
  // Wider than upright, beside panels of at least 264 px.
  await expect.poll(async () => (await picture()).width).toBeGreaterThan(upright.width);
  await expect.poll(async () => (await picture()).width).toBeLessThan(PHONE.height - 260);
  await page.getByRole('textbox', { name: 'Speed of light', exact: true }).waitFor();
  await page.setViewportSize(PHONE);
  await expect.poll(async () => (await picture()).width).toBe(upright.width);
  await page.getByRole('button', { name: 'Panels', expanded: true }).tap();
  await expect.poll(async () => (await picture()).height).toBe(upright.height);
  await visit.close();
});

it('a device is a window where one asks for it: the picture turns as it is turned, and back', async () => {
  const visit = await opened('sphere', PHONE);
  const { page } = visit;
  const session = await page.context().newCDPSession(page);
  const hold = (alpha: number, beta: number) =>
    session.send('DeviceOrientation.setDeviceOrientationOverride', { alpha, beta, gamma: 0 });
  await hold(0, 90);
  await page.getByRole('button', { name: /^Flight: / }).tap();
  await visit.settled();
  await page.getByRole('switch', { name: 'Look around by turning the device' }).tap();
  await page.keyboard.press('Escape');
  await visit.settled();
  await visit.finest();
  const ahead = await visit.pixels();
  await hold(40, 80);
  await expect.poll(async () => difference(ahead, await visit.pixels())).toBeGreaterThan(1);
  await hold(0, 90);
  await expect.poll(async () => difference(ahead, await visit.pixels())).toBeLessThan(0.2);
  await visit.close();
});
