import { expect, it } from 'vitest';
import { parseFlightPlan } from './flightPlan.ts';

it('reads parts of a flight', () => {
  expect(parseFlightPlan('coast 0.6, 0, -0.1 for 8; trip -90, 0, 0 at 5.5')).toEqual([
    { kind: 'coast', beta: [0.6, 0, -0.1], lasts: 8 },
    { kind: 'trip', by: [-90, 0, 0], acceleration: 5.5 },
  ]);
});

it('none is no flight', () => {
  expect(parseFlightPlan('none')).toEqual([]);
});

it.each([
  '',
  'coast 1, 0, 0 for 8',
  'coast 0.6, 0 for 8',
  'coast 0.6, 0, 0, 0 for 8',
  'coast 0.6, , 0 for 8',
  'coast 0.6, 0, 0',
  'trip 5, 0, 0 at 0',
  'trip 5, 0, 0 at -1',
  'coast 0.6, 0, 0 for 8;',
])('%s is no plan', (text) => {
  expect(parseFlightPlan(text)).toBeUndefined();
});
