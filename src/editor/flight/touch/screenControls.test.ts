import { describe, expect, it } from 'vitest';
import { ScreenControls, sliderSpeed, speedPosition } from './screenControls.ts';
import { zoomedFieldOfView } from './zoom.ts';

describe('controls on the screen', () => {
  it('the pad pushes as far as the finger is from its middle, at most at full thrust, beyond its rim at full speed', () => {
    const controls = new ScreenControls();
    expect(controls.thrust).toEqual([0, 0, 0]);
    controls.holdPad([0, -0.5]);
    expect(controls.thrust).toEqual([0, 0, -0.5]);
    expect(controls.fullSpeed).toBe(false);
    controls.holdPad([3, 4]);
    expect(controls.thrust).toEqual([0.6000000000000001, 0, 0.8]);
    expect(controls.fullSpeed).toBe(true);
    controls.holdPad(undefined);
    expect(controls.thrust).toEqual([0, 0, 0]);
    expect(controls.fullSpeed).toBe(false);
  });

  it('the throttle pushes ahead, or where the pad points', () => {
    const controls = new ScreenControls();
    controls.store.setState({ throttle: 0.5 });
    expect(controls.thrust).toEqual([0, 0, -0.5]);
    expect(controls.fullSpeed).toBe(true);
    controls.holdPad([-1, 0]);
    expect(controls.thrust).toEqual([-0.5, 0, 0]);
    controls.holdPad(undefined);
    controls.store.setState({ rise: 1 });
    expect(controls.thrust).toEqual([0, 0.5, 0]);
  });

  it('lets go of all', () => {
    const controls = new ScreenControls();
    controls.holdPad([1, 1]);
    controls.store.setState({ throttle: 1, rise: 1, brake: true });
    controls.letGo();
    expect(controls.store.getState()).toEqual({ throttle: 0, rise: 0, brake: false, pad: undefined });
  });
});

it('half of the slider is half the rapidity: twice it is the greatest speed, by the addition of velocities', () => {
  for (const maxSpeed of [0.01, 0.5, 0.95, 0.999999]) {
    const half = sliderSpeed(0.5, maxSpeed);
    expect((2 * half) / (1 + half * half)).toBeCloseTo(maxSpeed, 12);
    expect(speedPosition(half, maxSpeed)).toBeCloseTo(0.5, 12);
    expect(sliderSpeed(1, maxSpeed)).toBeCloseTo(maxSpeed, 12);
  }
});

it('a zoom scales tangents: 90° by √3 is 60°', () => {
  expect(zoomedFieldOfView(Math.PI / 2, Math.sqrt(3))).toBeCloseTo(Math.PI / 3, 12);
});
