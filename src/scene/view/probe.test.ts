import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { distance, length, type Vec3, ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { makeObject, restingAt } from '../defaults.ts';
import type { Mesh, Motion, SceneObject } from '../types.ts';
import { probeVertex, probeVertices } from './probe.ts';

const c = 10;
const point = (motion: Motion, given: Partial<SceneObject> = {}): SceneObject => {
  const mesh: Mesh = {
    positions: new Float32Array(3),
    normals: Float32Array.of(0, 0, 1),
    uvs: new Float32Array(2),
    indices: new Uint32Array(0),
    groups: [],
    doubleSided: false,
  };
  return makeObject({ path: '/P', mesh, motion, ...given });
};
const passing = (position: Vec3, velocity: Vec3): Motion => ({
  kind: 'uniform',
  pose: { position, orientation: IDENTITY },
  velocity,
});
const atRest = { t: 0, position: ZERO, u: ZERO };

describe('probe, against closed forms', () => {
  it('a point receding at 0.6 c, 16 m away now, is seen at 10 m, D = 1/2', () => {
    const p = probeVertex(point(passing([16, 0, 0], [6, 0, 0])), 0, atRest, c)!;
    expect(p.time).toBeCloseTo(-1, 12);
    expect(distance(p.position, [10, 0, 0])).toBeLessThan(1e-12);
    expect(p.doppler).toBeCloseTo(0.5, 12);
    expect(p.distance).toBeCloseTo(10, 12);
  });

  it('a point approaching at 0.6 c, 4 m away now, is seen at 10 m, D = 2', () => {
    const p = probeVertex(point(passing([4, 0, 0], [-6, 0, 0])), 0, atRest, c)!;
    expect(p.time).toBeCloseTo(-1, 12);
    expect(p.doppler).toBeCloseTo(2, 12);
  });

  it('seen at right angles, a moving point is redshifted by 1/γ', () => {
    // Emitted at x = 0, y = 8, 0.8 s ago; now at x = 4.8.
    const p = probeVertex(point(passing([4.8, 8, 0], [6, 0, 0])), 0, atRest, c)!;
    expect(distance(p.position, [0, 8, 0])).toBeLessThan(1e-12);
    expect(p.doppler).toBeCloseTo(0.8, 12);
  });

  it('a moving observer in a world at rest: 5 m ahead appears at 10 m, points abeam at tan θ = 1/u', () => {
    const observer = { ...atRest, u: properVelocity([0, 0, -0.6]) };
    const ahead = probeVertex(point(restingAt([0, 0, -5])), 0, observer, c)!;
    expect(distance(ahead.apparent, [0, 0, -10])).toBeLessThan(1e-12);
    expect(ahead.doppler).toBeCloseTo(2, 12);
    const abeam = probeVertex(point(restingAt([3, 0, 0])), 0, observer, c)!;
    expect(distance(abeam.apparent, [3, 0, -3 * 0.75])).toBeLessThan(1e-12);
    expect(abeam.doppler).toBeCloseTo(1.25, 12);
    expect(abeam.distance).toBeCloseTo(1.25 * 3, 12);
  });

  it('in the simultaneity view a rod at rest in the world is contracted by γ for an observer moving along it', () => {
    const observer = { ...atRest, u: properVelocity([0.8, 0, 0]) };
    const [tail, head] = [-2, 3].map((x) => probeVertex(point(restingAt([x, 0, 0])), 0, observer, c, 'simultaneity')!);
    expect(head.apparent[0] - tail.apparent[0]).toBeCloseTo(5 * 0.6, 12);
    expect(head.time).toBeCloseTo((0.8 * 3) / c, 12);
    expect(head.doppler).toBe(1);
  });

  it('in the galilean view every point is where it is now', () => {
    const p = probeVertex(
      point(passing([1, 2, 3], [6, 0, 0])),
      0,
      { t: 2, position: [0, 2, 3], u: [5, 0, 0] },
      c,
      'galilean',
    )!;
    expect(p).toMatchObject({ time: 2, apparent: [13, 0, 0], doppler: 1 });
  });

  it('lifetimes are tested at the displayed event', () => {
    const object = point(restingAt([20, 0, 0]), { lifetime: { birth: 0, death: 1 } });
    const seen = (t: number) => probeVertex(object, 0, { ...atRest, t }, c)!.visible;
    expect([1.9, 2.1, 2.9, 3.1].map(seen)).toEqual([false, true, true, false]);
    expect(probeVertex(object, 0, { ...atRest, t: 0.5 }, c, 'galilean')!.visible).toBe(true);
  });

  it('points behind the horizon are not visible', () => {
    const motion: Motion = {
      kind: 'hyperbolic',
      pose: { position: [10, 0, 0], orientation: IDENTITY },
      properAcceleration: [10, 0, 0],
      t0: 0,
    };
    // c²/a = 10 m: the origin is on the horizon at t = 0 and inside it before.
    expect(probeVertices(point(motion), { ...atRest, t: -1 }, c)).toEqual([undefined]);
    const seen = probeVertex(point(motion), 0, { ...atRest, t: 1 }, c)!;
    expect(length(seen.position)).toBeCloseTo(c * (1 - seen.time), 9);
  });

  it.each([1e-16, 1e-12, 1e-6])('points %s c²/a before the horizon have a finite D', (before) => {
    const motion: Motion = {
      kind: 'hyperbolic',
      pose: { position: [before, 0, 0], orientation: IDENTITY },
      properAcceleration: [-1, 0, 0],
      t0: 0,
    };
    // c = 1: x = before + 1 − √(1 + t²) crosses the light cone of (t = −1, x = 0, y = −2) where e^φ, φ < 0 the rapidity along −x, is tiny.
    const seen = probeVertex(point(motion), 0, { t: -1, position: [0, -2, 0], u: ZERO }, 1);
    expect(seen?.visible).toBe(true);
    expect(Number.isFinite(seen!.doppler)).toBe(true);
    // With w = e^φ: 1/D = [w(1 + n) + (1 − n)/w]/2 with 1 − n = 2² / (r² (1 + n)).
    const w = 1 / (Math.hypot(1, seen!.time) - seen!.time);
    const r = -1 - seen!.time;
    const n = Math.sqrt(1 - 4 / r ** 2);
    expect(seen!.doppler / (2 / (w * (1 + n) + 4 / (r * r * (1 + n)) / w))).toBeCloseTo(1, 3);
  });

  it('with a Newton solver has the event where its steps end, in what is seen and in simultaneity', () => {
    const wall = point(passing([0, 0, -8], [0, 0, 5]));
    const observer = { t: 0, position: ZERO, u: [0, 0, -0.75] } as const;
    const newton = { iterations: 1, damping: 0.3 };
    // Seen: f = 8 m at the observer's time, f′ = c − 5 m/s. In the slice: 0.3 of c Δt = 4.8/1.3 m.
    expect(probeVertex(wall, 0, observer, c, 'light-cone', { newton })!.time).toBeCloseTo((-0.3 * 8) / 5, 12);
    expect(probeVertex(wall, 0, observer, c, 'simultaneity', { newton })!.time).toBeCloseTo((0.3 * 4.8) / 1.3 / c, 12);
  });
});
