import { expect, it } from 'vitest';
import type { PickedSurface } from '../../render/settings.ts';
import { OcclusionProbe } from './occlusionProbe.ts';

/** A picture of 100 × 50 px; what it shows, by column. */
function pictureOf(surfaces: Readonly<Record<number, Pick<PickedSurface, 'path' | 'depth'>>>) {
  const asked: (readonly [number, number])[] = [];
  const pick = async (x: number, y: number) => {
    asked.push([x, y]);
    return { light: [0, 0, 0] as const, ...(surfaces[x] && { surface: surfaces[x] as PickedSurface }) };
  };
  return { view: {}, width: 100, height: 50, pick, asked };
}
const clock = (path: string, x: number, distance = 10) => ({ path, place: [x, 0.5] as const, distance, time: 0 });

it('a clock is hidden by what is nearer, and not by what is farther or of its own thing', async () => {
  const probe = new OcclusionProbe();
  const picture = pictureOf({
    10: { path: '/Wall', depth: 9 },
    30: { path: '/Wall', depth: 11 },
    50: { path: '/Twin', depth: 9 },
    70: { path: '/Twin/hand', depth: 9 },
    90: { path: '/Twins', depth: 9 },
  });
  const cases = [
    ['/Ball', 0.1, true],
    ['/Far', 0.3, false],
    ['/Twin', 0.5, false],
    ['/Twin', 0.7, false],
    ['/Twin', 0.9, true],
    // Nothing but the sky.
    ['/Ball', 0.2, false],
    // The last column.
    ['/Ball', 1, false],
  ] as const;
  let now = 0;
  for (const [path, x, hidden] of cases) {
    now += 1000;
    await probe.update({ ...picture, view: {} }, [clock(path, x)], now);
    expect(probe.isHidden(path)).toBe(hidden);
  }
  expect(picture.asked.at(-1)).toEqual([99, 25]);
});

it('looks for one clock at a time, a few times a second, and once in a picture', async () => {
  const probe = new OcclusionProbe();
  const picture = pictureOf({});
  const clocks = [clock('/A', 0.1), clock('/B', 0.2)];
  const first = probe.update(picture, clocks, 0);
  expect(probe.update(picture, clocks, 1000)).toBeUndefined();
  await first;
  expect(probe.update(picture, clocks, 100)).toBeUndefined();
  await probe.update(picture, clocks, 300);
  expect(picture.asked.map(([x]) => x)).toEqual([10, 20]);
  expect(probe.update(picture, clocks, 600)).toBeUndefined();
  // Another picture: again in turn.
  const next = { ...picture, view: {} };
  await probe.update(next, clocks, 900);
  await probe.update({ ...picture, view: {} }, clocks, 1200);
  expect(picture.asked.map(([x]) => x)).toEqual([10, 20, 10, 20]);
});

it('goes on after a picture that could not be read', async () => {
  const probe = new OcclusionProbe();
  const picture = pictureOf({ 10: { path: '/Wall', depth: 1 } });
  const lost = { ...picture, pick: () => Promise.reject(new Error('lost')) };
  await expect(probe.update(lost, [clock('/A', 0.1)], 0)).rejects.toThrow('lost');
  await probe.update({ ...picture, view: {} }, [clock('/A', 0.1)], 1000);
  expect(probe.isHidden('/A')).toBe(true);
});
