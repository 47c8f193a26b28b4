import { join } from 'node:path';
import { expect, test } from 'vitest';
import { outputFolder, scene, slowlight, slowlightJson } from './program.ts';

const movers = scene('movers.usda');
const folder = outputFolder();

interface Reading {
  readonly time: number;
  readonly position: readonly number[];
  readonly properTime: number;
  readonly rate: number;
}
interface Readings {
  readonly seen: Reading;
  readonly slice: Reading;
  readonly world: Reading;
}
interface Report {
  readonly observer: { readonly properTime: number; readonly gamma: number };
  readonly ship: Readings;
  readonly world: Readings;
  readonly objects: readonly (Readings & { readonly prim: string })[];
}

test('of a cube that flies at 0.6 c for one at rest, and for one who flies with it', async () => {
  const leaving = ['clocks', movers, '--prim', '/World/Leaving', '--position', '0,0,0', '--time', '2'];
  const [cube] = (await slowlightJson<Report>(...leaving)).objects;
  // 400 + (20 + 6t)² = 100 (2 − t)².
  const t = 5 - Math.sqrt(31.25);
  expect(cube!.prim).toBe('/World/Leaving');
  expect(cube!.seen.time).toBeCloseTo(t, 9);
  expect(cube!.seen.properTime).toBeCloseTo(0.8 * t, 9);
  expect(cube!.seen.position[2]).toBeCloseTo(-20 - 6 * t, 9);
  const n = (20 + 6 * t) / (10 * (2 - t));
  expect(cube!.seen.rate).toBeCloseTo(0.8 / (1 + 0.6 * n), 9);
  expect([cube!.slice.properTime, cube!.slice.rate]).toEqual([expect.closeTo(1.6, 12), expect.closeTo(0.8, 12)]);

  const along = await slowlightJson<Report>(...leaving, '--beta', '0,0,-0.6');
  expect(along.objects[0]!.seen.rate).toBeCloseTo(1, 12);
  expect(along.objects[0]!.slice.rate).toBeCloseTo(1, 12);
  // c(t − 2) = 0.6 (20 + 6t).
  expect(along.objects[0]!.slice.time).toBeCloseTo(5, 9);
  expect([along.ship.seen.properTime, along.world.seen.rate]).toEqual([
    expect.closeTo(1.6, 12),
    expect.closeTo(1.25, 12),
  ]);
});

test('of a pilot, who comes home younger by the closed form of the trip', async () => {
  const flight = join(folder, 'there.flight.json');
  const d = 90;
  const there = ['flight', 'trip', '--from', '0,0,-10', '--to', `0,0,${-10 - d}`, '--c', '10', '--acceleration', '4'];
  expect((await slowlight(...there, '--return', '-o', flight)).code).toBe(0);
  const still = ['clocks', movers, '--prim', '/World/Still', '--flight', flight];
  const home = await slowlightJson<Report>(...still);
  const tau = 2 * ((2 * 10) / 4) * Math.acosh(1 + (4 * d) / 200);
  const t = 2 * Math.sqrt((d / 10) ** 2 + (4 * d) / 4);
  expect(Math.abs(home.ship.seen.properTime / tau - 1)).toBeLessThan(1e-12);
  for (const way of ['seen', 'slice', 'world'] as const)
    expect(Math.abs(home.objects[0]![way].properTime / t - 1)).toBeLessThan(1e-12);
  // After 2.5 s at 4 m/s² the rapidity is 1.
  const under = (await slowlightJson<Report>(...still, '--time', '2.5')).objects[0]!;
  expect(under.seen.properTime).toBeCloseTo(2.5 * (1 - Math.exp(-1)), 9);
  expect(under.slice.properTime).toBeCloseTo(2.5 * Math.tanh(1), 9);
  expect(under.world.properTime).toBeCloseTo(2.5 * Math.sinh(1), 9);

  expect((await slowlight(...still, '--time', '999')).err).toContain('--time 999: the flight lasts from 0 to');
  expect((await slowlight(...still, '--beta', '0,0,0.5')).err).toContain('--beta says where the observer is');
  expect((await slowlight(...still, '--c', '3')).err).toContain('flown at 10 m/s');
});

test('as a table in the language of --lang, by default of what moves', async () => {
  const { out } = await slowlight('clocks', movers, '--time', '2', '--beta', '0,0,-0.6');
  const lines = out.trimEnd().split('\n');
  expect(lines.slice(3).map((line) => line.split(' ')[0])).toEqual([
    'ship',
    'world',
    '/World/Leaving',
    '/World/Rising',
  ]);
  expect(lines[0]).toContain('world time 2 s, own clock 1.6 s');
  const chinese = (await slowlight('clocks', movers, '--time', '2', '--lang', 'zh')).out;
  expect(chinese).toContain('同时面上');
  expect(chinese).toMatch(/^飞船 /m);
});

test('an unknown object is refused, with those that are there', async () => {
  const { code, err } = await slowlight('clocks', movers, '--prim', '/World/None');
  expect(code).toBe(2);
  expect(err).toContain('/World/Leaving');
});
