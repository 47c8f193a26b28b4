import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { expectClose, uniform } from '../../../../tests/support/physicsArbitraries.ts';
import { probePoint, settingsFor, tracedScene, viewFrom } from '../../../../tests/support/rays.ts';
import { distance, lerp, normalize } from '../../../math/vec3.ts';
import { boundingSphere } from '../../../scene/bounds/bounds.ts';
import { makeObject } from '../../../scene/defaults.ts';
import { pointAt } from '../../../scene/mesh/polygons.ts';
import { grid } from '../../../scene/mesh/primitives.ts';
import { type CubicPointsMotion, parabolaVelocities } from '../../../scene/motion/cubicPoints.ts';
import { deformedPoints } from '../../../scene/motion/deformedPoints.ts';
import type { View } from '../../../scene/views/views.ts';
import { rayToward } from '../../camera/lensRay.ts';
import { nearestHit } from '../tracedScene.ts';
import { CubicChords } from './cubicChords.ts';

const C = 10;
const mesh = grid(4, 4, 3, 3);

/** Waves on a sheet across the line of sight, at up to 0.7 c. */
function waves(): CubicPointsMotion {
  const times = Float64Array.from({ length: 24 }, (_, k) => -3 + k / 7);
  const points = Array.from(times, (t) =>
    mesh.positions.map((x, i) => x + [0.2, 0.1, 0.6][i % 3] * Math.sin(9 * t + mesh.positions[i - (i % 3)] + (i % 3))),
  );
  return { kind: 'sampled-points', times, origin: [0, 0, -6], points, velocities: parabolaVelocities(times, points) };
}
const motion = waves();
const object = makeObject({ path: '/Sheet', mesh, motion });

describe('chords of a cubic', () => {
  const shapes = new CubicChords(motion, C);
  it('deviate from it by less than a millionth of the size, and end on it', () => {
    const { radius } = boundingSphere(motion.points[12]);
    let [worst, beside, bulge] = [0, 0, 0];
    const [from, to] = [new Float64Array(3), new Float64Array(3)];
    for (let j = 0; j + 1 < shapes.times.length; j++) {
      const chords = shapes.chordsIn(j);
      const time = (chord: number) => shapes.times[j] + (chord / chords) * (shapes.times[j + 1] - shapes.times[j]);
      const [begin, finish] = [shapes.at(j), shapes.at(j + 1)];
      for (let chord = 0; chord < chords; chord++) {
        const exact = deformedPoints(motion, time(chord), C);
        const middle = deformedPoints(motion, (time(chord) + time(chord + 1)) / 2, C);
        for (let i = 0; 3 * i < mesh.positions.length; i++) {
          shapes.chordEnd(i, j, chord, from, 0);
          shapes.chordEnd(i, j, chord + 1, to, 0);
          beside = Math.max(beside, distance(pointAt(from, 0), exact(i)));
          if (chord === 0) expect(distance(pointAt(begin, i), pointAt(from, 0))).toBeLessThan(1e-14);
          if (chord === chords - 1) expect(distance(pointAt(finish, i), pointAt(to, 0))).toBeLessThan(1e-14);
          worst = Math.max(worst, distance(lerp(pointAt(from, 0), pointAt(to, 0), 0.5), middle(i)));
          const whole = lerp(pointAt(begin, i), pointAt(finish, i), chord / chords);
          bulge = Math.max(bulge, distance(whole, exact(i)) - shapes.chordErrorIn(j));
        }
      }
    }
    expect(bulge).toBeLessThan(1e-9);
    expect(beside).toBeLessThan(1e-12);
    expect(worst).toBeLessThan(1.001e-6 * radius);
    expect(worst).toBeGreaterThan(1e-7 * radius);
  });
  it('lie in their boxes, also between the ends', () => {
    const boxes = new Float64Array(6 * shapes.times.length);
    shapes.times.forEach((_, j) => {
      shapes.outline(j, boxes);
    });
    let out = 0;
    shapes.times.forEach((time, j) => {
      const at = deformedPoints(motion, time, C);
      for (let i = 0; 3 * i < mesh.positions.length; i++)
        at(i).forEach((x, k) => {
          out = Math.max(out, boxes[6 * j + k] - x, x - boxes[6 * j + 3 + k]);
        });
    });
    expect(out).toBeLessThan(1e-6);
  });
});

it('the hit of a surface point has the position, time and velocity of the formulas for single points', () => {
  const scene = tracedScene([object], C);
  const views = fc.constantFrom<View>('light-cone', 'simultaneity', 'galilean');
  const corner = fc.integer({ min: 0, max: mesh.indices.length / 3 - 1 }).map((k) => 3 * k);
  fc.assert(
    fc.property(corner, uniform(0.1, 0.4), uniform(0.1, 0.4), uniform(-1, 2), views, (at, v, w, t, view) => {
      const observer = viewFrom({ t, position: [0.3, 0.2, 0], u: [0.4, 0, -1] });
      const probe = probePoint(object, { corner: at, v, w }, observer, C, view);
      if (!probe) return;
      const ray = rayToward(observer, settingsFor(view, C), normalize(probe.apparent));
      const hit = nearestHit(scene, ray);
      // Another part may be in front of it.
      if (!hit || hit.corner !== at) return;
      expectClose(hit.position, probe.position, 5e-5);
      expectClose(hit.time, probe.time, 2e-5);
      expectClose(hit.velocity, probe.velocity, 2e-4);
    }),
    { numRuns: 200 },
  );
});
