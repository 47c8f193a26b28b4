import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, magnitude, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, IDENTITY, rotate } from '../../math/quat.ts';
import {
  add,
  addScaled,
  cross,
  distance,
  dot,
  length,
  normalize,
  scale,
  sub,
  type Vec3,
  ZERO,
} from '../../math/vec3.ts';
import { boost, gamma, properVelocity } from '../../physics/lorentz/boost.ts';
import { emissionEvent } from '../../physics/worldLines/lightCone.ts';
import { properTimeBetween } from '../../physics/worldLines/properTime.ts';
import { positionAt, velocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { makeObject, restingAt } from '../defaults.ts';
import { box, sphere } from '../mesh/primitives.ts';
import { vertexPosition, vertexWorldLine } from '../motion/motion.ts';
import type { Motion, SceneObject } from '../types.ts';
import { inspectEvent } from './inspectEvent.ts';
import { measureLengths } from './measureLengths.ts';
import { type SurfaceEvent, surfaceLine } from './surfaceLine.ts';

const c = 10;
const atRest = { t: 0, position: ZERO, u: ZERO };
const pose = (position: Vec3, orientation = IDENTITY) => ({ position, orientation });
const object = (motion: Motion, given: Partial<SceneObject> = {}) =>
  makeObject({ path: '/Thing', mesh: box([2, 1, 3]), motion, ...given });
/** What a picture says of a vertex that is seen. */
function seenVertex(thing: SceneObject, vertex: number, observer = atRest): SurfaceEvent {
  const { t, position, velocity } = emissionEvent(vertexWorldLine(thing, vertex, c), observer, c)!;
  return { time: t, position, velocity: scale(velocity, 1 / c) };
}

const turned = fromAxisAngle(normalize([1, 2, 3]), 0.7);
const spinning: Motion = {
  kind: 'sampled',
  times: Float64Array.of(-4, -2, 0, 2),
  poses: Float64Array.from(
    [-4, -2, 0, 2].flatMap((t) => [3 * t, 4, -5, ...fromAxisAngle(normalize([1, 1, 0]), 0.4 * t)]),
  ),
};
const cloth: Motion = {
  kind: 'sampled-points',
  times: Float64Array.of(-3, -1, 1),
  origin: [0, 0, -6],
  points: [-3, -1, 1].map((t) =>
    box([2, 1, 3]).positions.map((x, i) => x * (1 + 0.1 * t * Math.sin(i)) + (i % 3 ? 0 : t)),
  ),
};
const accelerated: Motion = {
  kind: 'hyperbolic',
  pose: pose([20, 3, 1], turned),
  properAcceleration: [3, 1, -2],
  t0: -0.5,
};
const flying: Motion = { kind: 'uniform', pose: pose([1, 5, -8], turned), velocity: [6, -2, 1] };
const THINGS: Readonly<Record<string, SceneObject>> = {
  'at rest': object(restingAt([3, 4, -5])),
  flying: object(flying),
  'flying, made at rest, stretched': object(flying, { authoredIn: 'rest', stretch: [2, 0, 0, 0, 1, 0.5, 0, 0.5, 1] }),
  turning: object(spinning),
  'turning, made at rest': object(spinning, { authoredIn: 'rest' }),
  accelerated: object(accelerated),
  'Born rigid': object(accelerated, { authoredIn: 'rest' }),
  deforming: object(cloth),
};

describe('the world line of a point of a surface', () => {
  it.each(Object.keys(THINGS))('%s: of a vertex it is that of the vertex', (name) => {
    const thing = THINGS[name]!;
    for (const vertex of [0, 5, 11, 17]) {
      const line = surfaceLine(thing, seenVertex(thing, vertex), c)!;
      for (const t of [-3.3, -1, 0.2, 1.7])
        expect(distance(positionAt(line, t, c), vertexPosition(thing, vertex, t, c))).toBeLessThan(1e-6);
    }
  });

  it('inside a triangle of a deforming mesh keeps its shares of the corners, also a little beside the surface', () => {
    const thing = THINGS.deforming!;
    const [i, j, k] = thing.mesh.indices;
    const mean = (t: number): Vec3 => {
      const [p, q, r] = [i!, j!, k!].map((v) => vertexPosition(thing, v, t, c));
      return add(add(scale(p!, 0.5), scale(q!, 0.2)), scale(r!, 0.3));
    };
    const [p, q, r] = [i!, j!, k!].map((v) => vertexPosition(thing, v, -2, c));
    const normal = normalize(cross(sub(q!, p!), sub(r!, p!)));
    const line = surfaceLine(thing, { time: -2, position: addScaled(mean(-2), normal, 1e-4), velocity: ZERO }, c)!;
    for (const t of [-2, 0, 0.7]) expect(distance(positionAt(line, t, c), mean(t))).toBeLessThan(1e-9);
  });
});

const speed = uniform(0.01, 0.99);

describe('an inspected point', () => {
  it('is turned by arcsin β when it is seen at right angles to its motion (Terrell 1959)', () =>
    fc.assert(
      fc.property(speed, (beta) => {
        const ball = object({ kind: 'uniform', pose: pose([0, 8, 0]), velocity: [c * beta, 0, 0] });
        const { rotation } = inspectEvent(
          ball,
          { time: 0, position: [0, 8, 0], velocity: [beta, 0, 0] },
          { ...atRest, t: 0.8 },
          c,
        )!;
        expect(rotation).toBeCloseTo(Math.asin(beta), 9);
      }),
    ));

  it('is turned as half angles say: tan(θ₀/2) = √((1 − β)/(1 + β)) tan(θ/2), θ from the direction of motion', () =>
    fc.assert(
      fc.property(speed, uniform(0.05, 3), (beta, theta) => {
        const at: Vec3 = [8 * Math.cos(theta), 8 * Math.sin(theta), 0];
        const ball = object({ kind: 'uniform', pose: pose(at), velocity: [c * beta, 0, 0] });
        const { rotation } = inspectEvent(
          ball,
          { time: 0, position: at, velocity: [beta, 0, 0] },
          { ...atRest, t: 0.8 },
          c,
        )!;
        const atRestAngle = 2 * Math.atan(Math.sqrt((1 - beta) / (1 + beta)) * Math.tan(theta / 2));
        expect(rotation).toBeCloseTo(theta - atRestAngle, 9);
      }),
    ));

  it('of a jet moves with β sin θ/(1 − β cos θ) across the sky, γβ at most, at cos θ = β (Rees 1966)', () =>
    fc.assert(
      fc.property(uniform(0.3, 0.999), uniform(0.01, 3), (beta, theta) => {
        const across = (angle: number) => {
          // θ is from the direction towards the observer.
          const velocity: Vec3 = [c * beta * Math.sin(angle), 0, c * beta * Math.cos(angle)];
          const jet = object({ kind: 'uniform', pose: pose([0, 0, -50]), velocity });
          return inspectEvent(
            jet,
            { time: 0, position: [0, 0, -50], velocity: scale(velocity, 1 / c) },
            { ...atRest, t: 5 },
            c,
          )!;
        };
        const found = across(theta);
        expect(found.apparentSpeedAcross).toBeCloseTo((beta * Math.sin(theta)) / (1 - beta * Math.cos(theta)), 6);
        const most = across(Math.acos(beta));
        expect(most.apparentSpeedAcross / (beta / Math.sqrt(1 - beta * beta))).toBeCloseTo(1, 8);
        // β/(1 − β cos θ) > 1.
        expect(found.superluminal).toBe(beta * (1 + Math.cos(theta)) > 1);
      }),
    ));

  it('has the velocity and D that differences of pictures a moment apart give, for a moving observer and any motion', () =>
    fc.assert(
      fc.property(fc.constantFrom(...Object.values(THINGS)), direction, speed, uniform(-0.4, 0.4), (thing, n, b, t) => {
        const beta = scale(n, 0.9 * b);
        const u = properVelocity(beta);
        // The observer coasts; dt is a step of his own clock.
        const at = (tau: number) => ({ t: t + gamma(u) * tau, position: scale(u, c * tau), u });
        const line = vertexWorldLine(thing, 3, c);
        const event = emissionEvent(line, at(0), c)!;
        const found = inspectEvent(
          thing,
          { time: event.t, position: event.position, velocity: scale(event.velocity, 1 / c) },
          at(0),
          c,
        )!;
        const h = 1e-4;
        // In his frame, by the boost of the event relative to a fixed origin.
        const apparent = (tau: number): Vec3 => {
          const { offset, delay } = emissionEvent(line, at(tau), c)!;
          const [, x, y, z] = boost([-c * delay, ...offset], u);
          return [x, y, z];
        };
        const seen = apparent(0);
        const rate = scale(sub(apparent(h), apparent(-h)), 1 / (2 * h * c));
        const along = dot(rate, normalize(seen));
        const tolerance = 1e-4 * (1 + length(rate) ** 2);
        expect(Math.abs(found.distanceThen - length(seen))).toBeLessThan(1e-6 * length(seen));
        expect(Math.abs(found.apparentRadialSpeed - along)).toBeLessThan(tolerance);
        expect(Math.abs(found.apparentSpeedAcross - length(addScaled(rate, normalize(seen), -along)))).toBeLessThan(
          tolerance,
        );
        // D: steps of its clock per step of the observer's.
        const v = length(velocityAt(line, event.t, c)) / c;
        const ticks =
          ((emissionEvent(line, at(h), c)!.t - emissionEvent(line, at(-h), c)!.t) / (2 * h)) * Math.sqrt(1 - v * v);
        expect(Math.abs(found.doppler - ticks)).toBeLessThan(1e-4 * (1 + ticks ** 2));
      }),
    ));

  it('is where its uniform motion has taken it at the moment of the observer, in his frame', () => {
    // 16 m away now and receding at 0.6 c; for an observer who flies along it rests, 16 × 1.25 m away.
    const ball = object({ kind: 'uniform', pose: pose([16, 0, 0]), velocity: [6, 0, 0] });
    const event = { time: -1, position: [10, 0, 0], velocity: [0.6, 0, 0] } as const;
    expect(inspectEvent(ball, event, atRest, c)!.distanceNow).toBeCloseTo(16, 9);
    const along = inspectEvent(ball, event, { ...atRest, u: [0.75, 0, 0] }, c)!;
    expect(along.distanceNow).toBeCloseTo(20, 9);
    expect(along.distanceThen).toBeCloseTo(20, 9);
    expect(along.doppler).toBeCloseTo(1, 12);
    expect(length(along.relativeVelocity)).toBeLessThan(1e-12);
    expect(along.rotation).toBeLessThan(1e-9);
  });

  it('is nowhere now if it has died since, and not seen before it was born', () => {
    const ball = (birth: number, death: number) => object(restingAt([10, 0, 0]), { lifetime: { birth, death } });
    const event = { time: -1, position: [10, 0, 0], velocity: ZERO } as const;
    const died = inspectEvent(ball(-5, -0.5), event, atRest, c)!;
    expect(died.distanceThen).toBeCloseTo(10, 9);
    expect(died.distanceNow).toBeUndefined();
    expect(inspectEvent(ball(-0.9, 5), event, atRest, c)).toBeUndefined();
  });

  it('picked in the slice of simultaneity is inspected where it is seen', () => {
    const ball = object({ kind: 'uniform', pose: pose([16, 0, 0]), velocity: [6, 0, 0] });
    const seen = inspectEvent(ball, { time: 0, position: [16, 0, 0], velocity: [0.6, 0, 0] }, atRest, c)!;
    expect(seen.emissionTime).toBeCloseTo(-1, 12);
    expect(seen.distanceThen).toBeCloseTo(10, 12);
  });
});

describe('own clocks', () => {
  const numeric = (line: WorldLine, t: number): number => {
    const n = 20000;
    let sum = 0;
    for (let i = 0; i < n; i++) {
      const v = length(velocityAt(line, (t * (i + 0.5)) / n, c)) / c;
      sum += Math.sqrt(1 - v * v);
    }
    return (sum * t) / n;
  };
  it.each(Object.keys(THINGS))('%s: the sum of √(1 − β²) dt, forwards and backwards', (name) => {
    const line = vertexWorldLine(THINGS[name]!, 5, c);
    for (const t of [-5, -0.7, 1.5, 4]) expect(properTimeBetween(line, 0, t, c)).toBeCloseTo(numeric(line, t), 3);
  });
  it('at constant proper acceleration a to the speed c tanh(aτ/c)', () => {
    const line: WorldLine = { kind: 'hyperbolic', position: ZERO, properAcceleration: [10, 0, 0], t0: 0 };
    const tau = properTimeBetween(line, 0, 3, c);
    expect(velocityAt(line, 3, c)[0]).toBeCloseTo(c * Math.tanh((10 * tau) / c), 9);
  });
});

describe('measured lengths', () => {
  const rod = (beta: Vec3, ends: readonly [Vec3, Vec3]): [WorldLine, WorldLine] =>
    ends.map((position) => ({ kind: 'uniform', position, velocity: scale(beta, c) })) as never;

  it('of a rod: contracted by γ along its motion in the slice, and its own at rest', () =>
    fc.assert(
      fc.property(speed, uniform(0.1, 20), uniform(-30, 30), (beta, own, x) => {
        const seenAs = own * Math.sqrt(1 - beta * beta);
        const [a, b] = rod(
          [beta, 0, 0],
          [
            [x, 5, 2],
            [x + seenAs, 5, 2],
          ],
        );
        const { slice, rest } = measureLengths(a, b, atRest, c)!;
        expect(slice).toBeCloseTo(seenAs, 8);
        expect(rest / own).toBeCloseTo(1, 8);
      }),
    ));

  it('of a rod at rest that a moving observer passes: the other way round', () => {
    const [a, b] = rod(ZERO, [
      [2, 3, 0],
      [7, 3, 0],
    ]);
    const { slice, rest } = measureLengths(a, b, { ...atRest, u: properVelocity([0.8, 0, 0]) }, c)!;
    expect(slice).toBeCloseTo(3, 10);
    expect(rest).toBeCloseTo(5, 10);
  });

  it('of a rod that comes straight at one is seen longer than it is: × √((1 + β)/(1 − β))', () => {
    const contracted = 4;
    const [a, b] = rod(
      [-0.6, 0, 0],
      [
        [20, 0, 0],
        [24, 0, 0],
      ],
    );
    const { apparent, angle, rest } = measureLengths(a, b, atRest, c)!;
    expect(rest).toBeCloseTo(contracted / 0.8, 10);
    expect(apparent).toBeCloseTo(rest * 2, 10);
    expect(angle).toBeLessThan(1e-9);
  });

  it('at rest they agree: the distance, and the angle of the law of cosines', () =>
    fc.assert(
      fc.property(direction, direction, magnitude(-1, 2), magnitude(-1, 2), (m, n, r, s) => {
        const [p, q] = [scale(m, r), scale(n, s)];
        const [a, b] = rod(ZERO, [p, q]);
        const { angle, apparent, slice, rest } = measureLengths(a, b, atRest, c)!;
        const side = distance(p, q);
        for (const found of [apparent, slice, rest]) expect(Math.abs(found - side)).toBeLessThan(1e-9 * (r + s));
        expect(Math.cos(angle)).toBeCloseTo((r * r + s * s - side * side) / (2 * r * s), 9);
      }),
    ));

  it('of a Born-rigid body: the same rest length at any time', () => {
    const thing = THINGS['Born rigid']!;
    const own = rotate(turned, sub(vertex(thing, 0), vertex(thing, 17)));
    for (const t of [-1, 0, 2, 6]) {
      const [a, b] = [0, 17].map((i) => vertexWorldLine(thing, i, c));
      const { rest } = measureLengths(a!, b!, { ...atRest, t, position: [20, 3, 9] }, c)!;
      expect(rest).toBeCloseTo(length(own), 5);
    }
  });
});

const vertex = ({ mesh: { positions } }: SceneObject, i: number): Vec3 => [
  positions[3 * i]!,
  positions[3 * i + 1]!,
  positions[3 * i + 2]!,
];

it('a sphere of many triangles has a point for every place on it', () => {
  const ball = makeObject({ path: '/Ball', mesh: sphere(2), motion: restingAt([0, 0, -9]) });
  expect(surfaceLine(ball, { time: 1, position: [0, 0, -7], velocity: ZERO }, c)).toEqual({
    kind: 'static',
    position: [0, 0, -7],
  });
});
