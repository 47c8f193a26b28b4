import { expect, it } from 'vitest';
import { nearestPath } from './nearestPath.ts';

const FILES = ['set/a/wood.png', 'set/b/wood.png', 'set/Stone.PNG', 'x/ice.png', 'y/Ice.png'];

it.each([
  ['elsewhere/b/wood.png', 'set/b/wood.png'],
  ['../stone.png', 'set/Stone.PNG'],
  ['ice.png', 'x/ice.png'],
  ['wood.png', undefined],
  ['c/wood.png', undefined],
  ['od.png', undefined],
  ['ICE.PNG', undefined],
])('%s → %s', (wanted, found) => expect(nearestPath(FILES, wanted)).toBe(found));
