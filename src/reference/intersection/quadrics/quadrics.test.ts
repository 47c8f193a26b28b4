import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, expectClose, uniform } from '../../../../tests/support/physicsArbitraries.ts';
import { cornerAt, settingsFor, tracedScene, viewFrom } from '../../../../tests/support/rays.ts';
import { determinant, type Mat3 } from '../../../math/mat3.ts';
import { fromParts, invert, linearPart, transformPoint } from '../../../math/mat4.ts';
import { fromAxisAngle, rotate, toMatrix } from '../../../math/quat.ts';
import { add, addScaled, dot, length, normalize, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { boost, properVelocity } from '../../../physics/lorentz/boost.ts';
import { fourVector, spatial } from '../../../physics/lorentz/fourVector.ts';
import { makeObject } from '../../../scene/defaults.ts';
import { transformMesh } from '../../../scene/mesh/meshOps.ts';
import { capsule, cone, cylinder, sphere } from '../../../scene/mesh/primitives.ts';
import { withoutQuadric } from '../../../scene/mesh/quadric.ts';
import type { Mesh, Motion, QuadricShape, SceneObject } from '../../../scene/types.ts';
import type { Hit } from '../../acceleration/ray.ts';
import { rayToward } from '../../camera/lensRay.ts';
import { surfaceAt } from '../../materials/surface.ts';
import { nearestHit, type TracedScene } from '../tracedScene.ts';

// c = 1 throughout; the observer is at the origin at t = 0.

const LIGHT = settingsFor('light-cone');
const rayOf = (n: Vec3) => rayToward(viewFrom(), LIGHT, normalize(n));
const seen = (scene: TracedScene, n: Vec3): Hit | undefined => nearestHit(scene, rayOf(n));

const SOLIDS: { readonly [K in QuadricShape['kind']]: (segments?: number) => Mesh } = {
  sphere: (segments = 64) => sphere(0.8, { segments, axis: 'Y' }),
  cylinder: (segments = 64) => cylinder(0.6, 1.5, { segments, axis: 'X' }),
  cone: (segments = 64) => cone(0.7, 1.4, { segments }),
  capsule: (segments = 64) => capsule(0.4, 0.9, { segments, axis: 'Y' }),
};
const KINDS = Object.keys(SOLIDS) as QuadricShape['kind'][];

/** How far a point is outside of a solid, written as in USD's documentation of its sizes [own units]. */
function outside(shape: QuadricShape, [x, y, z]: Vec3): number {
  const radial = Math.hypot(x, y);
  switch (shape.kind) {
    case 'sphere':
      return Math.hypot(radial, z) - shape.radius;
    case 'cylinder':
      return Math.max(radial - shape.radius, Math.abs(z) - shape.height / 2);
    case 'cone': {
      const slope = Math.atan2(shape.radius, shape.height);
      return Math.max(radial * Math.cos(slope) - (shape.height / 2 - z) * Math.sin(slope), -z - shape.height / 2);
    }
    case 'capsule':
      return Math.hypot(radial, Math.max(0, Math.abs(z) - shape.height / 2)) - shape.radius;
  }
}

const gammaOf = (beta: number): number => 1 / Math.sqrt(1 - beta * beta);

/** Between keyframes [s]. */
const STEP = 0.8;

/** Keyframes of a turn about `axis` while moving. */
function turning(axis: Vec3, rate: number, velocity: Vec3, from: Vec3): Motion {
  const times = Float64Array.from({ length: 12 }, (_, k) => STEP * (k - 11));
  const poses = Float64Array.from(
    [...times].flatMap((t) => [...addScaled(from, velocity, t), ...fromAxisAngle(normalize(axis), rate * t)]),
  );
  return { kind: 'sampled', times, poses };
}

const pose = (position: Vec3, angle = 0.7) => ({ position, orientation: fromAxisAngle(normalize([1, 2, -1]), angle) });
const FROM: Vec3 = [-1, 0.3, -5];
const MOTIONS: { readonly [name: string]: Pick<SceneObject, 'motion' | 'authoredIn'> } = {
  resting: { motion: { kind: 'static', pose: pose(FROM) }, authoredIn: 'world' },
  'flying at 0.9 c': {
    motion: { kind: 'uniform', pose: pose([3.5, 0.3, -5]), velocity: [0.9, 0, 0] },
    authoredIn: 'rest',
  },
  'flying as written in the world': {
    motion: { kind: 'uniform', pose: pose([3.5, 0.3, -5]), velocity: [0.9, 0, 0] },
    authoredIn: 'world',
  },
  'accelerating, Born-rigid': {
    motion: { kind: 'hyperbolic', pose: pose([0, 0, -5]), t0: -5.2, properAcceleration: [0.3, 0, 0.1] },
    authoredIn: 'rest',
  },
  'accelerating, as written in the world': {
    motion: { kind: 'hyperbolic', pose: pose([0, 0, -5]), t0: -5.2, properAcceleration: [0.5, 0, 0.1] },
    authoredIn: 'world',
  },
  turning: { motion: turning([1, 3, 1], 0.5, [0.5, 0, 0.1], [2, 0.3, -5]), authoredIn: 'world' },
  'turning, authored at rest': { motion: turning([1, 3, 1], 0.3, [0.5, 0, 0.1], [2, 0.3, -5]), authoredIn: 'rest' },
};

const objectOf = (mesh: Mesh, how: keyof typeof MOTIONS): SceneObject =>
  makeObject({ path: '/Solid', mesh, ...MOTIONS[how] });

/** Directions around where the solid is seen. */
const RAYS = Array.from({ length: 600 }, (_, i): Vec3 => [((i % 30) - 15) / 26, (Math.floor(i / 30) - 9.3) / 30, -1]);

describe('a passing sphere', () => {
  for (const beta of [0, 0.5, 0.9, 0.99])
    it(`has a circle for an outline, to rounding: β = ${beta}`, () => {
      const [center, g]: [Vec3, number] = [[-2, 0, -5], gammaOf(beta)];
      const scene = tracedScene([
        makeObject({
          path: '/Ball',
          mesh: sphere(1),
          authoredIn: 'rest',
          motion: { kind: 'uniform', pose: pose(center), velocity: [beta, 0, 0] },
        }),
      ]);
      // In its rest frame it is a cone of half angle asin(1/d); aberration keeps circles and changes angles from x by tan(θ/2) → k tan(θ/2).
      const resting: Vec3 = [g * center[0], 0, center[2]];
      const middle = Math.atan2(-resting[2], resting[0]);
      const open = Math.asin(1 / length(resting));
      const k = Math.sqrt((1 + beta) / (1 - beta));
      const [from, to] = [middle - open, middle + open].map((theta) => 2 * Math.atan(k * Math.tan(theta / 2)));
      const [axis, half] = [(from + to) / 2, (to - from) / 2];
      const toward = (angle: number, around: number): Vec3 => {
        const aside: Vec3 = [Math.sin(axis), 0, Math.cos(axis)];
        const out = addScaled(scale(aside, Math.cos(around)), [0, 1, 0], Math.sin(around));
        return addScaled(scale([Math.cos(axis), 0, -Math.sin(axis)], Math.cos(angle)), out, Math.sin(angle));
      };
      for (let i = 0; i < 60; i++) {
        expect(seen(scene, toward(half * (1 - 1e-9), i)), `inside, ${i}`).toBeDefined();
        expect(seen(scene, toward(half * (1 + 1e-9), i)), `outside, ${i}`).toBeUndefined();
      }
    });
});

describe('hits', () => {
  const stretch = fc.tuple(uniform(0.3, 2), uniform(0.3, 2), uniform(-2, -0.3), uniform(-0.4, 0.4));
  const speeds = fc.tuple(direction, uniform(0, 0.95)).map(([n, beta]) => scale(n, beta));
  it.each(KINDS)('of a %s are on it, on the past light cone, whatever its stretch and velocity', (kind) => {
    let found = 0;
    fc.assert(
      fc.property(stretch, speeds, uniform(0, 6), uniform(-0.1, 0.1), uniform(-0.1, 0.1), (s, v, angle, x, y) => {
        const [a, b, c, shear] = s;
        const m = fromParts([a, shear, 0, 0, b, shear, 0, 0, c], [0.1, -0.2, 0.05]);
        const mesh = transformMesh(SOLIDS[kind](), m);
        const at = pose(add([0, 0, -5], scale(v, 5)), angle);
        const object = makeObject({
          path: '/Solid',
          mesh,
          authoredIn: 'rest',
          motion: { kind: 'uniform', pose: at, velocity: v },
        });
        const scene = tracedScene([object]);
        const fronts: boolean[] = [];
        nearestHit(scene, rayOf([x, y, -1]), {
          accepts: (hit) => {
            fronts.push(hit.front);
            found++;
            expectClose(hit.time, -length(hit.position), 1e-12);
            // The event in the solid's rest frame.
            const own = spatial(boost(fourVector(hit.time, sub(hit.position, at.position)), properVelocity(v)));
            const turned = rotate(fromAxisAngle(normalize([1, 2, -1]), -angle), own);
            const { shape, toMesh } = mesh.quadric!;
            expect(Math.abs(outside(shape, transformPoint(invert(toMesh)!, turned)))).toBeLessThan(1e-9);
            // The triangle that it is on is that of the polygons: within the sagitta of their arcs.
            const weights = [1 - hit.v - hit.w, hit.v, hit.w];
            const near = weights.reduce<Vec3>((p, w, k) => addScaled(p, cornerAt(object, hit.corner, k), w), [0, 0, 0]);
            expect(Math.min(...weights)).toBeGreaterThan(-1e-9);
            expect(length(sub(near, turned))).toBeLessThan(0.012);
            // Its normal is within an arc of the triangle's vertex normals.
            const flat = rotate(fromAxisAngle(normalize([1, 2, -1]), -angle), hit.normal);
            const i = 3 * mesh.indices[hit.corner];
            const vertex: Vec3 = [mesh.normals[i], mesh.normals[i + 1], mesh.normals[i + 2]];
            expect(dot(flat, vertex)).toBeGreaterThan(0.9);
            return false;
          },
        });
        // It enters and leaves, or leaves alone where the observer is inside.
        expect([0, 1, 2]).toContain(fronts.length);
        expect(fronts.filter((front) => !front).length).toBe(fronts.length > 0 ? 1 : 0);
      }),
      { numRuns: 150 },
    );
    expect(found).toBeGreaterThan(100);
  });

  it('of a mirrored solid count as those of its outside', () => {
    const mesh = transformMesh(SOLIDS.cone(), fromParts([-1, 0, 0, 0, 1, 0, 0, 0, 1], [0, 0, -5]));
    expect(determinant(linearPart(mesh.quadric!.toMesh))).toBeLessThan(0);
    const hit = seen(tracedScene([makeObject({ path: '/Cone', mesh })]), [0.02, 0.01, -1]);
    expect(hit?.front).toBe(true);
    expect(hit?.normal[2]).toBeGreaterThan(0);
  });
});

describe('very fine polygons', () => {
  for (const how of Object.keys(MOTIONS))
    it.each(KINDS)(`become the %s: ${how}`, (kind) => {
      const fine = withoutQuadric(SOLIDS[kind](192));
      const [solid, polygons] = [SOLIDS[kind](), fine].map((mesh) => tracedScene([objectOf(mesh, how)]));
      let [both, one] = [0, 0];
      for (const n of RAYS) {
        const [a, b] = [seen(solid, n), seen(polygons, n)];
        if (!a || !b) {
          if (a || b) one++;
          continue;
        }
        both++;
        const cos = Math.abs(dot(a.normal, b.normal));
        if (cos < 0.99 || Math.abs(dot(normalize(a.position), b.normal)) < 0.3) continue;
        expect(Math.abs(a.s - b.s)).toBeLessThan(2e-3);
        expect(length(sub(a.velocity, b.velocity))).toBeLessThan(2e-3);
        const [p, q] = [surfaceAt(solid, a), surfaceAt(polygons, b)];
        expect(length(sub(p.normal, q.normal))).toBeLessThan(0.04);
        // u has a seam, and at poles it is that of a triangle's middle.
        const du = Math.abs(p.uv[0] - q.uv[0]);
        expect(Math.min(du, 1 - du)).toBeLessThan(1 / 64);
        expect(Math.abs(p.uv[1] - q.uv[1])).toBeLessThan(2e-3);
      }
      expect(both).toBeGreaterThan(25);
      expect(one).toBeLessThan(4);
    });
});

describe('a turning cylinder', () => {
  it('is met where a search in small steps meets it', () => {
    const mesh = SOLIDS.cylinder();
    const object = objectOf(mesh, 'turning');
    const scene = tracedScene([object]);
    const { shape, toMesh } = mesh.quadric!;
    if (object.motion.kind !== 'sampled') throw new Error('it is sampled');
    const { times, poses } = object.motion;
    /** The event x at t in the cylinder's axes, by Cramer's rule with the points of the two frames mixed. */
    const outsideAt = (t: number, x: Vec3): number => {
      const k = Math.floor((t - times[0]) / STEP);
      const f = (t - times[k]) / (times[k + 1] - times[k]);
      const frame = (i: number): { p: Vec3; m: Mat3 } => ({
        p: [poses[7 * i], poses[7 * i + 1], poses[7 * i + 2]],
        m: toMatrix([poses[7 * i + 3], poses[7 * i + 4], poses[7 * i + 5], poses[7 * i + 6]]),
      });
      const [a, b] = [frame(k), frame(k + 1)];
      const m = a.m.map((e, i) => e + f * (b.m[i] - e));
      const r = sub(x, add(scale(a.p, 1 - f), scale(b.p, f)));
      const y = [0, 1, 2].map(
        (j) => determinant(m.map((e, i) => (i % 3 === j ? r[Math.floor(i / 3)] : e))) / determinant(m),
      );
      return outside(shape, transformPoint(invert(toMesh)!, y as unknown as Vec3));
    };
    let met = 0;
    for (const n of RAYS.filter((_, i) => i % 4 === 0)) {
      const unit = normalize(n);
      const at = (s: number): number => outsideAt(-s, scale(unit, s));
      let step = 3;
      while (step < 8 && at(step) > 0) step += 5e-3;
      const hit = seen(scene, n);
      if (step >= 8) {
        // A grazing ray may be inside for less than a step.
        if (hit) expect(at(hit.s + 2.5e-3)).toBeGreaterThan(-5e-3);
        continue;
      }
      let [lo, hi] = [step - 5e-3, step];
      for (let i = 0; i < 60; i++) [lo, hi] = at((lo + hi) / 2) > 0 ? [(lo + hi) / 2, hi] : [lo, (lo + hi) / 2];
      met++;
      expectClose(hit?.s ?? 0, hi, 1e-9);
    }
    expect(met).toBeGreaterThan(12);
  });
});
