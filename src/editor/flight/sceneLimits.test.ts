import { describe, expect, it } from 'vitest';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box } from '../../scene/mesh/primitives.ts';
import type { Scene } from '../../scene/types.ts';
import { isOutside, sceneLimits } from './sceneLimits.ts';

/** A hall of 6 m × 2 m × 3 m, whose diagonal is 7 m, and something that leaves it. */
const hall: Scene = makeScene({
  name: 'hall',
  materials: [makeMaterial({ name: 'grey' })],
  objects: [
    makeObject({ path: '/Hall', mesh: box([6, 2, 3]), motion: restingAt([0, 0, 0]) }),
    makeObject({
      path: '/Ball',
      mesh: box([1, 1, 1]),
      motion: { kind: 'uniform', pose: { position: [90, 0, 0], orientation: [0, 0, 0, 1] }, velocity: [1, 0, 0] },
    }),
  ],
});

describe('the limits of a scene', () => {
  it('are a tenth of its diagonal around what is at rest', () => {
    const limits = sceneLimits(hall, [0, 0, 0], 10);
    if (!limits) throw new Error('no limits');
    expect(limits.margin).toBeCloseTo(0.7, 12);
    expect(isOutside(limits, [3.6, 0, 0])).toBe(false);
    expect(isOutside(limits, [3.8, 0, 0])).toBe(true);
    // 0.5 m past two walls is 0.707 m away.
    expect(isOutside(limits, [3.5, 1.5, 0])).toBe(true);
  });

  it('are wider where one starts outside', () => {
    const limits = sceneLimits(hall, [0, 0, 6.5], 10);
    if (!limits) throw new Error('no limits');
    expect(limits.margin).toBeCloseTo(10, 12);
    expect(isOutside(limits, [0, 0, 11.4])).toBe(false);
    expect(isOutside(limits, [0, 0, -11.6])).toBe(true);
  });

  it('are of what moves where nothing is at rest, and none of an empty scene', () => {
    const flying = { ...hall, objects: hall.objects.slice(1) };
    expect(sceneLimits(flying, [90, 0, 0], 10)?.box.min).toEqual([89.5, -0.5, -0.5]);
    expect(sceneLimits({ ...hall, objects: [] }, [0, 0, 0], 10)).toBeUndefined();
  });
});
