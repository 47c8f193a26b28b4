import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { outputFolder, scene, slowlight } from './program.ts';

const movers = scene('movers.usda');
const folder = outputFolder();

async function draw(name: string, ...flags: string[]): Promise<string> {
  const file = join(folder, name);
  const { code, err } = await slowlight('diagram', movers, '-o', file, ...flags);
  expect([code, err]).toEqual([0, '']);
  return readFileSync(file, 'utf8');
}

const LEAVING = ['--prim', '/World/Leaving', '--position', '0,0,0', '--time', '2', '--span', '40'];
/** Of 1280 × 720: the observer's event, and pixels per metre. */
const [X, Y, SCALE] = [557, 350, 998 / 80];

test('the world line of a receding cube has the slope of its speed, and its light comes from the cone', async () => {
  const svg = await draw('leaving.svg', ...LEAVING);
  const [, d] = /<path d="([^"]*)" fill="none" stroke="#0072b2" stroke-width="20"/.exec(svg)!;
  const [x0, y0, x1, y1] = d!.match(/[-\d.]+/g)!.map(Number) as [number, number, number, number];
  expect((x1 - x0) / (y0 - y1)).toBeCloseTo(0.6, 3);
  // 400 + (20 + 6t)² = 100 (2 − t)²: t = 5 − √31.25.
  const t = 5 - Math.sqrt(31.25);
  const [, cx, cy] = /<circle cx="([\d.]+)" cy="([\d.]+)" r="4" fill="#0072b2"/.exec(svg)!.map(Number);
  expect(cx).toBeCloseTo(X + SCALE * (20 + 6 * t), 1);
  expect(cy).toBeCloseTo(Y + SCALE * 10 * (2 - t), 1);
  expect(svg).toContain('Beside the axis, so that their events lie within the drawn cone: /World/Leaving.');
});

test('in the rest frame of an observer who moves with the cube, it rests', async () => {
  const svg = await draw('rest.svg', ...LEAVING, '--beta', '0,0,-0.6', '--frame', 'observer');
  const [, d] = /<path d="([^"]*)" fill="none" stroke="#0072b2" stroke-width="20"/.exec(svg)!;
  const [x0, , x1] = d!.match(/[-\d.]+/g)!.map(Number) as [number, number, number];
  expect(x1).toBeCloseTo(x0, 0);
});

test('titles are in the language of --lang', async () => {
  expect(await draw('zh.svg', ...LEAVING, '--lang', 'zh')).toContain('<title>时空图</title>');
  expect(await draw('energy.svg', '--of', 'energy', '--theme', 'dark')).toContain('/World/Leaving: β = 0.6');
});

test.each([
  ['another format', ['-o', 'a.png'], 'as .svg'],
  ['an unknown object', ['-o', 'a.svg', '--prim', '/World/None'], '/World/Leaving'],
  ['no direction', ['-o', 'a.svg', '--axis', '0,0,0'], '--axis 0,0,0'],
  ['two axes along each other', ['-o', 'a.svg', '--axis', '1,0,0', '--second-axis=-2,0,0'], '--second-axis'],
])('%s is refused', async (_, flags, named) => {
  const { code, err } = await slowlight('diagram', movers, ...flags);
  expect(code).toBe(2);
  expect(err).toContain(named);
});
