import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type MonitoredPage, Program } from './program.ts';
import { drop } from './support.ts';
import { Touches } from './touches.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

/** A ball in the distance, at rest, and one that recedes at 0.3 c. */
const SCENE = `#usda 1.0
( customLayerData = { dictionary slowlight = { double speedOfLight = 10 } }
  metersPerUnit = 1
  upAxis = "Y" )
def Camera "Eye"
{
}
def Sphere "Goal"
{
    double3 xformOp:translate = (0, 0, -60)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
def Sphere "Runner"
{
    double3 xformOp:translate = (3, 0, -8)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    uniform token slowlight:motion = "uniform"
    vector3d slowlight:velocity = (0, 0, -3)
}
`;

/** Something that is pushed and let go, and the brake of the same device. */
interface Device {
  readonly push: () => Promise<void>;
  readonly letGo: () => Promise<void>;
  readonly brake: () => Promise<void>;
  readonly releaseBrake: () => Promise<void>;
}

const keyboard = (page: Page): Device => ({
  push: () => page.keyboard.down('w'),
  letGo: () => page.keyboard.up('w'),
  brake: () => page.keyboard.down('z'),
  releaseBrake: () => page.keyboard.up('z'),
});

/** What a standard gamepad with its left stick there, and these buttons down, says to the page. */
const setPad = (page: Page, stick: number, down: readonly number[]) =>
  page.evaluate(
    ([value, pressed]) => {
      const buttons = Array.from({ length: 17 }, (_, i) => ({
        pressed: pressed.includes(i),
        touched: false,
        value: 0,
      }));
      const pad = { connected: true, mapping: 'standard', axes: [0, value, 0, 0], buttons };
      navigator.getGamepads = () => [pad as unknown as Gamepad];
    },
    [stick, down] as const,
  );

const LEFT_TRIGGER = 6;
const gamepad = (page: Page): Device => ({
  push: () => setPad(page, -1, []),
  letGo: () => setPad(page, 0, []),
  brake: () => setPad(page, 0, [LEFT_TRIGGER]),
  releaseBrake: () => setPad(page, 0, []),
});

/** A finger on the thrust pad, ahead of its middle, and one on the button that brakes. */
async function finger(page: Page): Promise<Device> {
  const touches = await Touches.on(page);
  const lift = () => touches.up(1);
  return {
    push: async () => {
      // The page has its pad while it is touched: here after a look around and back.
      await touches.downOn(1, page.locator('[data-viewport]'));
      for (const dx of [40, -40]) await touches.move(1, dx, 0);
      await touches.up(1);
      await touches.downOn(1, page.getByRole('button', { name: /^Thrust pad/ }), [0, -60]);
    },
    letGo: lift,
    brake: () => touches.downOn(1, page.getByRole('button', { name: 'Brake' })),
    releaseBrake: lift,
  };
}

async function flies(visit: MonitoredPage, { push, letGo, brake, releaseBrake }: Device): Promise<void> {
  await push();
  await expect.poll(() => visit.speed()).toBeGreaterThan(0.1);
  const fast = await visit.speed();
  await letGo();
  await brake();
  await expect.poll(() => visit.speed()).toBeLessThan(fast / 2);
  await releaseBrake();
}

async function opened(): Promise<MonitoredPage> {
  const options = { hasTouch: true, viewport: { width: 1000, height: 700 } };
  const visit = await (await program.open('?backend=webgl&scene=examples/sphere.usdc', options)).ready();
  await drop(visit, [{ name: 'goal.usda', content: Buffer.from(SCENE) }]);
  await visit.viewport.focus();
  return visit;
}

it('one flies by keyboard, gamepad and touch, in each way of flying by hand', async () => {
  const visit = await opened();
  const { page } = visit;
  const devices = [keyboard(page), gamepad(page), await finger(page)];
  for (const name of ['Velocity', 'Drive', 'Thrust', 'Vehicle']) {
    await page.getByRole('button', { name: `Flight: ${name}` }).waitFor();
    for (const device of devices) {
      await flies(visit, device);
      await page.keyboard.press('r');
      await expect.poll(() => visit.speed()).toBe(0);
    }
    await page.keyboard.press('t');
  }
  await visit.close();
});

it('by taps alone one follows a thing, and is flown to another', async () => {
  const visit = await opened();
  const { page } = visit;
  const choose = async (box: string, option: string) => {
    await page.getByRole('combobox', { name: box }).tap();
    await page.getByRole('option', { name: option }).tap();
  };
  await page.getByRole('button', { name: /^Flight: / }).tap();
  await choose('Way of flying', 'Follow');
  await choose('What you follow', '/Runner');
  await expect.poll(() => visit.speed()).toBeCloseTo(0.3, 3);
  await choose('Way of flying', 'Autopilot');
  await choose('Fly to an object', '/Goal');
  await expect.poll(() => visit.speed()).toBeGreaterThan(0.4);
  await expect.poll(() => visit.speed()).toBe(0);
  await visit.close();
});
