import { expect, it } from 'vitest';
import { allocateTargets } from './targetAllocation.ts';

it('a target is drawn into only after the last that reads it', () => {
  const chain = [
    { kind: 'light', buffer: 0, shadows: true, occlusion: true },
    ...[0, 1, 2, 3].map((image) => ({ kind: 'tone', tone: 'agx', exposure: 0, metering: 'manual', image }) as const),
    { kind: 'mix', mode: 'add', alpha: 1, below: 1, above: 4 },
  ] as const;
  const { slots, count } = allocateTargets(chain);
  expect(slots[0]).toBe(-1);
  expect(count).toBe(3);
  expect(slots.slice(2)).not.toContain(slots[1]);
  expect(allocateTargets(chain.slice(0, 5)).count).toBe(2);
});
