import { fromAxisAngle, IDENTITY } from '../../src/math/quat.ts';
import { normalize, type Vec3 } from '../../src/math/vec3.ts';
import { makeObject, makeScene, restingAt } from '../../src/scene/defaults.ts';
import { box, sphere } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, Motion, Scene } from '../../src/scene/types.ts';

/** Slow light and a late time, so that world times and positions are large: they must never be stored in f32. */
export const C = 10;
export const T = 1e4;
export const OBSERVER_POSITION: Vec3 = [200, 12, -70];
/** Approximate position of objects when seen. */
const SUBJECT_POSITION: Vec3 = [OBSERVER_POSITION[0] + 0.4, OBSERVER_POSITION[1] + 0.2, OBSERVER_POSITION[2] - 9];

const pose = (position: Vec3) => ({ position, orientation: fromAxisAngle([1, 2, 3], 0.7) });
const off = (a: Vec3, x: number, y: number, z: number): Vec3 => [a[0] + x, a[1] + y, a[2] + z];
/** Position at t = 0 of an object that is at `at` at the time t. */
const back = (at: Vec3, v: Vec3, t: number): Vec3 => [at[0] - v[0] * t, at[1] - v[1] * t, at[2] - v[2] * t];

function uniform(velocity: Vec3): Motion {
  return { kind: 'uniform', velocity, pose: pose(back(SUBJECT_POSITION, velocity, T - 0.9)) };
}
function hyperbolic(properAcceleration: Vec3): Motion {
  return { kind: 'hyperbolic', pose: pose(SUBJECT_POSITION), properAcceleration, t0: T - 2 };
}

/** A curve through `SUBJECT_POSITION` with a rotation about a slanted axis: 250 samples, the last 4 s after the observer's time. */
function sampled(): Motion {
  const count = 250;
  const times = Float64Array.from({ length: count }, (_, k) => T - 8 + (12 * k) / (count - 1));
  const axis = normalize([0.36, 0.48, 0.8]);
  const poses = new Float64Array(7 * count);
  times.forEach((t, k) => {
    const s = t - T;
    const place = off(SUBJECT_POSITION, 2.5 * Math.sin(2 * s), Math.cos(1.7 * s), 0.8 * s);
    poses.set([...place, ...fromAxisAngle(axis, 1.5 * s)], 7 * k);
  });
  return { kind: 'sampled', times, poses };
}

function wobbling(mesh: Mesh): Motion {
  const count = 60;
  const times = Float64Array.from({ length: count }, (_, k) => T - 5 + (6 * k) / (count - 1));
  const points = Array.from(times, (t) => {
    const s = t - T;
    const out = new Float32Array(mesh.positions.length);
    for (let i = 0; i < out.length; i += 3) {
      const [x, y, z] = mesh.positions.subarray(i, i + 3);
      const swell = 1 + 0.3 * Math.sin(3 * s + 2 * y);
      out.set([x * swell + 1.5 * Math.sin(1.5 * s), y + 0.4 * Math.sin(2 * s + x), z * swell], i);
    }
    return out;
  });
  return { kind: 'sampled-points', times, origin: SUBJECT_POSITION, points };
}

const ball = sphere(1.5, { segments: 48, rings: 24 });
const backdrop = makeObject({
  path: '/wall',
  mesh: box([14, 9, 1]),
  motion: restingAt(off(SUBJECT_POSITION, 0, 0, -6)),
});
const scene = (name: string, ...objects: Scene['objects'][number][]): Scene =>
  makeScene({ name: `late: ${name}`, objects: [...objects, backdrop], hints: { speedOfLight: C } });

/** One per kind of motion; the tested object is the first. */
export const LATE_SCENES: readonly Scene[] = [
  scene('static', makeObject({ path: '/ball', mesh: ball, motion: { kind: 'static', pose: pose(SUBJECT_POSITION) } })),
  scene('uniform', makeObject({ path: '/ball', mesh: ball, motion: uniform([7, 1, 3]) })),
  scene('uniform at rest', makeObject({ path: '/ball', mesh: ball, motion: uniform([-6, 2, 5]), authoredIn: 'rest' })),
  scene('hyperbolic', makeObject({ path: '/ball', mesh: ball, motion: hyperbolic([6, 0, 2]) })),
  scene('born rigid', makeObject({ path: '/ball', mesh: ball, motion: hyperbolic([-5, 3, 0]), authoredIn: 'rest' })),
  scene('sampled', makeObject({ path: '/ball', mesh: ball, motion: sampled() })),
  scene('sampled points', makeObject({ path: '/ball', mesh: ball, motion: wobbling(ball) })),
  scene(
    'lifetimes',
    makeObject({
      path: '/ball',
      mesh: ball,
      motion: uniform([7, 1, 3]),
      lifetime: { birth: T - 50, death: T - 0.92 },
    }),
    makeObject({
      path: '/late',
      mesh: box([1, 1, 1]),
      motion: { kind: 'static', pose: { position: off(SUBJECT_POSITION, 3, 1, 2), orientation: IDENTITY } },
      lifetime: { birth: T - 0.7, death: T + 9 },
    }),
  ),
];
