import { describe, expect, it } from 'vitest';
import { probePoint, settingsFor, tracedScene, viewFrom } from '../../../tests/support/rays.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { random } from '../../math/random.ts';
import { normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { makeObject } from '../../scene/defaults.ts';
import { sphere } from '../../scene/mesh/primitives.ts';
import type { Motion, SceneObject } from '../../scene/types.ts';
import type { View } from '../../scene/views/views.ts';
import { rayToward } from '../camera/lensRay.ts';
import { nearestHit } from './tracedScene.ts';

// From inside, a closed surface is seen in every direction, also exactly where triangles meet.

const mesh = sphere(2, { segments: 9, rings: 6 });
const pose = { position: [0.2, -0.3, 0.1] as Vec3, orientation: fromAxisAngle([1, 2, 3], 0.7) };
const times = Float64Array.from({ length: 60 }, (_, k) => -6 + k / 8);
const breathing = Array.from(times, (_, k) =>
  mesh.positions.map((x, i) => x * (1 + 0.04 * Math.sin(0.4 * k + 2 * Math.round(3 * mesh.positions[i - (i % 3)])))),
);

const motions: Record<string, Motion> = {
  'at rest': { kind: 'static', pose },
  'at constant speed': { kind: 'uniform', pose, velocity: [0.3, 0.2, -0.4] },
  'in hyperbolic motion': { kind: 'hyperbolic', pose, properAcceleration: [0.12, -0.05, 0.1], t0: -1 },
  turning: {
    kind: 'sampled',
    times,
    poses: Float64Array.from([...times].flatMap((t) => [...pose.position, ...fromAxisAngle([1, 1, 0], 0.3 * t)])),
  },
  breathing: { kind: 'sampled-points', times, origin: pose.position, points: breathing },
};

/** Weights of a corner, of the middle of an edge, and of any point on an edge, in all three cyclic orders. */
const seams = (chance: number): (readonly [v: number, w: number])[] => [
  [0, 0],
  [1, 0],
  [0, 1],
  [0.5, 0],
  [0, 0.5],
  [0.5, 0.5],
  [chance, 0],
  [0, chance],
  [chance, 1 - chance],
];

function holes(object: SceneObject, u: Vec3, view: View): number {
  const scene = tracedScene([object]);
  const observer = viewFrom({ u });
  const next = random(5);
  let missed = 0;
  for (let corner = 0; corner < mesh.indices.length; corner += 3)
    for (const [v, w] of seams(next())) {
      const seen = probePoint(object, { corner, v, w }, observer, 1, view);
      if (!seen) throw new Error('behind a horizon');
      if (!nearestHit(scene, rayToward(observer, settingsFor(view), normalize(seen.apparent)))) missed++;
    }
  return missed;
}

describe('a closed surface has no holes', () => {
  for (const [name, motion] of Object.entries(motions))
    for (const view of ['light-cone', 'simultaneity', 'galilean'] as const)
      it(`${name}, ${view}`, () => {
        for (const u of [[0, 0, 0] as Vec3, scale([0.6, -0.5, 0.4], 2.5)]) {
          expect(holes(makeObject({ path: '/Ball', mesh, motion }), u, view)).toBe(0);
          if (motion.kind !== 'static' && !motion.kind.startsWith('sampled'))
            expect(holes(makeObject({ path: '/Ball', mesh, motion, authoredIn: 'rest' }), u, view)).toBe(0);
        }
      });
});
