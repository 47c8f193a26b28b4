import { expect, it } from 'vitest';
import { sphereContacts } from '../forces/contact.ts';
import { springForce } from '../forces/springs.ts';
import { makeSystem, type System } from '../system.ts';
import { ThreadBarrier } from './threadBarrier.ts';
import { teamSize } from './threadTeam.ts';

const chain = (points: number, more: System['forces'] = []): System => {
  const links = Array.from({ length: points - 1 }, (_, i) => [i, i + 1]);
  const springs = springForce({
    ends: Uint32Array.from(links.flat()),
    stiffness: new Float64Array(points - 1).fill(1),
    lengths: new Float64Array(points - 1),
  });
  return makeSystem({ masses: new Float64Array(points).fill(1), forces: [springs, ...more] });
};

it('a team pays for many points and steps, with forces that are summed in parts', () => {
  const balls = sphereContacts([{ point: 0, radius: 1 }], [1, 2], { stiffness: 1, scale: 1 });
  expect(teamSize(chain(10_000), 10_000, 2)).toBe(2);
  expect(teamSize(chain(10_000), 10_000, 64)).toBe(5);
  expect(teamSize(chain(10_000), 1000, 64)).toBe(1);
  expect(teamSize(chain(100), 1e9, 64)).toBe(1);
  expect(teamSize(chain(10_000, [balls]), 10_000, 2)).toBe(1);
});

it('a barrier gives up a thread that does not arrive', () => {
  const barrier = new ThreadBarrier(new Int32Array(new SharedArrayBuffer(12)), 2);
  expect(() => barrier.arrive(10)).toThrow('does not answer');
});
