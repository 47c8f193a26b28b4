import { expect, it } from 'vitest';
import { formatBeta, formatCount, formatNumber, formatSeconds, formatSpeed } from './format.ts';

it.each([
  [0, '0'],
  [1234.5, '1235'],
  [299_792_458, '299\u202f792\u202f458'],
  [-0.5, '−0.500'],
  [2.294157, '2.29'],
  [1e-5, '1.00e−5'],
  [-1e-5, '−1.00e−5'],
  [Number.POSITIVE_INFINITY, '∞'],
])('%d is formatted as %s', (value, text) => expect(formatNumber(value)).toBe(text));

it.each([
  [0, '0'],
  [0.5, '0.500'],
  [0.9, '0.900'],
  [0.99, '0.9900'],
  [0.999999, '0.99999900'],
])('a speed of %d c is formatted with all its nines', (beta, text) => expect(formatBeta(beta)).toBe(text));

it('times and speeds have their units', () => {
  expect(formatSeconds(2.345)).toBe('2.35 s');
  expect(formatSeconds(-1)).toBe('−1.00 s');
  expect(formatSeconds(-0.001)).toBe('0.00 s');
  expect(formatSeconds(3725)).toBe('62 min 05 s');
  expect(formatSpeed(8)).toBe('8.00 m/s');
  expect(formatCount(1_234_567)).toBe('1\u202f234\u202f567');
});
