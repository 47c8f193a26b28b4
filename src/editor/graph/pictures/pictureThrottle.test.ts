import { expect, it } from 'vitest';
import { PictureThrottle } from './pictureThrottle.ts';

const resting = { view: {}, isStill: true, software: false };
const image = {};

it('draws once canvas, nodes and picture have stopped changing, and not again until something changes', () => {
  const throttle = new PictureThrottle();
  const seen = new Map([['tone', image]]);
  expect(throttle.shouldRender(seen, 'here', resting, 0)).toBe(false);
  expect(throttle.shouldRender(seen, 'here', resting, 200)).toBe(true);
  expect(throttle.shouldRender(seen, 'here', resting, 9000)).toBe(false);
  const drawnAnew = { ...resting, view: {} };
  expect(throttle.shouldRender(seen, 'here', drawnAnew, 9200)).toBe(true);
  expect(throttle.shouldRender(seen, 'here', drawnAnew, 9400)).toBe(false);
  const edited = new Map([['tone', {}]]);
  expect(throttle.shouldRender(edited, 'here', drawnAnew, 9600)).toBe(false);
  expect(throttle.shouldRender(edited, 'there', drawnAnew, 9800)).toBe(false);
  expect(throttle.shouldRender(edited, 'there', drawnAnew, 10_000)).toBe(true);
  expect(throttle.shouldRender(new Map(), 'there', drawnAnew, 10_200)).toBe(false);
});

it('draws once a second while the picture keeps changing, but only once with software rendering', () => {
  for (const software of [false, true]) {
    const throttle = new PictureThrottle();
    const seen = new Map([['tone', image]]);
    let drawn = 0;
    for (let now = 0; now <= 10_000; now += 200)
      if (throttle.shouldRender(seen, 'here', { view: {}, isStill: false, software }, now)) drawn++;
    expect(drawn).toBe(software ? 1 : 10);
  }
});
