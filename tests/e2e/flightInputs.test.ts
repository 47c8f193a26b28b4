import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type MonitoredPage, Program } from './program.ts';
import { drop } from './support.ts';

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

/** Two fingers that move up to accelerate; down, against the motion: gently, so that a slow page does not miss the moment before one flies backwards. */
async function fingers(page: Page): Promise<Device> {
  const session = await page.context().newCDPSession(page);
  const points = (dy: number) => [250, 350].map((x, id) => ({ x, y: 300 + dy, id }));
  const move = async (dy: number) => {
    await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
    for (const part of [0.5, 1])
      await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(part * dy) });
  };
  const up = async () => void (await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] }));
  return { push: () => move(-100), letGo: up, brake: () => move(10), releaseBrake: up };
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

it('one flies by keyboard, gamepad and fingers, in each way of flying by hand', async () => {
  const visit = await opened();
  const { page } = visit;
  const devices = [keyboard(page), gamepad(page), await fingers(page)];
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
