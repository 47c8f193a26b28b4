import { expect, it } from 'vitest';
import { Patience } from './patience.ts';

const resting = { shown: {}, rests: true, software: false };
const image = {};

it('draws once the canvas, the nodes and the picture rest, and not again until something changes', () => {
  const patience = new Patience();
  const seen = new Map([['tone', image]]);
  expect(patience.allows(seen, 'here', resting, 0)).toBe(false);
  expect(patience.allows(seen, 'here', resting, 200)).toBe(true);
  expect(patience.allows(seen, 'here', resting, 9000)).toBe(false);
  const drawnAnew = { ...resting, shown: {} };
  expect(patience.allows(seen, 'here', drawnAnew, 9200)).toBe(true);
  expect(patience.allows(seen, 'here', drawnAnew, 9400)).toBe(false);
  const edited = new Map([['tone', {}]]);
  expect(patience.allows(edited, 'here', drawnAnew, 9600)).toBe(false);
  expect(patience.allows(edited, 'there', drawnAnew, 9800)).toBe(false);
  expect(patience.allows(edited, 'there', drawnAnew, 10_000)).toBe(true);
  expect(patience.allows(new Map(), 'there', drawnAnew, 10_200)).toBe(false);
});

it('keeps up with a picture that moves once a second, and where the processor draws not at all', () => {
  for (const software of [false, true]) {
    const patience = new Patience();
    const seen = new Map([['tone', image]]);
    let drawn = 0;
    for (let now = 0; now <= 10_000; now += 200)
      if (patience.allows(seen, 'here', { shown: {}, rests: false, software }, now)) drawn++;
    expect(drawn).toBe(software ? 1 : 10);
  }
});
