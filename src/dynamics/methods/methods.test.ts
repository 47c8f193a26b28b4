import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { uniform as between } from '../../../tests/support/physicsArbitraries.ts';
import { cross, type Vec3 } from '../../math/vec3.ts';
import { conservedQuantities } from '../energy.ts';
import { PenaltyPotential } from '../forces/contact.ts';
import { coulomb } from '../forces/coulomb.ts';
import { PairForce } from '../forces/pairs.ts';
import { springForce } from '../forces/springs.ts';
import { uniformField } from '../forces/uniformField.ts';
import { copyState, makeSystem, momenta, type State, type System, velocities } from '../system.ts';
import { METHODS } from './library.ts';
import { type IntegrationMethod, StepFailure } from './method.ts';

const method = (id: string): IntegrationMethod => METHODS.get(id)!;
/** Methods with momenta as state, which stay below c by construction. */
const OURS = ['discrete-gradient', 'implicit-midpoint', 'leapfrog', 'yoshida-4', 'yoshida-6', 'yoshida-8'] as const;
const OF_SOURCES = [...METHODS.keys()].filter((id) => !OURS.includes(id as (typeof OURS)[number]));

/** The documents say that the tangent correction may reverse accelerations, and that no step is short enough for it. */
const TANGENT = OF_SOURCES.filter((id) => id.endsWith('-1'));
const ALL = [...OURS, ...OF_SOURCES.filter((id) => !TANGENT.includes(id))];

function follow(system: System, start: State, by: IntegrationMethod, time: number, steps: number): State {
  const state = copyState(start);
  const stepper = by.begin(system);
  for (let i = 0; i < steps; i++) stepper.step(state, time / steps);
  return state;
}

const distance = (a: Float64Array, b: Float64Array): number => Math.hypot(...a.map((value, j) => value - b[j]));
const moving = (system: System, x: readonly number[], v: readonly number[]): State => ({
  t: 0,
  x: Float64Array.from(x),
  p: momenta(system, v),
});

/** A point on a spring of zero length to a pinned point at the origin. */
const oscillator = (c: number, k: number): System =>
  makeSystem({
    masses: Float64Array.of(1, 1),
    pinned: Uint8Array.of(1, 0),
    c,
    forces: [springForce({ ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(k), lengths: Float64Array.of(0) })],
  });

/** Complete elliptic integrals K(m) and E(m), by the arithmetic-geometric mean (Abramowitz and Stegun §17.6). */
function elliptic(m: number): readonly [K: number, E: number] {
  let [a, b, c, power, sum] = [1, Math.sqrt(1 - m), Math.sqrt(m), 0.5, 0.5 * m];
  while (Math.abs(c) > 1e-16) {
    [a, b, c] = [(a + b) / 2, Math.sqrt(a * b), (a - b) / 2];
    power *= 2;
    sum += power * c * c;
  }
  const K = Math.PI / (2 * a);
  return [K, K * (1 - sum)];
}

/**
 * Of √(p²c² + m²c⁴) + ½kx² with amplitude A: T = (4/ω)√… by the elliptic integrals: with a = kA²/2mc², γ = 1 + a cos²θ,
 * T = (4A/c√a) [√(2 + a) E(n) − K(n)/√(2 + a)], n = a/(2 + a).
 */
function period(c: number, k: number, A: number): number {
  const a = (k * A * A) / (2 * c * c);
  const [K, E] = elliptic(a / (2 + a));
  return ((4 * A) / (c * Math.sqrt(a))) * (Math.sqrt(2 + a) * E - K / Math.sqrt(2 + a));
}

/**
 * A spring of length 1 that is rotated slightly, with h²k/m = 1: there is no force across it, and a step of implicit
 * Euler keeps v. Linear systems with isotropic stiffness correct only half of the error, so each iteration halves it.
 */
describe('iterations of the published implicit methods', () => {
  it.each([
    ['linearly-implicit-0', 0],
    ['local-global-0', 2 ** -10],
  ])('%s leaves the fraction %s of the distance', (id, left) => {
    const [h, v] = [0.1, 1e-5];
    const ends = Uint32Array.of(0, 1);
    const system = makeSystem({
      masses: Float64Array.of(1, 1),
      pinned: Uint8Array.of(1, 0),
      forces: [springForce({ ends, stiffness: Float64Array.of(1 / h ** 2), lengths: Float64Array.of(1) })],
    });
    const end = follow(system, moving(system, [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, v, 0]), method(id), h, 1);
    expect(1 - end.x[4] / (v * h)).toBeCloseTo(left, 8);
  });
});

describe.each(OURS)('%s', (id) => {
  it.each([
    [0.01, 'slowly'],
    [1, ''],
    [6, 'at nearly c'],
  ])('oscillates with the period of elliptic integrals, at an amplitude of %s m', (A) => {
    const [c, k] = [1, 1];
    const T = period(c, k, A);
    const system = oscillator(c, k);
    const end = follow(system, moving(system, [0, 0, 0, A, 0, 0], [0, 0, 0, 0, 0, 0]), method(id), T, 4000);
    expect(Math.abs(end.x[3] / A - 1)).toBeLessThan(2e-5);
    expect(Math.abs(end.x[4])).toBe(0);
  });

  it('keeps a circular orbit: γmv²/r = k r', () => {
    const [c, r, beta] = [2, 1.5, 0.8];
    const gamma = 1 / Math.sqrt(1 - beta * beta);
    const k = (gamma * (beta * c) ** 2) / (r * r);
    const system = oscillator(c, k);
    const start = moving(system, [0, 0, 0, r, 0, 0], [0, 0, 0, 0, beta * c, 0]);
    const end = follow(system, start, method(id), (2 * Math.PI * r) / (beta * c), 3000);
    expect(distance(end.x, start.x)).toBeLessThan(2e-4);
    const [L0, L1] = [
      conservedQuantities(system, start).angularMomentum[2],
      conservedQuantities(system, end).angularMomentum[2],
    ];
    expect(Math.abs(L1 / L0 - 1)).toBeLessThan(1e-12);
  });

  it('orbits in a magnetic field at ω = qB/γm, at constant speed', () => {
    const [c, q, B, beta] = [1, 2, 0.7, 0.9];
    const system = makeSystem({
      masses: Float64Array.of(1.5),
      c,
      charges: Float64Array.of(q),
      magneticField: [0, 0, B],
    });
    const gamma = 1 / Math.sqrt(1 - beta * beta);
    const start = moving(system, [0, 0, 0], [beta, 0, 0]);
    const quarter = ((Math.PI / 2) * gamma * 1.5) / (q * B);
    const end = follow(system, start, method(id), quarter, 3000);
    const radius = Math.abs(start.p[0]) / (q * B);
    // F = q v × B: to the right of the motion, looking along −B.
    expect(end.x[0]).toBeCloseTo(radius, 5);
    expect(end.x[1]).toBeCloseTo(-radius, 5);
    expect(Math.hypot(...end.p) / Math.hypot(...start.p)).toBeCloseTo(1, 11);
  });

  it('conserves momentum and angular momentum of free systems, and is time-reversible', () => {
    const velocity = fc.tuple(between(-1, 1), between(-1, 1), between(-1, 1)).map(([x, y, z]): Vec3 => {
      const size = Math.max(1, Math.hypot(x, y, z) * 1.25);
      return [x / size, y / size, z / size];
    });
    const system = free();
    fc.assert(
      fc.property(fc.array(velocity, { minLength: 4, maxLength: 4 }), (v) => {
        const start = moving(system, TETRAHEDRON, v.flat());
        const [before, end] = [conservedQuantities(system, start), follow(system, start, method(id), 0.5, 40)];
        const later = conservedQuantities(system, end);
        for (let k = 0; k < 3; k++) {
          expect(later.momentum[k]).toBeCloseTo(before.momentum[k], 11);
          expect(later.angularMomentum[k]).toBeCloseTo(before.angularMomentum[k], 10);
        }
        const back = follow(system, { ...end, p: end.p.map((value) => -value) }, method(id), 0.5, 40);
        expect(distance(back.x, start.x)).toBeLessThan(1e-9);
      }),
      { numRuns: 20 },
    );
  });
});

describe.each(OURS)('%s', (id) => {
  it('stays below c, for any force and step', () => {
    const size = (low: number, high: number) => between(low, high).map((power) => 10 ** power);
    fc.assert(
      fc.property(size(-3, 5), size(-3, 2), size(-2, 4), size(-1, 8), (push, h, stiff, c) => {
        const masses = Float64Array.from(MASSES);
        const net = { ends: Uint32Array.from(ENDS), lengths: new Float64Array(6).fill(LENGTH) };
        const forces = [
          springForce({ ...net, stiffness: new Float64Array(6).fill(stiff) }),
          uniformField(masses, [0.6 * push * c, 0, 0.8 * push * c]),
        ];
        const system = makeSystem({ masses, c, forces });
        const state = moving(system, TETRAHEDRON, new Array(12).fill(0.5 * c));
        const stepper = method(id).begin(system);
        try {
          for (let i = 0; i < 5; i++) {
            const before = state.x.slice();
            stepper.step(state, h);
            // Rounding yields exactly c where 64 bits cannot represent the difference: γ > 10⁸.
            const { fastest } = conservedQuantities(system, state);
            expect(fastest).toBeLessThanOrEqual(c * (1 + 4 * Number.EPSILON));
            const momentum = Math.max(...state.p.map(Math.abs));
            if (momentum < 1e6 * c) expect(fastest).toBeLessThan(c);
            // Compositions also step backwards: by up to seven times as far.
            const far = Math.max(
              ...[0, 1, 2, 3].map((k) =>
                distance(state.x.subarray(3 * k, 3 * k + 3), before.subarray(3 * k, 3 * k + 3)),
              ),
            );
            expect(far).toBeLessThanOrEqual((id.startsWith('yoshida') ? 7 : 1 + 1e-9) * c * h);
          }
        } catch (error) {
          // An implicit step may fail with a StepFailure.
          if (!(error instanceof StepFailure)) throw error;
          expect(error.reason).toBe('unsolved');
        }
      }),
      { numRuns: 40 },
    );
  });
});

/** More than twice the error of a step of T/n, by order; tolerances for comparison with closed forms. */
const NEARLY = new Map([
  [1, 5e-3],
  [2, 5e-6],
]);
const nearly = (id: string): number => NEARLY.get(method(id).order) ?? 1e-9;

describe.each(ALL)('%s, published or ours,', (id) => {
  it('follows the hyperbola of a constant force: x = (√(1 + (Ft/mc)²) − 1) mc²/F', () => {
    const [c, F, time] = [3, 20, 2];
    const system = makeSystem({
      masses: Float64Array.of(1.5),
      c,
      forces: [uniformField(Float64Array.of(1), [0, F, 0])],
    });
    const end = follow(system, moving(system, [0, 0, 0], [0, 0, 0]), method(id), time, 4000);
    const s = (F * time) / (1.5 * c);
    expect(Math.abs(end.x[1] / (((Math.hypot(1, s) - 1) * 1.5 * c * c) / F) - 1)).toBeLessThan(nearly(id));
    expect(Math.abs(end.p[1] / (F * time) - 1)).toBeLessThan(nearly(id));
  });

  it.each([
    ['from rest, without a rest length', [1, 1], 0, 1.6],
    ['of unequal masses, without a rest length', [1, 3], 0, 1.6],
    ['from rest, stretched to three times its length', [1, 1], 0.8, 2.4],
  ])('two bodies on a spring oscillate as energy conservation requires: %s', (_, masses, length, apart) => {
    const [c, k] = [1, 0.7];
    const system = makeSystem({
      masses: Float64Array.from(masses),
      c,
      forces: [
        springForce({ ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(k), lengths: Float64Array.of(length) }),
      ],
    });
    // Along a line without singularities: until the spring is at rest length, or until both meet if that is 0.
    const T = timeToSlack(c, k, masses, length, apart);
    const end = follow(system, moving(system, [0, 0, 0, apart, 0, 0], [0, 0, 0, 0, 0, 0]), method(id), T, 4000);
    expect(Math.abs((end.x[3] - end.x[0] - length) / apart)).toBeLessThan(nearly(id));
    // Then all energy is kinetic, and both momenta are equal and opposite.
    const energy = (k * (apart - length) ** 2) / 2;
    expect(Math.abs(end.p[0] / momentumOf(c, masses, energy) - 1)).toBeLessThan(nearly(id));
    expect(Math.abs(end.p[3] / momentumOf(c, masses, energy) + 1)).toBeLessThan(nearly(id));
  });

  it('has the stated order', () => {
    const { order } = method(id);
    const system = free();
    const start = moving(system, TETRAHEDRON, SPIN);
    const exact = follow(system, start, method('yoshida-8'), 1, 4000);
    const steps = order === 1 ? [400, 800] : [20, 40];
    const errors = steps.map((n) => distance(follow(system, start, method(id), 1, n).x, exact.x));
    expect(Math.log2(errors[0] / errors[1])).toBeGreaterThan(order - 0.5);
    expect(Math.log2(errors[0] / errors[1])).toBeLessThan(order + (order > 4 ? 2.5 : 0.5));
  });

  it('converges to the common limit of all methods, for all forces', () => {
    const system = all(1.5);
    const start = moving(system, TETRAHEDRON, SPIN);
    const time = 0.4;
    const exact = follow(system, start, method('yoshida-8'), time, 400);
    const [coarse, fine] = [400, 800].map((n) => follow(system, start, method(id), time, n));
    // Richardson extrapolation removes the leading error: methods of order one become order two.
    const gain = 2 ** method(id).order;
    const limit = fine.x.map((value, j) => (gain * value - coarse.x[j]) / (gain - 1));
    expect(distance(limit, exact.x)).toBeLessThan(2e-5);
    expect(distance(limit, exact.x)).toBeLessThan(Math.max(1e-12, distance(coarse.x, exact.x) / 20));
  });

  it('approaches Newtonian mechanics for c → ∞', () => {
    const system = { ...free(), c: Number.POSITIVE_INFINITY };
    const start = moving(system, TETRAHEDRON, SPIN);
    const end = follow(system, start, method(id), 0.5, 2000);
    const off = distance(end.x, newton(start.x, Float64Array.from(SPIN), 0.5, 4000));
    expect(off).toBeLessThan(method(id).order === 1 ? 2e-3 : nearly(id));
    const fast = follow({ ...free(), c: 1e6 }, start, method(id), 0.5, 2000);
    expect(distance(fast.x, end.x)).toBeLessThan(1e-6);
  });
});

/**
 * Momentum of two bodies with opposite momenta and the given total kinetic energy [kg m/s]: (√(m₁² + q²) + √(m₂² + q²))
 * c² = E + (m₁ + m₂)c², q = p/c.
 */
function momentumOf(c: number, [m, n]: readonly number[], energy: number): number {
  const whole = energy / (c * c) + m + n;
  // Källén's function, as in a two-body decay.
  return (c * Math.sqrt((whole ** 2 - (m + n) ** 2) * (whole ** 2 - (m - n) ** 2))) / (2 * whole);
}

/**
 * Time in which a spring between two bodies at rest, `apart`, contracts to its rest length: ∫ dr/(v₁ + v₂), with p(r)
 * from energy conservation. r = L + (D − L) cos θ removes the singularity at the start; Simpson's rule.
 */
function timeToSlack(c: number, k: number, masses: readonly number[], length: number, apart: number): number {
  const A = apart - length;
  const integrand = (theta: number): number => {
    const p = momentumOf(c, masses, (k * A * A * Math.sin(theta) ** 2) / 2);
    const speed = masses.reduce((sum, m) => sum + p / Math.hypot(m, p / c), 0);
    return (A * Math.sin(theta)) / speed;
  };
  const n = 2000;
  // For θ → 0 the speeds are Newtonian: p = A sin θ √(kμ), v₁ + v₂ = p/μ.
  const mu = 1 / masses.reduce((sum, m) => sum + 1 / m, 0);
  const values = Array.from({ length: n + 1 }, (_, i) =>
    i === 0 ? Math.sqrt(mu / k) : integrand((Math.PI / 2) * (i / n)),
  );
  const sum = values.reduce((all, value, i) => all + value * (i === 0 || i === n ? 1 : i % 2 ? 4 : 2), 0);
  return (sum * Math.PI) / 2 / (3 * n);
}

/** Edges of a tetrahedron, each a different spring; it rotates and pulsates. */
const TETRAHEDRON = [1, 0, 0, 0, 1, 0, 0, 0, 1, -0.6, -0.6, -0.6];
const SPIN = [[1, 0, 0] as Vec3, [0, 1, 0] as Vec3, [0, 0, 1] as Vec3, [-0.6, -0.6, -0.6] as Vec3].flatMap((place) =>
  cross([0.2, 0.5, 0.3], place),
);
const ENDS = [0, 1, 0, 2, 0, 3, 1, 2, 1, 3, 2, 3];
const STIFFNESS = [4, 9, 7, 5, 8, 6];
const LENGTH = 1.2;
const MASSES = [1, 2, 0.5, 1.5];

const free = (): System =>
  makeSystem({
    masses: Float64Array.from(MASSES),
    c: 1,
    forces: [
      springForce({
        ends: Uint32Array.from(ENDS),
        stiffness: Float64Array.from(STIFFNESS),
        lengths: new Float64Array(6).fill(LENGTH),
      }),
    ],
  });

/** Springs, gravity, charges and a magnetic field. */
const all = (c: number): System => {
  const charges = Float64Array.of(0.8, -0.5, 0.3, 0.6);
  const { forces } = free();
  return makeSystem({
    ...{ masses: Float64Array.from(MASSES), c, charges, magneticField: [0.4, -0.3, 1.1] },
    forces: [...forces, uniformField(Float64Array.from(MASSES), [0.5, -2, 0.3]), coulomb(charges, 0.7)],
  });
};

/** The same springs by Newton’s second law with Runge–Kutta steps, independent of the tested code. */
function newton(x: Float64Array, v: Float64Array, time: number, steps: number): Float64Array {
  const h = time / steps;
  const pulled = (at: Float64Array): Float64Array => {
    const a = new Float64Array(at.length);
    for (let s = 0; s < 6; s++) {
      const [i, j] = [3 * ENDS[2 * s], 3 * ENDS[2 * s + 1]];
      const d = [0, 1, 2].map((k) => at[j + k] - at[i + k]);
      const r = Math.hypot(...d);
      for (let k = 0; k < 3; k++) {
        const f = (STIFFNESS[s] * (r - LENGTH) * d[k]) / r;
        a[i + k] += f / MASSES[i / 3];
        a[j + k] -= f / MASSES[j / 3];
      }
    }
    return a;
  };
  const plus = (a: Float64Array, b: Float64Array, s: number): Float64Array => a.map((value, j) => value + s * b[j]);
  let [place, speed] = [x, v];
  for (let i = 0; i < steps; i++) {
    const [a1, v1] = [pulled(place), speed];
    const [a2, v2] = [pulled(plus(place, v1, h / 2)), plus(speed, a1, h / 2)];
    const [a3, v3] = [pulled(plus(place, v2, h / 2)), plus(speed, a2, h / 2)];
    const [a4, v4] = [pulled(plus(place, v3, h)), plus(speed, a3, h)];
    place = place.map((value, j) => value + (h / 6) * (v1[j] + 2 * v2[j] + 2 * v3[j] + v4[j]));
    speed = speed.map((value, j) => value + (h / 6) * (a1[j] + 2 * a2[j] + 2 * a3[j] + a4[j]));
  }
  return place;
}

describe('the energy', () => {
  it('is conserved exactly by the discrete gradient, also with steps as long as oscillations', () => {
    const system = free();
    for (const h of [0.01, 0.1, 0.5]) {
      const state = moving(system, TETRAHEDRON, SPIN);
      const before = conservedQuantities(system, state);
      const stepper = method('discrete-gradient').begin(system);
      for (let i = 0; i < 3000; i++) stepper.step(state, h);
      const later = conservedQuantities(system, state);
      expect(Math.abs(later.total - before.total) / before.kinetic).toBeLessThan(1e-11);
      expect(Math.hypot(...later.angularMomentum) / Math.hypot(...before.angularMomentum)).toBeCloseTo(1, 10);
    }
  });

  it('oscillates without a trend with splittings', () => {
    const system = free();
    const state = moving(system, TETRAHEDRON, SPIN);
    const before = conservedQuantities(system, state);
    const stepper = method('leapfrog').begin(system);
    const worst = [0, 0];
    for (let i = 0; i < 20_000; i++) {
      stepper.step(state, 0.02);
      const off = Math.abs(conservedQuantities(system, state).total - before.total) / before.kinetic;
      const half = i < 10_000 ? 0 : 1;
      worst[half] = Math.max(worst[half], off);
    }
    expect(worst[0]).toBeLessThan(2e-2);
    expect(worst[1]).toBeLessThan(1.2 * worst[0]);
  });

  it('is conserved in collisions', () => {
    const law = new PenaltyPotential(10_000, () => 1.1);
    const system = makeSystem({
      masses: Float64Array.of(1, 2),
      c: 10,
      forces: [new PairForce(Uint32Array.of(0, 1), law)],
    });
    const start = moving(system, [0, 0, 0, 4, 0.3, 0], [8, 0, 0, -6, 0, 0]);
    const before = conservedQuantities(system, start);
    const end = follow(system, start, method('discrete-gradient'), 1, 2000);
    const later = conservedQuantities(system, end);
    expect(end.p[0]).toBeLessThan(0);
    expect(Math.abs(later.total / before.total - 1)).toBeLessThan(1e-11);
    expect(later.momentum[0]).toBeCloseTo(before.momentum[0], 9);
  });

  it('of two attracting charges is conserved, and they stay below c', () => {
    const system = makeSystem({ masses: Float64Array.of(1, 1), c: 1, forces: [coulomb(Float64Array.of(1, -1), 0.2)] });
    const start = moving(system, [-1, 0, 0, 1, 0, 0], [0, 0.2, 0, 0, -0.2, 0]);
    const before = conservedQuantities(system, start);
    const state = copyState(start);
    const stepper = method('discrete-gradient').begin(system);
    const v = new Float64Array(6);
    for (let i = 0; i < 4000; i++) {
      stepper.step(state, 1e-3);
      velocities(system, state.p, v);
      expect(Math.hypot(v[0], v[1], v[2])).toBeLessThan(1);
    }
    expect(Math.abs(conservedQuantities(system, state).total - before.total)).toBeLessThan(1e-10);
  });
});

describe('the published methods', () => {
  it.each(TANGENT)('fail with the tangent correction, also with shorter steps, as documented: %s', (id) => {
    const system = free();
    const start = moving(system, TETRAHEDRON, SPIN);
    const exact = follow(system, start, method('yoshida-8'), 0.2, 400);
    const [long, short] = [100, 1600].map((n) => distance(follow(system, start, method(id), 0.2, n).x, exact.x));
    expect(short).toBeGreaterThan(0.1);
    expect(short / long).toBeCloseTo(1, 2);
  });

  it('report when a point reached c, or when a matrix was singular', () => {
    const system = oscillator(1, 1000);
    const start = moving(system, [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 0.5, 0]);
    expect(() => follow(system, start, method('semi-implicit-euler-0'), 1, 50)).toThrow(/not below c = 1 m\/s/);
    const pressed = makeSystem({
      ...oscillator(10, 1000),
      forces: [
        springForce({ ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(1000), lengths: Float64Array.of(2) }),
      ],
    });
    const short = moving(pressed, [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 0.1, 0]);
    expect(() => follow(pressed, short, method('linearly-implicit-0'), 1, 10)).toThrow(/positive definite/);
  });
});
