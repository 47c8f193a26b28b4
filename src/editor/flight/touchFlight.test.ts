import { describe, expect, it } from 'vitest';
import { TouchFlight } from './touchFlight.ts';

describe('fingers on the picture', () => {
  it('one looks around', () => {
    const touch = new TouchFlight();
    expect(touch.move(1, 5, 5)).toEqual([0, 0]);
    touch.down(1, 10, 20);
    expect(touch.move(1, 13, 18)).toEqual([3, -2]);
    expect(touch.thrust()).toEqual([0, 0, 0]);
  });

  it('two fly by how far they have moved together, at most at full thrust, until one is lifted', () => {
    const touch = new TouchFlight();
    touch.down(1, 0, 0);
    touch.move(1, 30, 0);
    touch.down(2, 100, 0);
    expect(touch.thrust()).toEqual([0, 0, 0]);
    expect(touch.move(1, 30, -45)).toEqual([0, 0]);
    touch.move(2, 100, -45);
    expect(touch.thrust()).toEqual([0, 0, -0.5]);
    touch.move(2, 100, -900);
    const [x, y, z] = touch.thrust();
    expect([x, y]).toEqual([0, 0]);
    expect(z).toBeCloseTo(-1, 12);
    touch.up(2);
    expect(touch.thrust()).toEqual([0, 0, 0]);
    expect(touch.move(1, 31, -45)).toEqual([1, 0]);
  });

  it('three rise and sink', () => {
    const touch = new TouchFlight();
    for (const id of [1, 2, 3]) touch.down(id, 0, 0);
    for (const id of [1, 2, 3]) touch.move(id, 0, -45);
    expect(touch.thrust()).toEqual([0, 0.5, 0]);
  });
});
