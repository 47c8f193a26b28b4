import fc from 'fast-check';
import { expect, it } from 'vitest';
import { barrier } from '../dynamics/forces/barrier.ts';
import { sphereContacts } from '../dynamics/forces/contact.ts';
import { coulomb } from '../dynamics/forces/coulomb.ts';
import { box, plane } from '../dynamics/forces/obstacle.ts';
import { springForce } from '../dynamics/forces/springs.ts';
import { uniformField } from '../dynamics/forces/uniformField.ts';
import { makeSystem } from '../dynamics/system.ts';
import { type ForceRows, forceRowsOf, neighborRows, WORDS_PER_LINK } from './forceRows.ts';

const COUNT = 70;
const points = Array.from({ length: COUNT }, (_, i) => i);
const walls = [plane([0, -0.5, 0], [0.1, 1, 0]), box([0.4, 0, 0], [0.3, 0.4, 0.5])];
/** Springs in a ring, a sphere in contact with all others, charges, two obstacles. */
const system = makeSystem({
  masses: new Float64Array(COUNT).fill(1),
  pinned: Uint8Array.from(points, (i) => Number(i === 5)),
  forces: [
    barrier(walls[0], points, 40, 0.1),
    coulomb(
      Float64Array.from(points, (i) => (i < 4 ? i - 1.5 : 0)),
      0.1,
    ),
    springForce({
      ends: Uint32Array.from(points.flatMap((i) => [i, (i + 1) % COUNT])),
      stiffness: Float64Array.from(points, (i) => 1 + i),
      lengths: new Float64Array(COUNT).fill(0.3),
    }),
    sphereContacts(
      [{ point: 9, radius: 0.4 }],
      points.filter((i) => i !== 9),
    ),
    barrier(walls[1], [1, 2, 3], 50, 0.02),
    uniformField(Float64Array.from(points), [0.5, -1, 0.25]),
  ],
});

/** The force on a point from its row. */
function byLinks(links: ForceRows, x: Float64Array, point: number): number[] {
  const numbers = new Float32Array(links.words.buffer);
  const place = links.rowOfPoint[point];
  const at = (i: number): number[] => [...x.subarray(3 * i, 3 * i + 3)];
  const sum = [0, 1, 2].map((k) => links.constantForces[3 * place + k]);
  for (let s = links.rowStarts[place]; s < links.rowStarts[place + 1]; s++) {
    const [other, law] = links.words.subarray(WORDS_PER_LINK * s);
    const [strength, length] = numbers.subarray(WORDS_PER_LINK * s + 2);
    expect(law === 0).toBe(s < links.rowStarts[place] + links.springCounts[place]);
    if (law === 3) {
      const [far, out] = links.obstacles[other].distanceAndNormal(at(point) as never);
      for (let k = 0; k < 3; k++) sum[k] += strength * Math.max(0, length - far) * out[k];
      continue;
    }
    const to = at(links.pointOfRow[other]);
    const d = at(point).map((value, k) => value - to[k]);
    const r = Math.hypot(...d);
    const pull = law === 2 ? -strength / r ** 2 : strength * (law === 1 ? Math.min(0, r - length) : r - length);
    for (let k = 0; k < 3; k++) sum[k] -= (pull * d[k]) / r;
  }
  return sum;
}

it('rows of links give the same force as the potentials', () => {
  const links = forceRowsOf(system);
  expect(links.longRowCount).toBe(1);
  expect(links.pointOfRow.at(-1)).toBe(9);
  expect(links.rowStarts[links.rowOfPoint[5] + 1]).toBe(links.rowStarts[links.rowOfPoint[5]]);
  fc.assert(
    fc.property(
      fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: 3 * COUNT, maxLength: 3 * COUNT }),
      (values) => {
        const x = Float64Array.from(values, (value, j) => value + Math.sin(7 * j) / 3);
        const truth = new Float64Array(x.length);
        for (const force of system.forces) force.add(x, truth);
        for (const point of points.filter((i) => i !== 5)) {
          const found = byLinks(links, x, point);
          const size = Math.max(...truth.map(Math.abs));
          for (let k = 0; k < 3; k++) expect(Math.abs(found[k] - truth[3 * point + k])).toBeLessThan(1e-6 * size);
        }
      },
    ),
    { numRuns: 20 },
  );
});

it('near pairs are rows of indices, from both ends', () => {
  const placeOf = Uint32Array.of(2, 0, 1);
  const rows = neighborRows(placeOf, Uint32Array.of(0, 1, 0, 2));
  expect([...rows.subarray(0, 4)]).toEqual([0, 1, 2, 4]);
  expect([rows[4], rows[5], [...rows.subarray(6)].sort()]).toEqual([2, 2, [0, 1]]);
});
