import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromAxisAngle, IDENTITY, rotate } from '../math/quat.ts';
import { distance, length, sub, type Vec3 } from '../math/vec3.ts';
import { NO_CONTROLS } from './controls.ts';
import { type HeldCamera, walkAbout } from './hold.ts';

const RULES = { c: 10, maxSpeed: 0.9, up: [0, 1, 0] } as const;
const START: HeldCamera = { vantage: [1, 2, 3], orientation: fromAxisAngle([0, 1, 0], Math.PI / 2) };
const part = fc.double({ min: -1, max: 1, noNaN: true });
const pushes = fc.tuple(part, part, part).map((x): Vec3 => x);

describe('walking about in what is held', () => {
  it('goes straight on at the walking speed, half the greatest, and at full speed twice as far', () => {
    const forward = { ...NO_CONTROLS, thrust: [0, 0, -1] as Vec3 };
    // The nose points to −X: a quarter turn to the left from −Z.
    const walked = sub(walkAbout(START, forward, 2, RULES).vantage, START.vantage);
    expect(distance(walked, [-9, 0, 0])).toBeLessThan(1e-12);
    const run = sub(walkAbout(START, { ...forward, fullSpeed: true }, 2, RULES).vantage, START.vantage);
    expect(distance(run, [-18, 0, 0])).toBeLessThan(1e-12);
  });

  it('comes back by the opposite pushes, in as many steps as one likes', () => {
    fc.assert(
      fc.property(pushes, fc.integer({ min: 1, max: 20 }), (thrust, steps) => {
        const there = walkAbout(START, { ...NO_CONTROLS, thrust }, 1, RULES);
        let camera = there;
        for (let k = 0; k < steps; k++)
          camera = walkAbout(
            camera,
            { ...NO_CONTROLS, thrust: [-thrust[0], -thrust[1], -thrust[2]] },
            1 / steps,
            RULES,
          );
        expect(distance(camera.vantage, START.vantage)).toBeLessThan(1e-12);
      }),
    );
  });

  it('turns in place, about the scene’s up, and rises along it with the nose anywhere', () => {
    const turned = walkAbout(
      { vantage: [0, 0, 0], orientation: IDENTITY },
      { ...NO_CONTROLS, turn: [0.4, 0.7, 0] },
      1,
      RULES,
    );
    expect(length(turned.vantage)).toBe(0);
    const [x, y, z] = rotate(turned.orientation, [0, 0, -1]);
    expect(Math.asin(y)).toBeCloseTo(0.4, 12);
    expect(Math.atan2(-x, -z)).toBeCloseTo(0.7, 12);
    const risen = walkAbout(turned, { ...NO_CONTROLS, thrust: [0, 1, 0] }, 1, RULES);
    expect(distance(risen.vantage, [0, 4.5, 0])).toBeLessThan(1e-12);
  });
});
