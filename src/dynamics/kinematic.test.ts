import { describe, expect, it } from 'vitest';
import { recordRun } from '../../tests/support/clothKit.ts';
import { saying } from '../../tests/support/inWords.ts';
import { fromAxisAngle, rotate } from '../math/quat.ts';
import type { Vec3 } from '../math/vec3.ts';
import { barrier } from './forces/barrier.ts';
import { sphereContacts } from './forces/contact.ts';
import { box, plane } from './forces/obstacle.ts';
import { springForce } from './forces/springs.ts';
import { METHODS } from './methods/library.ts';
import type { RunOptions } from './run.ts';
import { makeSystem, type System, stateAtRest } from './system.ts';

const OURS = ['discrete-gradient', 'implicit-midpoint', 'leapfrog', 'yoshida-4', 'yoshida-6', 'yoshida-8'];

function ranBy(id: string, system: System, x: readonly number[], more: Partial<RunOptions>) {
  const order = {
    system,
    start: stateAtRest(Float64Array.from(x)),
    method: METHODS.get(id)!,
    duration: 1,
    every: 0.05,
  };
  const { frames, stop } = recordRun({ ...order, ...more });
  return { frames, stop, last: frames.at(-1)! };
}

/** Point 0 rests at the origin; point 1 approaches along x. */
const coming = (speed: number, forces: System['forces']): System =>
  makeSystem({
    masses: Float64Array.of(1, 5),
    pinned: Uint8Array.of(0, 1),
    kinematic: [{ point: 1, positionAt: (t) => [-1 + speed * t, 0, 0] }],
    c: 10,
    forces,
  });

describe.each(OURS)('a kinematic body, by %s,', (id) => {
  const [u, c] = [5, 10];
  const solid: readonly (readonly [string, System['forces']])[] = [
    ['a ball', [sphereContacts([{ point: 1, radius: 0.3 }], [0])]],
    ['a wall', [barrier(plane([-1, 0, 0], [1, 0, 0]), [0], 10_000, 0.1, [1])]],
    ['a box', [barrier(box([-1, 0, 0], [0.4, 1, 1]), [0], 10_000, 0.1, [1])]],
  ];

  it.each(solid)('%s accelerates a point at rest to 2β/(1 + β²), and conserves H − u·p', (_, forces) => {
    const { frames, last } = ranBy(id, coming(u, forces), [0, 0, 0, -1, 0, 0], { step: 1e-4 });
    // For a potential V(x − ut), H − u·p is conserved: with p = 0 before, p = 2γ²mu after.
    expect(last.quantities.fastest / ((2 * u) / (1 + (u / c) ** 2))).toBeCloseTo(1, 5);
    expect(last.state.p[0] / (2 * u)).toBeCloseTo(1 / (1 - (u / c) ** 2), 5);
    expect(frames[0].quantities).toMatchObject({ kinetic: 0, fastest: 0, momentum: [0, 0, 0] });
    const kept = frames.map(({ quantities }) => quantities.total - u * quantities.momentum[0]);
    const off = Math.max(...kept.map(Math.abs)) / last.quantities.kinetic;
    expect(off).toBeLessThan(id === 'discrete-gradient' ? 1e-12 : 1e-4);
    expect(last.state.x[3]).toBeCloseTo(-1 + u * last.state.t, 12);
  });
});

/**
 * Point 0 rests at (1, 0, 0); a wall or box, carried by points 1, 2 and 3, rotates about z through the origin towards
 * it.
 */
const sweeping = (omega: number, forces: System['forces'], arm: Vec3): System => {
  const begin = -0.3;
  /** Rotates a point that is at (x, y, 0) at angle 0. */
  const turned =
    (x: number, y: number) =>
    (t: number): Vec3 => {
      const [cos, sin] = [Math.cos(begin + omega * t), Math.sin(begin + omega * t)];
      return [x * cos - y * sin, x * sin + y * cos, 0];
    };
  return makeSystem({
    masses: Float64Array.of(1, 1, 1, 1),
    pinned: Uint8Array.of(0, 1, 1, 1),
    kinematic: [
      { point: 1, positionAt: turned(arm[0], arm[1]) },
      { point: 2, positionAt: turned(arm[0] + 1, arm[1]) },
      { point: 3, positionAt: turned(arm[0], arm[1] + 1) },
    ],
    c: 10,
    forces,
  });
};

describe.each(OURS)('a rotating kinematic body, by %s,', (id) => {
  const [omega, c] = [5, 10];
  const first = fromAxisAngle([0, 0, 1], -0.3);
  const [middle, front] = [rotate(first, [0.8, 0, 0]), rotate(first, [0, 1, 0])];
  const K = 1e6;

  it.each([
    ['a box', barrier(box(middle, [1, 0.1, 1], first), [0], K, 0.05, [1, 2, 3])],
    ['a wall', barrier({ ...plane(middle, front), orientation: first }, [0], K, 0.1, [1, 2, 3])],
  ] as const)('%s accelerates a point at rest to 2β/(1 + β²), β at the contact, and conserves H − ωL', (_, force) => {
    // Position of the point in the box's frame at contact.
    const r = Math.sqrt(1 - 0.1 ** 2);
    const system = sweeping(omega, [force], [0.8, 0, 0]);
    const start = [
      1,
      0,
      0,
      ...[1, 2, 3].flatMap((point) => system.kinematic!.find((kinematic) => kinematic.point === point)!.positionAt(0)),
    ];
    const { frames, stop, last } = ranBy(id, system, start, { step: 1e-5, duration: 0.08, every: 0.01 });
    expect(stop).toBeUndefined();
    // For a uniformly rotating potential, H − ω·L is conserved: with both 0 before, p = 2γ²mωr after, perpendicular to
    // the arm.
    expect(last.quantities.fastest / ((2 * omega * r) / (1 + ((omega * r) / c) ** 2))).toBeCloseTo(1, 2);
    const kept = frames.map(
      ({ quantities }) => quantities.kinetic + quantities.potential - omega * quantities.angularMomentum[2],
    );
    expect(last.quantities.kinetic).toBeGreaterThan(10);
    expect(Math.max(...kept.map(Math.abs)) / last.quantities.kinetic).toBeLessThan(
      id === 'discrete-gradient' ? 1e-8 : 1e-5,
    );
    expect(last.state.p[1]).toBeGreaterThan(0);
    expect(Math.abs(last.state.p[2])).toBeLessThan(1e-12);
  });
});

/** A mass of 1 kg on a spring of zero length to a kinematic point; Newtonian. */
const towed = (place: (t: number) => Vec3): System =>
  makeSystem({
    masses: Float64Array.of(1, 1),
    pinned: Uint8Array.of(0, 1),
    kinematic: [{ point: 1, positionAt: place }],
    forces: [springForce({ ends: Uint32Array.of(0, 1), stiffness: Float64Array.of(40), lengths: Float64Array.of(0) })],
  });
const OMEGA = Math.sqrt(40);

describe.each([...METHODS.keys()].filter((id) => !/-[1-3]$/.test(id)))('a towed point, by %s,', (id) => {
  const error = (step: number): number => {
    const [u, a] = [0.7, 3];
    const system = towed((t) => [u * t, 0.5 * a * t * t, 0]);
    const { t, x } = ranBy(id, system, [0, 0, 0, 0, 0, 0], { step }).last.state;
    const swing = OMEGA * t;
    const right = [u * (t - Math.sin(swing) / OMEGA), a * (0.5 * t * t - (1 - Math.cos(swing)) / OMEGA ** 2), 0];
    return Math.hypot(...right.map((value, k) => x[k] - value));
  };

  it('oscillates about the moving anchor, and converges with the step', () => {
    const order = Math.min(2, METHODS.get(id)!.order);
    expect(error(1e-3)).toBeLessThan(order === 1 ? 0.01 : 1e-5);
    expect(error(2e-3) / error(1e-3)).toBeGreaterThan(0.9 * 2 ** order);
  });
});

it('a run with kinematic points resumes from any frame to the same bits', () => {
  const system = towed((t) => [Math.sin(3 * t), 0.1 * t, 0]);
  const more = { step: 1e-3, duration: 3, every: 1 / 7 };
  const whole = ranBy('discrete-gradient', system, [0, 0, 0, 0, 0, 0], more);
  const { state: start, ...tally } = whole.frames[8];
  const since = { t: 0, frames: 8, tally };
  const rest = ranBy('discrete-gradient', system, [], { ...more, start, since, duration: 3 - 8 / 7 });
  rest.frames.forEach(({ state }, k) => {
    expect(state).toEqual(whole.frames[8 + k].state);
  });
});

it('a kinematic point faster than light ends the run, and is reported', () => {
  const { frames, stop } = ranBy('leapfrog', coming(11, []), [0, 0, 0, -1, 0, 0], {});
  expect(frames).toHaveLength(1);
  expect(stop).toMatchObject({ reason: 'light', point: 1, message: saying('moved at 11.00 m/s') });
});
