import { expect, test } from 'vitest';
import { treeLines } from './tree.ts';

test('paths form a tree that preserves their order', () => {
  const entries = [
    { path: '/World/House/Door', note: 'a' },
    { path: '/World/Tree', note: 'b' },
    { path: '/World/House', note: 'c' },
  ];
  expect(treeLines(entries)).toEqual(['└─ World', '   ├─ House  (c)', '   │  └─ Door  (a)', '   └─ Tree  (b)']);
});
