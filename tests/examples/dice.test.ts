import { describe, expect, it } from 'vitest';
import { sub, type Vec3 } from '../../src/math/vec3.ts';
import { emissionEvent } from '../../src/physics/worldLines/lightCone.ts';
import { pointAt } from '../../src/scene/mesh/polygons.ts';
import { originWorldLine } from '../../src/scene/motion/motion.ts';
import { probeVertex } from '../../src/scene/view/probe.ts';
import { objectAt, openExample, speedOfLight, vertexCount, worldPositions } from './open.ts';

const scene = await openExample('dice');
const c = speedOfLight(scene);
const DIE = '/World/Ivory3';

/** A die at rest rotated about the vertical by `angle`: its projection seen from far along z, and the depth of each point. */
const turned = ([x, y, z]: Vec3, angle: number): Vec3 => [
  x * Math.cos(angle) + z * Math.sin(angle),
  y,
  z * Math.cos(angle) - x * Math.sin(angle),
];

/** Where a distant observer along +z sees each vertex relative to the die's centre, when that is seen at right angles. */
function seenFromAfar(): { rest: Vec3; seen: Vec3 }[] {
  const die = objectAt(scene, DIE);
  if (die.motion.kind !== 'uniform') throw new Error(`${DIE} does not move uniformly`);
  const { position } = die.motion.pose;
  const [vx] = die.motion.velocity;
  const far = 1e5;
  // The centre is at x = 0 at −x₀/v; its light takes far/c.
  const observer = {
    t: -position[0] / vx + far / c,
    position: [0, position[1], position[2] + far] as Vec3,
    u: [0, 0, 0] as Vec3,
  };
  const middle = emissionEvent(originWorldLine(die.motion), observer, c)!;
  return Array.from({ length: vertexCount(die) }, (_, i) => ({
    rest: pointAt(die.mesh.positions, i),
    seen: sub(probeVertex(die, i, observer, c)!.position, middle.position),
  }));
}

describe('dice', () => {
  it('pass at 0.8 c, contracted to 0.6 in the frame of the table', () => {
    const xs = worldPositions(objectAt(scene, DIE), 3, c).map(([x]) => x);
    // The rounded box is 1 m; its pips protrude by a centimetre on either side.
    expect(Math.max(...xs) - Math.min(...xs)).toBeCloseTo(0.6 * 1.02, 2);
  });

  it('look rotated by arcsin 0.8, not contracted (Terrell)', () => {
    const angle = Math.asin(0.8);
    for (const { rest, seen } of seenFromAfar()) {
      const [x, y] = turned(rest, angle);
      expect(seen[0]).toBeCloseTo(x, 4);
      expect(seen[1]).toBeCloseTo(y, 4);
    }
  });

  it('show their rear, the six, although it faces away from the observer, and hide the one', () => {
    const die = objectAt(scene, DIE);
    const points = seenFromAfar();
    /** Projected area, positive if the outside faces the observer, of the triangles whose corners all have this x at rest. */
    const faceArea = (at: (x: number) => boolean): number => {
      let area = 0;
      for (let i = 0; i < die.mesh.indices.length; i += 3) {
        const [a, b, d] = [0, 1, 2].map((k) => points[die.mesh.indices[i + k]]);
        if (![a, b, d].every(({ rest }) => at(rest[0]))) continue;
        area +=
          ((b.seen[0] - a.seen[0]) * (d.seen[1] - a.seen[1]) - (d.seen[0] - a.seen[0]) * (b.seen[1] - a.seen[1])) / 2;
      }
      return area;
    };
    // The flat part of a side is 0.8 m square; 0.8 of it is visible.
    expect(faceArea((x) => Math.abs(x + 0.5) < 1e-4)).toBeGreaterThan(0.8 * 0.64 * 0.99);
    expect(faceArea((x) => Math.abs(x - 0.5) < 1e-4)).toBeLessThan(-0.8 * 0.64 * 0.99);
  });
});
