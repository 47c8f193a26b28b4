import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { encodeShareLink } from '../../src/graph/document/shareLink.ts';
import { applyCommand } from '../../src/graph/edits/commands.ts';
import { newProject } from '../../src/nodes/project/projectCommands.ts';
import { difference, type MonitoredPage, Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const SMALL = '?backend=webgl&scene=examples/sphere.usdc';

const hold = async (page: Page, keys: readonly string[], until: () => Promise<void>): Promise<void> => {
  for (const key of keys) await page.keyboard.down(key);
  await until();
  for (const key of keys) await page.keyboard.up(key);
};

async function openDeck({ page }: MonitoredPage) {
  await page.getByRole('button', { name: /^Flight: / }).click();
  const deck = page.locator('[data-flight-deck]');
  await deck.waitFor();
  return deck;
}

describe('the flight deck', () => {
  it('thrust: one coasts when the key is released, and Z brakes; T goes on to the next way of flying, which a reload keeps', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    await visit.viewport.focus();
    for (const name of ['Drive', 'Thrust']) {
      await page.keyboard.press('t');
      await page.getByRole('button', { name: `Flight: ${name}` }).waitFor();
    }
    await hold(page, ['w'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.1));
    const drifting = await visit.speed();
    expect(drifting).toBeGreaterThan(0.1);
    await visit.shot('flight-thrust');
    expect(await visit.speed()).toBeGreaterThanOrEqual(drifting);
    await hold(page, ['z'], () => expect.poll(() => visit.speed()).toBe(0));
    await page.reload();
    await visit.ready();
    // As it was left.
    await page.getByRole('button', { name: 'Flight: Thrust' }).waitFor();
    await visit.close();
  });

  it('the autopilot flies before an object and stops there; by the keyboard alone', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    await page.getByRole('button', { name: /^Flight: / }).focus();
    await page.keyboard.press('Enter');
    const mode = page.getByRole('combobox', { name: 'Way of flying' });
    await mode.focus();
    // The last of the list is before the first.
    for (const key of ['ArrowDown', 'ArrowUp', 'Enter']) await page.keyboard.press(key);
    await page.getByRole('button', { name: 'Flight: Autopilot' }).waitFor();
    const z = page.getByRole('textbox', { name: 'z [m]' });
    await z.fill('0.5');
    await page.keyboard.press('Escape');
    await expect.poll(() => visit.speed()).toBeGreaterThan(0.05);
    await expect.poll(() => visit.speed()).toBe(0);
    await visit.close();
  });

  it('comfort: the rim darkens in fast motion, one turns in steps, and both are remembered', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    const vignette = page.locator('[data-vignette]');
    const deck = await openDeck(visit);
    // As who wishes reduced motion has it at first.
    await vignette.waitFor({ state: 'attached' });
    expect(await vignette.getAttribute('data-vignette')).toBe('mild');
    const choose = async (what: string, choice: string): Promise<void> => {
      await deck.getByRole('combobox', { name: what }).click();
      await page.getByRole('option', { name: choice }).click();
    };
    await choose('Turning', 'In steps of 90°');
    await choose('In fast motion', 'No vignette');
    await vignette.waitFor({ state: 'detached' });
    await choose('In fast motion', 'Strong vignette');
    await visit.shot('flight-comfort');
    const { violations } = await new AxeBuilder({ page }).include('[data-flight-deck]').analyze();
    expect(violations).toEqual([]);
    await page.keyboard.press('Escape');
    await visit.viewport.focus();
    const closing = async () => Number(await vignette.getAttribute('data-closing'));
    const ahead = await (await visit.finest()).pixels();
    // A turn in one step is no motion that is seen.
    await hold(page, ['ArrowLeft'], () =>
      expect.poll(async () => difference(await visit.pixels(), ahead)).toBeGreaterThan(1),
    );
    expect(await closing()).toBe(0);
    await hold(page, ['Shift', 'w'], async () => {
      await expect.poll(closing).toBeGreaterThan(0.5);
      await visit.shot('flight-vignette');
    });
    await expect.poll(closing).toBe(0);
    await page.reload();
    await visit.ready();
    await vignette.waitFor({ state: 'attached' });
    expect(await vignette.getAttribute('data-vignette')).toBe('strong');
    await openDeck(visit);
    expect(await deck.getByRole('combobox', { name: 'Turning' }).inputValue()).toBe('In steps of 90°');
    await visit.close();
  });

  it('holds what is seen: one walks about in it, comes back to one’s eye, and sees what was there', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    await visit.viewport.focus();
    await hold(page, ['w'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.3));
    await expect.poll(() => visit.speed()).toBe(0);
    const seen = await (await visit.finest()).pixels();
    await page.keyboard.press('h');
    const card = page.locator('[data-held]');
    await card.waitFor();
    await hold(page, ['d', 'e'], () => expect.poll(() => card.textContent()).toMatch(/[1-9]\.?\d* m from your eye/));
    expect(await visit.speed()).toBe(0);
    const aside = await (await visit.finest()).pixels();
    expect(difference(aside, seen)).toBeGreaterThan(1);
    await visit.shot('flight-hold');
    const { violations } = await new AxeBuilder({ page }).include('[data-held]').analyze();
    expect(violations).toEqual([]);
    await card.getByRole('button', { name: 'Back to your eye' }).click();
    await card.waitFor({ state: 'detached' });
    expect(difference(await (await visit.finest()).pixels(), seen)).toBeLessThan(0.02);
    const deck = await openDeck(visit);
    await deck.getByRole('switch', { name: 'Hold what you see' }).press('Space');
    await card.waitFor();
    await visit.close();
  });

  it('comfort: who wishes reduced motion has a vignette on a ridden camera before he touches anything', async () => {
    const ridden = { kind: 'set-param', node: 'camera', param: 'ride', value: true } as const;
    const { document } = applyCommand(newProject('examples/street.usdc'), ridden);
    const visit = await (await program.open(`?backend=webgl#${encodeShareLink(document)}`)).ready();
    await visit.page.locator('[data-vignette=mild]').waitFor({ state: 'attached' });
    await visit.close();
  });

  it('drives over the ground at the height that was chosen, which is remembered', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    await visit.viewport.focus();
    await page.keyboard.press('t');
    const deck = await openDeck(visit);
    await deck.getByRole('switch', { name: 'Follow the ground' }).press('Space');
    await deck.getByRole('textbox', { name: 'Height of the eye above it [m]' }).fill('1.5');
    await expect.poll(() => deck.locator('[data-contact=preparing]').count()).toBe(0);
    const before = await (await visit.finest()).pixels();
    // What is held is let go.
    await deck.getByRole('switch', { name: 'Hold what you see' }).press('Space');
    const held = page.locator('[data-held]');
    await held.waitFor();
    await deck.getByRole('button', { name: 'Come down to the ground' }).press('Enter');
    await held.waitFor({ state: 'detached' });
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeGreaterThan(1);
    const { violations } = await new AxeBuilder({ page }).include('[data-flight-deck]').analyze();
    expect(violations).toEqual([]);
    await page.keyboard.press('Escape');
    await visit.viewport.focus();
    await hold(page, ['w'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.1));
    await expect.poll(() => visit.speed()).toBe(0);
    await visit.shot('flight-ground');
    await page.reload();
    await visit.ready();
    await page.getByRole('button', { name: 'Flight: Drive' }).waitFor();
    await openDeck(visit);
    expect(await deck.getByRole('textbox', { name: 'Height of the eye above it [m]' }).inputValue()).toBe('1.5');
    await visit.close();
  });

  it('draws once for all velocities: at one event the same is seen with no triangle drawn, at rest and in motion; an edit that can be undone', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    await visit.viewport.focus();
    // Look: one stays in place, and cruises.
    await page.keyboard.press('Tab');
    await page.getByRole('button', { name: 'Lock: Look' }).waitFor();
    await page.keyboard.press('c');
    const rest = await (await visit.finest()).pixels();
    await hold(page, ['w'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.3));
    const fast = await (await visit.finest()).pixels();
    expect(difference(fast, rest)).toBeGreaterThan(5);
    const deck = await openDeck(visit);
    const imageBased = deck.getByRole('switch', { name: 'Image-based: drawn once for all velocities' });
    await imageBased.press('Space');
    await expect.poll(() => visit.triangles()).toBe(0);
    await page.keyboard.press('Escape');
    await deck.waitFor({ state: 'detached' });
    expect(difference(await (await visit.finest()).pixels(), fast)).toBeLessThan(2);
    await visit.viewport.focus();
    await hold(page, ['z'], () => expect.poll(() => visit.speed()).toBe(0));
    expect(await visit.triangles()).toBe(0);
    expect(difference(await (await visit.finest()).pixels(), rest)).toBeLessThan(2);
    await visit.shot('flight-captured');
    await page.getByRole('button', { name: /^Undo: draw once/ }).click();
    await expect.poll(() => visit.triangles()).toBeGreaterThan(0);
    expect(difference(await (await visit.finest()).pixels(), rest)).toBeLessThan(1);
    await openDeck(visit);
    expect(await imageBased.isChecked()).toBe(false);
    await visit.close();
  });

  it('records, replays and scrubs; a key takes over; nothing for axe to complain about', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    await visit.viewport.focus();
    await page.keyboard.press('k');
    const deck = await openDeck(visit);
    await deck.getByRole('button', { name: /^Stop/ }).waitFor();
    await page.keyboard.press('Escape');
    await visit.viewport.focus();
    await hold(page, ['w', 'ArrowLeft'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.1));
    await page.keyboard.press('k');
    const seen = await openDeck(visit);
    await deck.getByRole('switch', { name: 'Hold what you see' }).press('Space');
    await page.locator('[data-held]').waitFor();
    await seen.getByRole('button', { name: 'Replay' }).click();
    await page.locator('[data-held]').waitFor({ state: 'detached' });
    const time = seen.getByRole('slider', { name: 'Time of the flight' });
    await expect.poll(async () => Number(await time.getAttribute('aria-valuenow'))).toBeGreaterThan(0);
    await time.focus();
    await page.keyboard.press('Home');
    await expect.poll(() => visit.speed()).toBe(0);
    await visit.shot('flight-deck');
    const { violations } = await new AxeBuilder({ page }).include('[data-flight-deck]').analyze();
    expect(violations).toEqual([]);
    await page.keyboard.press('Escape');
    await visit.viewport.focus();
    await hold(page, ['w'], () => expect.poll(() => visit.speed()).toBeGreaterThan(0.05));
    await visit.close();
  });

  it('flying at a wall one stops before it, and the page remembers the choice', async () => {
    const visit = await (await program.open(SMALL)).ready();
    const { page } = visit;
    const deck = await openDeck(visit);
    await deck.getByRole('combobox', { name: 'Collisions' }).click();
    await page.getByRole('option', { name: 'Stop before walls' }).click();
    await deck.getByRole('textbox', { name: 'Distance from walls [m]' }).waitFor();
    await expect.poll(() => deck.locator('[data-contact=preparing]').count()).toBe(0);
    await visit.shot('flight-walls');
    const { violations } = await new AxeBuilder({ page }).include('[data-flight-deck]').analyze();
    expect(violations).toEqual([]);
    await page.keyboard.press('Escape');
    await visit.viewport.focus();
    await page.keyboard.down('w');
    await expect.poll(() => visit.speed()).toBeGreaterThan(0.1);
    await expect.poll(() => visit.speed()).toBe(0);
    await page.keyboard.up('w');
    await openDeck(visit);
    await visit.shot('flight-at-wall');
    await page.reload();
    await visit.ready();
    await openDeck(visit);
    expect(await deck.getByRole('combobox', { name: 'Collisions' }).inputValue()).toBe('Stop before walls');
    await visit.close();
  });
});
