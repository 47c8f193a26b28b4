import { expect, test } from 'vitest';
import { displayWidth, padColumns } from './width.ts';

test.each([
  ['', 0],
  ['render', 6],
  ['c · 0…1 β −∞ °', 14],
  ['光速', 4],
  ['（默认：8）', 11],
  ['“帧”', 4],
  ['カナ한글', 8],
])('%s takes %i columns', (text, columns) => {
  expect(displayWidth(text)).toBe(columns);
});

test('texts are padded to columns, and never cut', () => {
  expect(padColumns('光速', 6)).toBe('光速  ');
  expect(padColumns('speed', 6)).toBe('speed ');
  expect(padColumns('光速', 3)).toBe('光速');
});
