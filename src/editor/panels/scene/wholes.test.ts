import { expect, it } from 'vitest';
import { makeObject } from '../../../scene/defaults.ts';
import { box } from '../../../scene/mesh/primitives.ts';
import { wholes } from './wholes.ts';

it('pieces that take turns are one thing', () => {
  const mesh = box([1, 1, 1]);
  const pieces = [1, 2].map((i) => makeObject({ path: `/World/Drops/piece${i}`, mesh, pieceOf: '/World/Drops' }));
  const post = makeObject({ path: '/World/Post', mesh });
  expect([...wholes([...pieces, post])]).toEqual(['/World/Drops', '/World/Post']);
});
