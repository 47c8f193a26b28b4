import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { tracedScene } from '../../../tests/support/rays.ts';
import { fromAxisAngle, multiply } from '../../math/quat.ts';
import { random } from '../../math/random.ts';
import { add, addScaled, cross, distance, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { makeObject } from '../../scene/defaults.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { sphere } from '../../scene/mesh/primitives.ts';
import { withoutQuadric } from '../../scene/mesh/quadric.ts';
import { sampleTimes, vertexPosition, vertexPositions } from '../../scene/motion/motion.ts';
import type { Mesh, Motion, SceneObject } from '../../scene/types.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';
import { nearestHit } from './tracedScene.ts';

// Every hierarchy finds what a search through all triangles finds, which knows no trees, pieces or cubics: it follows the side of each triangle's
// plane on which the ray is, in small steps, with the places of vertices that the scene tells.

const C = 10;
const END = 30;
/** Steps between two samples. */
const STEPS = 12;
/** Hits within this distance of an edge, in weights, may be missed. */
const EDGE = 1e-6;

/** A body of 168 triangles with dents. */
const body = (seed: number): Mesh => {
  const next = random(seed);
  const mesh = withoutQuadric(sphere(1, { segments: 12, rings: 8 }));
  // Copies of a vertex at a seam stay together.
  const dents = Array.from({ length: 64 }, () => 0.5 + next());
  const dentAt = ([x, y, z]: Vec3): number =>
    dents[Math.abs(Math.round(11 * x) + 5 * Math.round(11 * y) + 3 * Math.round(11 * z)) % 64];
  return { ...mesh, positions: mesh.positions.map((x, i) => x * dentAt(pointAt(mesh.positions, (i / 3) | 0))) };
};

const place = fc.tuple(direction, uniform(0, 4)).map(([n, r]) => scale(n, r));
const turn = fc.tuple(direction, uniform(-3, 3)).map(([axis, angle]) => fromAxisAngle(axis, angle));
const pose = fc.record({ position: place, orientation: turn });
const times = Float64Array.from({ length: 6 }, (_, k) => -2 + 0.7 * k);

const rigid = (most: number): fc.Arbitrary<Motion> =>
  fc
    .tuple(
      pose,
      fc.array(fc.tuple(direction, uniform(0, 3), direction, uniform(0, most)), { minLength: 6, maxLength: 6 }),
    )
    .map(([start, steps]) => {
      let { position, orientation } = start;
      const poses = steps.flatMap(([toward, far, axis, angle]) => {
        position = addScaled(position, toward, far);
        orientation = multiply(fromAxisAngle(axis, angle), orientation);
        return [...position, ...orientation];
      });
      return { kind: 'sampled', times, poses: Float64Array.from(poses) };
    });

const deforming = (mesh: Mesh, most: number): fc.Arbitrary<Motion> =>
  fc.tuple(place, fc.integer(), uniform(0, most), place).map(([origin, seed, wild, drift]) => {
    const next = random(seed);
    const points = Array.from(times, (_, k) =>
      mesh.positions.map((x, i) => x + (k * drift[i % 3]) / 4 + wild * (next() - 0.5)),
    );
    return { kind: 'sampled-points', times, origin, points };
  });

const motions: Record<string, (mesh: Mesh) => fc.Arbitrary<Motion>> = {
  static: () => pose.map((at) => ({ kind: 'static', pose: at })),
  uniform: () =>
    fc
      .tuple(pose, direction, uniform(0, 0.9 * C))
      .map(([at, n, v]) => ({ kind: 'uniform', pose: at, velocity: scale(n, v) })),
  rigid: () => rigid(0.5),
  'rigid, tumbling by up to half a turn from sample to sample': () => rigid(3.1),
  deforming: (mesh) => deforming(mesh, 0.2),
  'deforming wildly': (mesh) => deforming(mesh, 2),
};

/** Rays of light, in a slice of simultaneity, and into the future, which pass close to a vertex where that is at some time. */
const aim = fc.record({
  part: fc.tuple(uniform(0, 0.999), uniform(0, 0.999)),
  time: uniform(-2.5, 2),
  toward: direction,
  far: uniform(0.5, 15),
  beside: fc.tuple(direction, uniform(0, 0.3)),
  slope: fc.constantFrom(-1, 0, -0.4, 1),
});

function rayAt(
  objects: readonly SceneObject[],
  { part, time, toward, far, beside, slope }: typeof aim extends fc.Arbitrary<infer A> ? A : never,
): SpacetimeRay {
  const object = objects[Math.floor(part[0] * objects.length)];
  const vertex = object.mesh.indices[Math.floor(part[1] * object.mesh.indices.length)];
  const target = addScaled(vertexPosition(object, vertex, time, C), beside[0], beside[1]);
  return { t: time - (far * slope) / C, x: addScaled(target, toward, -far), dt: slope, dx: toward };
}

interface Meeting {
  readonly s: number;
  readonly object: number;
  readonly corner: number;
  /** The least of the three weights. */
  readonly inside: number;
}

type Triangle = readonly [Vec3, Vec3, Vec3];

const triangleOf = (points: Float64Array, { mesh: { indices } }: SceneObject, corner: number): Triangle => [
  pointAt(points, indices[corner]),
  pointAt(points, indices[corner + 1]),
  pointAt(points, indices[corner + 2]),
];

function meetings(object: SceneObject, index: number, { t, x, dt, dx }: SpacetimeRay): Meeting[] {
  const { indices } = object.mesh;
  const timeAt = (s: number): number => t + (s * dt) / C;
  const at = (s: number): Vec3 => addScaled(x, dx, s);
  const triangleAt = (corner: number, s: number): Triangle => {
    const [p, q, r] = [0, 1, 2].map((k) => vertexPosition(object, indices[corner + k], timeAt(s), C));
    return [p, q, r];
  };
  const side = ([p, q, r]: Triangle, s: number): number => dot(cross(sub(q, p), sub(r, p)), sub(at(s), p));
  const ends = Array.from(sampleTimes(object.motion) ?? [], (time) => ((time - t) * C) / dt).filter(
    (s) => s > 0 && s < END,
  );
  const knots = [0, ...ends.sort((a, b) => a - b), END];
  const grid = knots.slice(1).flatMap((to, k) => {
    const from = knots[k];
    return Array.from({ length: STEPS }, (_, j) => from + ((j + (k > 0 ? 1 : 0)) * (to - from)) / STEPS);
  });
  grid.push(END);
  grid.sort((a, b) => a - b);
  const places = grid.map((s) => vertexPositions(object, timeAt(s), C));
  const sideAt = (k: number, corner: number): number => side(triangleOf(places[k], object, corner), grid[k]);
  const found: Meeting[] = [];
  for (let corner = 0; corner < indices.length; corner += 3)
    for (let k = 0; k + 1 < grid.length; k++) {
      const before = sideAt(k, corner);
      if (before < 0 === sideAt(k + 1, corner) < 0) continue;
      let [lo, hi] = [grid[k], grid[k + 1]];
      for (let i = 0; i < 48; i++) {
        const middle = (lo + hi) / 2;
        if (side(triangleAt(corner, middle), middle) < 0 === before < 0) lo = middle;
        else hi = middle;
      }
      const inside = leastWeight(triangleAt(corner, lo), at(lo));
      if (inside > -EDGE) found.push({ s: lo, object: index, corner, inside });
    }
  return found;
}

/** The least of the weights of the corners with which they give a point of their plane. */
function leastWeight([p, q, r]: Triangle, x: Vec3): number {
  const N = cross(sub(q, p), sub(r, p));
  const weight = (a: Vec3, b: Vec3): number => dot(N, cross(sub(a, x), sub(b, x))) / dot(N, N);
  return Math.min(weight(q, r), weight(r, p), weight(p, q));
}

/** Distance of a hit from where its triangle's vertices are at its time [m]. */
function missOf(object: SceneObject, time: number, corner: number, v: number, w: number, position: Vec3): number {
  const [p, q, r] = triangleOf(vertexPositions(object, time, C), object, corner);
  return distance(position, add(add(scale(p, 1 - v - w), scale(q, v)), scale(r, w)));
}

describe('a ray meets what a search through all triangles finds', () => {
  for (const [name, motionOf] of Object.entries(motions))
    it(name, () =>
      fc.assert(
        fc.property(
          fc
            .integer()
            .map(body)
            .chain((mesh) =>
              fc.array(
                motionOf(mesh).map((motion) => makeObject({ path: '/It', mesh, motion })),
                { minLength: 1, maxLength: 3 },
              ),
            ),
          fc.array(aim, { minLength: 1, maxLength: 4 }),
          (objects, aims) => {
            const scene = tracedScene(objects, C);
            for (const one of aims.map((given) => rayAt(objects, given))) {
              const all = objects.flatMap((object, i) => meetings(object, i, one));
              const first = Math.min(END, ...all.filter(({ inside }) => inside > EDGE).map(({ s }) => s));
              const hit = nearestHit(scene, one, { end: END });
              const found = hit?.s ?? END;
              expect(found, 'nothing nearer is missed').toBeLessThan(first + 1e-9);
              expect(nearestHit(scene, one, { end: END, any: true }) !== undefined, 'any hit').toBe(hit !== undefined);
              if (!hit) continue;
              const { object, corner, v, w, time, position } = hit;
              expect(missOf(objects[object], time, corner, v, w, position), 'it is there').toBeLessThan(1e-9);
              expect(Math.min(v, w, 1 - v - w)).toBeGreaterThan(-1e-12);
              const there = all.filter(({ s }) => Math.abs(s - found) < 1e-8);
              if (there.some(({ inside }) => inside > EDGE))
                expect(there.some((meeting) => meeting.object === object && meeting.corner === corner)).toBe(true);
            }
          },
        ),
        { numRuns: 15, endOnFailure: true },
      ),
    );
});

describe('of surfaces at the same place', () => {
  const mesh = body(1);
  const twice = { ...mesh, indices: Uint32Array.from([...mesh.indices, ...mesh.indices]) };
  const straight: SpacetimeRay = { t: 0, x: [0.1, 0.2, 9], dt: -1, dx: [0, 0, -1] };
  const still: Motion = { kind: 'static', pose: { position: [0, 0, 0], orientation: [0, 0, 0, 1] } };
  const kinds: Record<string, Motion> = {
    static: still,
    rigid: {
      kind: 'sampled',
      times,
      poses: Float64Array.from([...times].flatMap((t) => [t / 9, 0, 0, ...fromAxisAngle([0, 1, 0], t / 9)])),
    },
    deforming: {
      kind: 'sampled-points',
      times,
      origin: [0, 0, 0],
      points: Array.from(times, (t) => mesh.positions.map((x) => x * (1 + t / 30))),
    },
  };
  for (const [name, motion] of Object.entries(kinds))
    it(`a ray meets that which the scene lists last: ${name}`, () => {
      const object = makeObject({ path: '/It', mesh: twice, motion });
      const hit = nearestHit(tracedScene([object, object, object], C), straight);
      expect(hit?.object).toBe(2);
      expect(hit?.corner).toBeGreaterThanOrEqual(mesh.indices.length);
      expect(length(hit?.position ?? [0, 0, 0])).toBeGreaterThan(0.4);
    });
});
