import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { loadAnswers, NOTHING, saveAnswers } from './answers.ts';

const kept = new Map<string, string>();
beforeEach(() => {
  kept.clear();
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  });
});
afterEach(() => vi.unstubAllGlobals());

it('answers of each lesson are kept by themselves', () => {
  const answered = { chosen: { 2: 1, 3: 0 }, seen: [2] };
  saveAnswers('twins', answered);
  saveAnswers('wheel', NOTHING);
  expect(loadAnswers('twins', [0, 3, 3])).toEqual(answered);
  expect(loadAnswers('wheel', [0, 3, 3])).toEqual(NOTHING);
  expect(loadAnswers('cloth', [3])).toEqual(NOTHING);
});

it('answers that a changed lesson no longer has are forgotten', () => {
  saveAnswers('twins', { chosen: { 1: 2, 2: 3, 9: 0 }, seen: [1, 2, 4] });
  expect(loadAnswers('twins', [3, 3])).toEqual({ chosen: { 1: 2 }, seen: [1] });
});

it.each(['{', 'null', '7', '{"twins":7}', '{"twins":{"chosen":[],"seen":7}}', '{"twins":{"chosen":{"1":"0"}}}'])(
  'unreadable ones are none: %s',
  (text) => {
    kept.set('slowlight.lessons', text);
    expect(loadAnswers('twins', [3])).toEqual(NOTHING);
  },
);

it('without storage nothing is kept, and nothing fails', () => {
  vi.stubGlobal('localStorage', undefined);
  saveAnswers('twins', NOTHING);
  expect(loadAnswers('twins', [3])).toEqual(NOTHING);
});
