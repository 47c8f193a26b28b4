import { describe, expect, it } from 'vitest';
import { expectClose } from '../../../tests/support/physicsArbitraries.ts';
import { cornerAt, probePoint, settingsFor, tracedScene, viewFrom } from '../../../tests/support/rays.ts';
import { fromAxisAngle, IDENTITY, multiply, rotate } from '../../math/quat.ts';
import { addScaled, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { relativeVelocity, wignerRotation } from '../../physics/lorentz/velocity.ts';
import { makeObject } from '../../scene/defaults.ts';
import { box, plane, sphere } from '../../scene/mesh/primitives.ts';
import { resampleRotation } from '../../scene/motion/resample.ts';
import type { Mesh, Motion, SampledMotion, SceneObject } from '../../scene/types.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import type { Hit } from '../acceleration/ray.ts';
import { dopplerOfHit } from '../aov.ts';
import { cameraRay } from '../camera/cameraRay.ts';
import { rayToward } from '../camera/lensRay.ts';
import { nearestHit, type TracedScene } from './tracedScene.ts';

// c = 1 throughout; the observer is at the origin at t = 0.

const LIGHT = settingsFor('light-cone');
const seenToward = (scene: TracedScene, n: Vec3, view = viewFrom()): Hit | undefined =>
  nearestHit(scene, rayToward(view, LIGHT, normalize(n)));

const gammaOf = (beta: number): number => 1 / Math.sqrt(1 - beta * beta);
/** A body authored in its rest frame, at `position` at t = 0, that moves along x. */
const flying = (mesh: Mesh, position: Vec3, beta: number): SceneObject =>
  makeObject({
    path: '/Flying',
    mesh,
    authoredIn: 'rest',
    motion: { kind: 'uniform', pose: { position, orientation: IDENTITY }, velocity: [beta, 0, 0] },
  });
/** Where a point is seen that moves along x at y = 0 and z and is at x₀ at t = 0: x = x₀ − β√(x² + z²). */
function apparentX(x0: number, z: number, beta: number): number {
  const g = gammaOf(beta);
  return g * g * (x0 - beta * Math.hypot(x0, z / g));
}

describe('a passing sphere', () => {
  // In its rest frame its outline is a circle of directions; aberration changes angles from the velocity by tan(θ′/2) = k tan(θ/2), and circles stay circles.
  const [segments, rings] = [96, 48];
  const inner = Math.cos(Math.PI / segments) ** 2 - 1e-6;
  for (const beta of [0, 0.5, 0.9, 0.99])
    it(`has a circular outline: β = ${beta}`, () => {
      const [center, g]: [Vec3, number] = [[-2, 0, -5], gammaOf(beta)];
      const scene = tracedScene([flying(sphere(1, { segments, rings }), center, beta)]);
      const resting: Vec3 = [g * center[0], 0, center[2]];
      const middle = Math.atan2(-resting[2], resting[0]);
      // In its rest frame the observer moves along −x, and aberration shifts directions towards −x for the observer.
      const seen = (theta: number) => 2 * Math.atan(Math.sqrt((1 + beta) / (1 - beta)) * Math.tan(theta / 2));
      const circle = (radius: number) => {
        const open = Math.asin(radius / length(resting));
        const [from, to] = [seen(middle - open), seen(middle + open)];
        return { axis: (from + to) / 2, open: (to - from) / 2 };
      };
      const [large, small] = [circle(1 + 1e-6), circle(inner)];
      const toward = (axis: number, open: number, around: number): Vec3 => {
        const forward: Vec3 = [Math.cos(axis), 0, -Math.sin(axis)];
        const aside: Vec3 = [Math.sin(axis), 0, Math.cos(axis)];
        const out = addScaled(scale(aside, Math.cos(around)), [0, 1, 0], Math.sin(around));
        return addScaled(scale(forward, Math.cos(open)), out, Math.sin(open));
      };
      for (let i = 0; i < 60; i++) {
        const around = (2 * Math.PI * i) / 60;
        expect(seenToward(scene, toward(small.axis, small.open, around)), `inside, ${i}`).toBeDefined();
        expect(seenToward(scene, toward(large.axis, large.open, around)), `outside, ${i}`).toBeUndefined();
      }
    });
});

describe('a passing rod and cube', () => {
  it('the rod ends where the light of its ends arrives from', () => {
    for (const beta of [-0.95, -0.5, 0.3, 0.9]) {
      const [rest, z, g] = [2, -0.5, gammaOf(beta)];
      const rod = flying(plane(rest, 1e-3, 'Z'), [0.7, 0, z], beta);
      const ends = [-1, 1].map((side) => apparentX(0.7 + (side * rest) / (2 * g), z, beta));
      const at = (x: number) =>
        seenToward(tracedScene([{ ...rod, mesh: { ...rod.mesh, doubleSided: true } }]), [x, 0, z]);
      expect(at(ends[0] + 1e-9), `${beta}`).toBeDefined();
      expect(at(ends[1] - 1e-9), `${beta}`).toBeDefined();
      expect(at(ends[0] - 1e-9), `${beta}`).toBeUndefined();
      expect(at(ends[1] + 1e-9), `${beta}`).toBeUndefined();
      // Halfway between the ends as seen is not the middle of the rod.
      const middle = at((ends[0] + ends[1]) / 2);
      expectClose(middle?.time ?? 0, -Math.hypot((ends[0] + ends[1]) / 2, z), 1e-12);
    }
  });

  it('the distant cube looks rotated by arcsin β: rear of β L and side of L/γ (Terrell 1959)', () => {
    const [beta, far] = [0.8, 1e4];
    // Its light was emitted when it was straight ahead.
    const scene = tracedScene([flying(box([1, 1, 1]), [beta * far, 0, -far], beta)]);
    const rear: number[] = [];
    const side: number[] = [];
    for (let i = 0; i < 4000; i++) {
      const x = -2 + i / 1000;
      const hit = seenToward(scene, [x, 0.01, -far]);
      if (hit?.front && hit.normal[0] < -0.5) rear.push(x);
      else if (hit?.front && hit.normal[2] > 0.5) side.push(x);
      else expect(hit).toBeUndefined();
    }
    expectClose(rear.length / 1000, beta, 3e-3);
    expectClose(side.length / 1000, 1 / gammaOf(beta), 3e-3);
    expect(Math.max(...rear)).toBeLessThan(Math.min(...side));
  });

  it('the cube in the simultaneity view is contracted by γ', () => {
    const view = viewFrom({ u: [0.75, 0, 0] });
    const ahead = rayToward(view, settingsFor('simultaneity'), [1, 0, 0]);
    const scene = tracedScene([makeObject({ path: '/Cube', mesh: box([2, 2, 2]), motion: at([9, 0.1, 0.1]) })]);
    const near = nearestHit(scene, ahead)?.s ?? 0;
    const back = nearestHit(scene, ahead, { begin: near + 1e-9 })?.s ?? 0;
    expectClose(near, 8 / 1.25, 1e-12);
    expectClose(back - near, 2 / 1.25, 1e-12);
  });
});

const at = (position: Vec3): Motion => ({ kind: 'static', pose: { position, orientation: IDENTITY } });

describe('a rotating wheel', () => {
  const [omega, height] = [0.8, 1.3];
  /** Rotation about z, from before everything seen until now; sampled so that chords are within `tolerance` of arcs of radius 1. */
  const turning = (tolerance: number): SampledMotion => {
    const times = Array.from({ length: 9 }, (_, i) => -4 + i / 2);
    const poses = times.flatMap((t) => [0, 0, -height, ...fromAxisAngle([0, 0, 1], omega * t)]);
    return { kind: 'sampled', ...resampleRotation(times, poses, 1, tolerance) };
  };

  it('shows spokes as spirals along its axis: each radius as it was √(r² + h²) ago', () => {
    const tolerance = 1e-6;
    const disc = makeObject({ path: '/Disc', mesh: plane(1.4, 1.4, 'Z'), motion: turning(tolerance) });
    const scene = tracedScene([disc]);
    for (let i = 0; i < 200; i++) {
      const [r, phi] = [0.05 + (0.64 * (i % 20)) / 20, i * 0.7];
      const hit = seenToward(scene, [r * Math.cos(phi), r * Math.sin(phi), -height]);
      if (!hit) return expect.fail(`nothing at r = ${r}`);
      const [a, b, c] = [0, 1, 2].map((k) => cornerAt(disc, hit.corner, k));
      const own = addScaled(addScaled(a, sub(b, a), hit.v), sub(c, a), hit.w);
      const spoke = phi + omega * Math.hypot(r, height);
      expectClose(own, [r * Math.cos(spoke), r * Math.sin(spoke), 0], 2 * tolerance);
      expectClose(hit.velocity, [-omega * r * Math.sin(phi), omega * r * Math.cos(phi), 0], 2e-3);
    }
  });
});

describe('a spot faster than light', () => {
  it('sweeping over a wall at 3 c it is seen to split where its speed towards the observer is c', () => {
    // Plates at x that exist while the spot is there, t = x/3: the spot is seen at x at t = x/3 + √(x² + z²).
    const [speed, z, width] = [3, -4, 0.25];
    const plates = Array.from({ length: 80 }, (_, i) => {
      const x = (i - 40) * width;
      const lifetime = { birth: (x - width / 2) / speed, death: (x + width / 2) / speed };
      return makeObject({ path: `/Plate${i}`, mesh: plane(width, 1, 'Z'), motion: at([x, 0, z]), lifetime });
    });
    const scene = tracedScene(plates);
    const litAt = (t: number) =>
      plates.flatMap((_, i) =>
        seenToward(scene, [(i - 40) * width, 0, z], viewFrom({ t })) ? [(i - 40) * width] : [],
      );
    for (const t of [3.9, 4.5, 5, 6, 7]) {
      const expected = plates.flatMap((_, i) => {
        const x = (i - 40) * width;
        return Math.abs(t - Math.hypot(x, z) - x / speed) <= width / 2 / speed ? [x] : [];
      });
      expect(litAt(t), `t = ${t}`).toEqual(expected);
    }
    // √(x² + z²) + x/3 has its minimum where both derivatives cancel: before that time nothing is seen, after it two spots separate.
    expect(litAt(3.7)).toEqual([]);
    const two = litAt(6);
    expect(Math.min(...two)).toBeLessThan(-1.5);
    expect(Math.max(...two)).toBeGreaterThan(1.5);
  });
});

describe('equivalent motions look the same', () => {
  const mesh = box([1, 0.6, 2]);
  const pose = { position: [0.3, -0.2, -6] as Vec3, orientation: fromAxisAngle([1, 2, 0], 0.8) };
  const around = ([x, y, z]: Vec3): Vec3[] =>
    Array.from({ length: 400 }, (_, i) => [x + ((i % 20) - 9.7) / 40, y + (Math.floor(i / 20) - 9.6) / 40, z]);
  const compare = (a: Motion, b: Motion, tolerance: number, authoredIn: SceneObject['authoredIn'] = 'world') => {
    const [one, other] = [a, b].map((motion) =>
      tracedScene([
        makeObject({ path: '/It', mesh, motion, authoredIn: motion.kind === 'sampled-points' ? 'world' : authoredIn }),
      ]),
    );
    let met = 0;
    const middle = probePoint(one.objects[0], { corner: 0, v: 0.5, w: 0.5 }, viewFrom(), 1, 'light-cone');
    for (const n of around(normalize(middle?.apparent ?? [0, 0, 0]))) {
      const [p, q] = [seenToward(one, n), seenToward(other, n)];
      // On the outline a hit can depend on rounding.
      if (!p || !q) {
        if (tolerance < 1e-9) expect(q).toEqual(p);
        continue;
      }
      met++;
      expectClose(q.s, p.s, 30 * tolerance);
      if (q.corner !== p.corner) continue;
      expectClose([q.v, q.w, ...q.normal, ...q.velocity], [p.v, p.w, ...p.normal, ...p.velocity], 100 * tolerance);
      expect(q.front).toBe(p.front);
    }
    expect(met).toBeGreaterThan(30);
  };

  it('uniform samples and a uniform motion', () => {
    const velocity: Vec3 = [0.7, 0.1, -0.3];
    const times = Float64Array.of(-60, -11, -5.5, -5.1, 3);
    const poses = [...times].flatMap((t) => [...addScaled(pose.position, velocity, t), ...pose.orientation]);
    const sampled: Motion = { kind: 'sampled', times, poses: Float64Array.from(poses) };
    compare({ kind: 'uniform', pose, velocity }, sampled, 1e-14);
  });

  it('a hyperbolic motion and its samples', () => {
    const a: Vec3 = [0.15, 0.1, -0.05];
    const t0 = -4;
    const times = Float64Array.from({ length: 800 }, (_, i) => -16 + i / 50);
    const moved = (t: number) => scale(a, (t - t0) ** 2 / (1 + Math.hypot(1, length(a) * (t - t0))));
    const poses = [...times].flatMap((t) => [...addScaled(pose.position, moved(t), 1), ...pose.orientation]);
    const sampled: Motion = { kind: 'sampled', times, poses: Float64Array.from(poses) };
    compare({ kind: 'hyperbolic', pose, properAcceleration: a, t0 }, sampled, 1e-3);
  });

  it('all kinds at rest', () => {
    const times = Float64Array.of(-7, -6, -5);
    const poses = Float64Array.from([0, 1, 2].flatMap(() => [...pose.position, ...pose.orientation]));
    compare({ kind: 'static', pose }, { kind: 'sampled', times, poses }, 1e-14);
    compare({ kind: 'static', pose }, { kind: 'uniform', pose, velocity: [0, 0, 0] }, 0);
    compare({ kind: 'static', pose }, { kind: 'hyperbolic', pose, properAcceleration: [0, 0, 0], t0: 3 }, 1e-13);
  });
});

describe('a scene described in another frame', () => {
  // Everything as measured in a frame that moves with w; bodies keep their rest shapes. Axes carried by two boosts are turned by the Wigner rotation.
  const w: Vec3 = [0.4, -1.1, 0.9];
  const bodies = [
    { u: [0, 0, 0] as Vec3, position: [0, 0.5, -7] as Vec3, turn: fromAxisAngle([1, 1, 0], 0.7) },
    { u: [0.9, 0.2, 0.1] as Vec3, position: [4, -0.6, -6] as Vec3, turn: fromAxisAngle([0, 1, 2], 1.9) },
    { u: [-2, 0.3, 1] as Vec3, position: [-5, 0, -8] as Vec3, turn: fromAxisAngle([1, 0, 0.3], 0.4) },
  ];
  const made = ({ u, position, turn }: (typeof bodies)[number], i: number): SceneObject =>
    makeObject({
      path: `/${i}`,
      mesh: box([5, 4, 3]),
      authoredIn: 'rest',
      motion: {
        kind: 'uniform',
        pose: { position, orientation: turn },
        velocity: scale(u, 1 / Math.hypot(1, ...u)),
      },
    });
  const turned = (u: Vec3, by: ReturnType<typeof fromAxisAngle>) =>
    multiply(wignerRotation(w, relativeVelocity(u, w)), by);
  /** Position at t′ = 0 of a body that is at x at t = 0 and moves with u. */
  const moved = ({ u, position, turn }: (typeof bodies)[number]): (typeof bodies)[number] => {
    const seen = relativeVelocity(u, w);
    const g = Math.hypot(1, ...w);
    const time = -dot(w, position);
    const place = addScaled(position, w, dot(w, position) / (g + 1));
    return { u: seen, position: addScaled(place, seen, -time / Math.hypot(1, ...seen)), turn: turned(u, turn) };
  };

  it('looks the same', () => {
    const here = viewFrom({ u: [0.5, 0.2, -0.3], lens: perspective(1.4) });
    const there = { ...here, u: relativeVelocity(here.u, w), orientation: turned(here.u, here.orientation) };
    const [one, other] = [tracedScene(bodies.map(made)), tracedScene(bodies.map(moved).map(made))];
    const met = [0, 0, 0];
    for (let i = 0; i < 2400; i++) {
      const [x, y] = [(i % 60) + 0.5, Math.floor(i / 60) + 0.5];
      const [a, b] = [cameraRay(here, LIGHT, x, y, 60, 40)!, cameraRay(there, LIGHT, x, y, 60, 40)!];
      const [p, q] = [nearestHit(one, a), nearestHit(other, b)];
      expect(q?.object, `${x} ${y}`).toBe(p?.object);
      if (!p || !q) continue;
      met[p.object]++;
      expectClose([q.s, q.v, q.w], [p.s, p.v, p.w], 1e-11 * (1 + p.s));
      expectClose(dopplerOfHit(q, b, there.u), dopplerOfHit(p, a, here.u), 1e-11);
      const wigner = wignerRotation(w, relativeVelocity(bodies[p.object].u, w));
      expectClose(q.normal, rotate(wigner, p.normal), 1e-12);
      expect([q.corner, q.front]).toEqual([p.corner, p.front]);
    }
    for (const n of met) expect(n).toBeGreaterThan(20);
  });
});
