import { expect, it } from 'vitest';
import { chinese } from '../../../messages/languages/chinese.ts';
import { translate } from '../../../messages/message.ts';
import { matchesKeyBinding } from '../commands/keyBindings.ts';
import { type QuickPickItem, rankItems } from './ranking.ts';
import { optionTitles } from './useNodeItems.ts';

const items: QuickPickItem[] = [
  { id: 'transform', label: 'Transform', group: 'a', detail: 'Turns and carries', words: '变换 transform' },
  { id: 'torus', label: 'Torus', group: 'a', detail: 'A ring' },
  { id: 'motion', label: 'Circular motion', group: 'b', detail: 'Round a circle' },
  { id: 'ring', label: 'Ring', group: 'b' },
];
const found = (query: string): string[] => rankItems(items, query).map(({ id }) => id);

it('names that begin with the query rank first, then names that contain it, then descriptions', () => {
  expect(found('')).toEqual(['transform', 'torus', 'motion', 'ring']);
  expect(found('to')[0]).toBe('torus');
  expect(found('ring')).toEqual(['ring', 'torus']);
  expect(found('mo')).toEqual(['motion']);
  expect(found('circular mot')).toEqual(['motion']);
  expect(found('变换')).toEqual(['transform']);
  expect(found('zzz')).toEqual([]);
});

it('a node is found by its options, in English and in the page’s language', () => {
  const nodes = ['post-process', 'tone-map', 'group'].map((id) => ({
    id,
    label: id,
    group: '',
    words: optionTitles(id, (text) => translate(text, chinese.messages)),
  }));
  for (const query of ['bloom', 'Bloom', '泛光'])
    expect(rankItems(nodes, query).map(({ id }) => id)).toEqual(['post-process']);
  expect(rankItems(nodes, 'agx').map(({ id }) => id)).toEqual(['tone-map']);
});

const press = (
  key: string,
  modifiers: Partial<Record<'ctrlKey' | 'shiftKey' | 'altKey' | 'metaKey', boolean>> = {},
) => ({
  key,
  code: /^[a-z]$/i.test(key) ? `Key${key.toUpperCase()}` : '',
  ctrlKey: false,
  metaKey: false,
  shiftKey: false,
  altKey: false,
  ...modifiers,
});

it('key bindings are distinguished by modifiers', () => {
  expect(matchesKeyBinding(press('g', { ctrlKey: true }), 'Mod+G')).toBe(true);
  expect(matchesKeyBinding(press('g', { metaKey: true }), 'Mod+G')).toBe(true);
  expect(matchesKeyBinding(press('g', { ctrlKey: true, altKey: true }), 'Mod+G')).toBe(false);
  expect(matchesKeyBinding(press('A', { shiftKey: true }), 'Shift+A')).toBe(true);
  expect(matchesKeyBinding(press('a'), 'Shift+A')).toBe(false);
  expect(matchesKeyBinding(press(' '), 'Space')).toBe(true);
  // A sign matches with and without Shift; a letter of another script matches by physical key.
  expect(matchesKeyBinding(press('+', { shiftKey: true }), '+')).toBe(true);
  expect(matchesKeyBinding({ ...press('ь'), code: 'KeyM' }, 'M')).toBe(true);
  expect(matchesKeyBinding(press('ArrowLeft', { altKey: true }), 'Alt+ArrowLeft')).toBe(true);
});
