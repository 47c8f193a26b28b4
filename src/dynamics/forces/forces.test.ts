import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { uniform as between } from '../../../tests/support/physicsArbitraries.ts';
import { conjugate, fromAxisAngle, multiply, type Quat, rotate } from '../../math/quat.ts';
import { add, normalize, sub, type Vec3 } from '../../math/vec3.ts';
import { barrier } from './barrier.ts';
import { PenaltyPotential, sphereContacts } from './contact.ts';
import { coulomb } from './coulomb.ts';
import type { Force, Stiffness } from './force.ts';
import { NeighborPairs } from './neighborPairs.ts';
import { box, plane } from './obstacle.ts';
import { springForce } from './springs.ts';
import { uniformField } from './uniformField.ts';

const POINTS = 4;
const places = (size = 1.5): fc.Arbitrary<Float64Array> =>
  fc.array(between(-size, size), { minLength: 3 * POINTS, maxLength: 3 * POINTS }).map((x) => Float64Array.from(x));

const TURNED = fromAxisAngle([1, 2, -1], 0.7);
const FORCES: readonly (readonly [string, Force])[] = [
  [
    'springs',
    springForce({
      ends: Uint32Array.of(0, 1, 1, 2, 0, 3, 2, 3),
      stiffness: Float64Array.of(3, 100, 0.2, 7),
      lengths: Float64Array.of(1, 0.4, 0, 2),
    }),
  ],
  ['charges', coulomb(Float64Array.of(1, -2, 0, 0.5), 1)],
  ['weight', uniformField(Float64Array.of(1, 2, 0.5, 4), [0.3, -9.8, 1])],
  [
    'balls',
    sphereContacts(
      [
        { point: 1, radius: 0.9 },
        { point: 3, radius: 0.6 },
      ],
      [0, 2],
      { stiffness: 50, scale: 1.1 },
    ),
  ],
  ['a plane', barrier(plane([0, 0.2, 0], [0.2, 1, -0.1]), [0, 1, 2, 3], 80, 0.05)],
  ['a box', barrier(box([0.1, 0, 0], [1.8, 1.2, 2]), [0, 1, 2, 3], 80, 0.1)],
  ['a turned box', barrier(box([0.1, 0, 0], [1.8, 1.2, 2], TURNED), [0, 1, 2, 3], 80, 0.1)],
  [
    'points that are near',
    new NeighborPairs(Int32Array.of(0, 0, 1, 1), new Float64Array(12), 1, new PenaltyPotential(60, () => 1)),
  ],
];

const zeros = (): Float64Array => new Float64Array(3 * POINTS);
const forceOf = (force: Force, x: Float64Array): Float64Array => {
  const sum = zeros();
  force.add(x, sum);
  return sum;
};
const inner = (a: Float64Array, b: Float64Array): number => a.reduce((sum, value, j) => sum + value * b[j], 0);
const along = (x: Float64Array, u: Float64Array, s: number): Float64Array => x.map((value, j) => value + s * u[j]);
/** Forces of nearly coincident charges are too large to compare. */
const apart = (x: Float64Array): boolean =>
  [0, 1, 2].every((i) =>
    [1, 2, 3].every(
      (j) => j <= i || Math.hypot(x[3 * i] - x[3 * j], x[3 * i + 1] - x[3 * j + 1], x[3 * i + 2] - x[3 * j + 2]) > 0.2,
    ),
  );

/** Inside the box some points have two equally short exits. */
const oneWayOut = (x: Float64Array): boolean =>
  [0, 1, 2, 3].every((i) => {
    const over = [Math.abs(x[3 * i] - 0.1) - 0.9, Math.abs(x[3 * i + 1]) - 0.6, Math.abs(x[3 * i + 2]) - 1].sort(
      (a, b) => b - a,
    );
    return over[0] > 0 || over[0] - over[1] > 1e-3;
  });

function productOf(stiffness: Stiffness, u: Float64Array): Float64Array {
  const product = zeros();
  stiffness.multiply(u, product);
  return product;
}

describe.each(FORCES)('%s', (name, force) => {
  it('are minus the gradient of their potential', () => {
    fc.assert(
      fc.property(places(), places(), (x, u) => {
        fc.pre(apart(x) && (name !== 'a box' || oneWayOut(x)));
        const s = 1e-5;
        const slope = (force.energy(along(x, u, s)) - force.energy(along(x, u, -s))) / (2 * s);
        expect(Math.abs(inner(forceOf(force, x), u) + slope)).toBeLessThan(2e-3 * (1 + Math.abs(slope)));
      }),
    );
  });

  it('as discrete gradients do exactly the work that their potential loses', () => {
    fc.assert(
      fc.property(places(), places(), (x0, x1) => {
        fc.pre(apart(x0) && apart(x1));
        const mean = zeros();
        force.addDiscreteGradient(x0, x1, mean);
        const work = inner(mean, along(x1, x0, -1));
        const scale = Math.abs(force.energy(x0)) + Math.abs(force.energy(x1)) + 1;
        expect(Math.abs(work + force.energy(x1) - force.energy(x0))).toBeLessThan(1e-12 * scale);
      }),
    );
  });

  it('as discrete gradients equal the gradient without displacement', () => {
    fc.assert(
      fc.property(places(), (x) => {
        fc.pre(apart(x));
        const mean = zeros();
        force.addDiscreteGradient(x, x, mean);
        forceOf(force, x).forEach((value, j) => {
          expect(Math.abs(mean[j] - value)).toBeLessThan(1e-10 * (1 + Math.abs(value)));
        });
      }),
    );
  });
});

// The curvature at a box's edges is neglected by its stiffness.
describe.each(FORCES.filter(([name]) => !/box/.test(name)))('%s', (_, force) => {
  it('have a stiffness equal to the derivative of the force, with its own diagonal blocks', () => {
    fc.assert(
      fc.property(places(), places(), (x, u) => {
        fc.pre(apart(x));
        const s = 1e-6;
        const [ahead, behind] = [along(x, u, s), along(x, u, -s)];
        const [product, later, earlier] = [x, ahead, behind].map((at) => productOf(force.stiffness(at, 'exact'), u));
        // At first contact the force has a kink.
        fc.pre(Math.hypot(...along(later, earlier, -1)) < 1e-2 * (1 + Math.hypot(...product)));
        const change = along(forceOf(force, ahead), forceOf(force, behind), -1);
        const off = along(product, change, 1 / (2 * s));
        expect(Math.hypot(...off)).toBeLessThan(1e-3 * (1 + Math.hypot(...product)));
        const blocks = new Float64Array(6 * POINTS);
        force.stiffness(x, 'exact').addBlocks(blocks);
        for (let j = 0; j < 3 * POINTS; j++) {
          const unit = zeros();
          unit[j] = 1;
          const column = productOf(force.stiffness(x, 'exact'), unit);
          expect(blocks[6 * Math.floor(j / 3) + [0, 3, 5][j % 3]]).toBeCloseTo(column[j], 8);
        }
      }),
    );
  });
});

describe('a carried obstacle', () => {
  const axis = fc.tuple(between(-1, 1), between(-1, 1), between(0.1, 1));
  const spot = fc.tuple(between(-1, 1), between(-1, 1), between(-1, 1));
  const K = 80;

  it('pushes like a fixed one at its current pose', () => {
    fc.assert(
      fc.property(places(), axis, between(-3, 3), spot, spot, (x, about, angle, from, to) => {
        const turn = fromAxisAngle(normalize(about), angle);
        const arms = [
          to,
          add(to, rotate(multiply(turn, TURNED), [0.7, 0, 0])),
          add(to, rotate(multiply(turn, TURNED), [0, 2, 0])),
        ];
        const all = Float64Array.from([...x, ...arms.flat()]);
        const carried = barrier(box(from, [1.8, 1.2, 2], TURNED), [0, 1, 2, 3], K, 0.1, [4, 5, 6]);
        const stands = barrier(box(to, [1.8, 1.2, 2], multiply(turn, TURNED)), [0, 1, 2, 3], K, 0.1);
        expect(carried.energy(all)).toBeCloseTo(stands.energy(x), 9);
        const pushed = new Float64Array(all.length);
        carried.add(all, pushed);
        expect(pushed.slice(12).every((f) => f === 0)).toBe(true);
        // From the middle of an edge two exits are equally short.
        fc.pre([0, 1, 2, 3].every((i) => leadsOut(x, i, to, multiply(turn, TURNED))));
        const wanted = forceOf(stands, x);
        wanted.forEach((f, j) => {
          expect(pushed[j]).toBeCloseTo(f, 8);
        });
        // Without displacement the discrete gradient is the gradient.
        const mean = new Float64Array(all.length);
        carried.addDiscreteGradient(all, all, mean);
        wanted.forEach((f, j) => {
          expect(mean[j]).toBeCloseTo(f, 8);
        });
      }),
    );
  });
});

/** Whether one exit of a box is the shortest, by more than rounding error. */
function leadsOut(x: Float64Array, i: number, middle: Vec3, orientation: Quat): boolean {
  const d = rotate(conjugate(orientation), sub([x[3 * i], x[3 * i + 1], x[3 * i + 2]], middle));
  const over = [Math.abs(d[0]) - 0.9, Math.abs(d[1]) - 0.6, Math.abs(d[2]) - 1].sort((a, b) => b - a);
  return over[0] > 1e-6 || over[0] - over[1] > 1e-6;
}

describe('springs', () => {
  it('sum to the force of each alone, to rounding, whatever the order of their ends', () => {
    const pairs = fc.array(fc.tuple(fc.nat(POINTS - 1), fc.nat(POINTS - 1)), { minLength: 1, maxLength: 12 });
    fc.assert(
      fc.property(places(), pairs, (x, all) => {
        const ends = all.filter(([a, b]) => a !== b);
        const [k, L] = [(s: number) => 10 + 7 * s, (s: number) => 0.3 * (s % 4)];
        const springs = springForce({
          ends: Uint32Array.from(ends.flat()),
          stiffness: Float64Array.from(ends, (_, s) => k(s)),
          lengths: Float64Array.from(ends, (_, s) => L(s)),
        });
        const [wanted, size] = [zeros(), zeros()];
        ends.forEach(([a, b], s) => {
          const d = [0, 1, 2].map((i) => x[3 * a + i] - x[3 * b + i]);
          const r = Math.hypot(...d);
          for (let i = 0; i < 3; i++) {
            const pull = r > 0 ? (-k(s) * (r - L(s)) * d[i]) / r : 0;
            wanted[3 * a + i] += pull;
            wanted[3 * b + i] -= pull;
            for (const end of [a, b]) size[3 * end + i] += r > 0 ? (k(s) * (r + L(s)) * Math.abs(d[i])) / r : 0;
          }
        });
        forceOf(springs, x).forEach((value, j) => {
          expect(Math.abs(value - wanted[j])).toBeLessThanOrEqual(8 * Number.EPSILON * size[j]);
        });
      }),
    );
  });
});
