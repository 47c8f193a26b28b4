import { expect, it } from 'vitest';
import { entryOf, scenesIn } from './entry.ts';

it('selects the least nested scene, or the only file', () => {
  expect(entryOf(['a/parts/wheel.usda', 'a/car.usda', 'a/bus.usda', 'a/readme.txt'])).toBe('a/bus.usda');
  expect(entryOf(['a/body.obj', 'a/car.usda'])).toBe('a/car.usda');
  expect(entryOf(['a/body.obj', 'a/b/car.usda'])).toBe('a/body.obj');
  expect(entryOf(['odd.xyz'])).toBe('odd.xyz');
  expect(entryOf(['a.txt', 'b.md'])).toBeUndefined();
  expect(entryOf([])).toBeUndefined();
});

it('lists the others, the best first, without hidden files', () => {
  const paths = ['s/b/deep.usda', 's/body.obj', 's/car.glb', 's/._car.glb', '__MACOSX/x.usda', 's/a.png'];
  expect(scenesIn(paths)).toEqual(['s/car.glb', 's/body.obj', 's/b/deep.usda']);
});
