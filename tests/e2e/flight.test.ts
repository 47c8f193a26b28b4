import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { colorCount, difference, type MonitoredPage, Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const STREET = '?backend=webgl&scene=examples/street.usdc';
/** For tests of controls: it opens sooner. */
const SMALL = '?backend=webgl&scene=examples/sphere.usdc';

async function withKeys(held: MonitoredPage, keys: readonly string[], until: () => Promise<void>): Promise<void> {
  for (const key of keys) await held.page.keyboard.down(key);
  await until();
  for (const key of [...keys].reverse()) await held.page.keyboard.up(key);
}

describe('flight', () => {
  it('W accelerates smoothly, Shift further, and releasing brakes to rest', async () => {
    const visit = await (await program.open(STREET)).ready();
    const before = await (await visit.finest()).pixels();
    await visit.viewport.click();
    await withKeys(visit, ['w'], async () => {
      await expect.poll(() => visit.speed()).toBeGreaterThan(0.05);
      await expect.poll(async () => Number(/[\d.]+/.exec(await visit.status('gamma'))?.[0])).toBeGreaterThan(1);
      await withKeys(visit, ['Shift'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.8));
      await visit.shot('flight-fast');
    });
    await expect.poll(() => visit.speed()).toBe(0);
    expect(difference(await visit.pixels(), before)).toBeGreaterThan(1);
    await visit.close();
  });

  it('without time for more, it flies without a G-buffer, unless told otherwise; at rest it has one', async () => {
    const visit = await (await program.open(STREET, { viewport: { width: 1280, height: 800 } })).ready();
    const button = visit.page.locator('[data-status="shading"]');
    const shading = () => button.getAttribute('data-shading');
    expect(await shading()).toBe('deferred');
    await visit.viewport.click();
    await withKeys(visit, ['ArrowLeft'], async () => {
      await expect.poll(shading).toBe('forward');
      await visit.shot('flight-forward');
      expect(colorCount(await visit.pixels())).toBeGreaterThan(100);
      await button.click();
      expect(await button.getAttribute('aria-pressed')).toBe('true');
    });
    await visit.viewport.click();
    await withKeys(visit, ['ArrowLeft'], async () => {
      await expect.poll(shading).toBe('deferred');
      await visit.shot('flight-deferred');
    });
    await button.click();
    await expect.poll(shading).toBe('deferred');
    await visit.close();
  });

  it('Tab cycles the locks while the picture has focus; after Escape Tab moves the focus again', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const lock = visit.page.locator('[data-lock]');
    await visit.viewport.focus();
    for (const name of ['look', 'fly', 'free']) {
      await visit.page.keyboard.press('Tab');
      await expect.poll(() => lock.getAttribute('data-lock')).toBe(name);
    }
    await visit.page.keyboard.press('Escape');
    await visit.page.keyboard.press('Tab');
    expect(await lock.getAttribute('data-lock')).toBe('free');
    expect(await visit.viewport.evaluate((element) => element === document.activeElement)).toBe(false);
    await visit.close();
  });

  it('lock look: velocity distorts the picture without motion; R returns to the start', async () => {
    const visit = await (await program.open(STREET)).ready();
    const before = await (await visit.finest()).pixels();
    await visit.viewport.click();
    await visit.page.keyboard.press('Tab');
    await visit.page.keyboard.press('c');
    await withKeys(visit, ['Shift', 'w'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.8));
    await visit.shot('flight-look');
    expect(difference(await visit.pixels(), before)).toBeGreaterThan(2);
    await visit.page.keyboard.press('r');
    await visit.page.keyboard.press('Escape');
    await expect.poll(() => visit.speed()).toBe(0);
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeLessThan(2);
    await visit.close();
  });

  it('flight keys work everywhere except in text fields', async () => {
    const visit = await (await program.open(SMALL)).ready();
    await visit.page.getByRole('textbox', { name: 'Speed of light' }).focus();
    await visit.page.keyboard.press('w');
    expect(await visit.viewport.evaluate((element) => element === document.activeElement)).toBe(false);
    await visit.page.getByRole('button', { name: 'Scenes' }).focus();
    await withKeys(visit, ['w'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.05));
    await visit.close();
  });

  it('dragging turns the camera', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const before = await (await visit.finest()).pixels();
    await visit.viewport.hover({ position: { x: 300, y: 150 } });
    await visit.page.mouse.down();
    await visit.page.mouse.move(500, 200, { steps: 4 });
    await visit.page.mouse.up();
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeGreaterThan(1);
    await visit.close();
  });

  it('time plays, pauses, and can be scrubbed', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const time = async () => Number(/([\d.]+) s/.exec(await visit.status('world-time'))?.[1]);
    const begin = await time();
    await visit.page.getByRole('button', { name: 'Play' }).click();
    await expect.poll(time).toBeGreaterThan(begin + 0.2);
    await visit.page.getByRole('button', { name: 'Pause' }).click();
    const slider = visit.page.getByRole('slider', { name: 'World time' });
    await slider.focus();
    await visit.page.keyboard.press('Home');
    await expect.poll(time).toBe(0);
    await visit.close();
  });

  it('plays from the start, unless reduced motion is preferred', async () => {
    const moving = await (await program.open(SMALL, { reducedMotion: 'no-preference' })).ready();
    await moving.page.getByRole('button', { name: 'Pause' }).waitFor();
    await moving.close();
    const calm = await (await program.open(SMALL)).ready();
    await calm.page.getByRole('button', { name: 'Play' }).waitFor();
    await calm.close();
  });
});
