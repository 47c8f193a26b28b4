import { describe, expect, it } from 'vitest';
import { expectClose } from '../../../tests/support/physicsArbitraries.ts';
import { properVelocityOf } from '../../flight/boost.ts';
import { IDENTITY_POSE, makeObject, makeScene, restingAt } from '../../scene/defaults.ts';
import { box, sphere } from '../../scene/mesh/primitives.ts';
import type { Motion } from '../../scene/types.ts';
import { sceneObstacles } from './sceneObstacles.ts';

const c = 10;
const among = (motion: Motion, mesh = box([2, 2, 2])) =>
  sceneObstacles(makeScene({ name: 'walls', objects: [makeObject({ path: '/Wall', mesh, motion })] }), c);

describe('a scene as obstacles', () => {
  it('meets a cube and a ball at rest on the way ahead, and nothing on the way back', () => {
    for (const mesh of [box([2, 2, 2]), sphere(1)]) {
      const obstacles = among(restingAt([0, 0, -9]), mesh);
      const wall = obstacles.first({ start: { t: 1, x: [0.1, 0.1, 0] }, dt: 0.5, dx: [0, 0, -2] }, 10)!;
      expect(wall.event.x[2]).toBeCloseTo(-8, 1);
      expect(wall.event.t).toBeCloseTo(1 + 0.25 * -wall.event.x[2], 12);
      expect(wall.normal[2]).toBeCloseTo(1, 1);
      expect(obstacles.first({ start: { t: 1, x: [0.1, 0.1, 0] }, dt: 0.5, dx: [0, 0, 2] }, 10)).toBeUndefined();
      expect(obstacles.first({ start: { t: 1, x: [0.1, 0.1, 0] }, dt: 0.5, dx: [0, 0, -2] }, 3)).toBeUndefined();
    }
  });

  it('a body in uniform, sampled and accelerated motion meets an observer at rest where it is then, not where it is seen', () => {
    // 0.6 c from z = −13 on; its front is a metre ahead in the world, where it is authored.
    const cube = { kind: 'uniform', pose: { ...IDENTITY_POSE, position: [0, 0, -13] }, velocity: [0, 0, 6] } as const;
    const sampled: Motion = {
      kind: 'sampled',
      times: Float64Array.of(0, 10),
      poses: Float64Array.of(0, 0, -13, 0, 0, 0, 1, 0, 0, 47, 0, 0, 0, 1),
    };
    for (const motion of [cube, sampled]) {
      const wall = among(motion).first({ start: { t: 0, x: [0.2, 0.1, 0] }, dt: 0.1, dx: [0, 0, 0] }, 1000)!;
      expect(wall.event.t).toBeCloseTo(2, 9);
      expectClose(properVelocityOf(wall.velocity), [0, 0, 0.75], 1e-9);
    }
    // z = −13 + (c²/a)(√(1 + (at/c)²) − 1), with c²/a = 20.
    const falling: Motion = { kind: 'hyperbolic', pose: cube.pose, properAcceleration: [0, 0, 5], t0: 0 };
    const met = among(falling).first({ start: { t: 0, x: [0.2, 0.1, 0] }, dt: 0.1, dx: [0, 0, 0] }, 1000)!;
    expect(met.event.t).toBeCloseTo(2 * Math.sqrt((1 + 12 / 20) ** 2 - 1), 9);
    expectClose(properVelocityOf(met.velocity), [0, 0, Math.sqrt((1 + 12 / 20) ** 2 - 1)], 1e-9);
  });
});
