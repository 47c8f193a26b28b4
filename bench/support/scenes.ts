import type { Quat } from '../../src/math/quat.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { makeObject, makeScene } from '../../src/scene/defaults.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import { parabolaVelocities } from '../../src/scene/motion/cubicPoints.ts';
import type { Mesh, Motion, Scene } from '../../src/scene/types.ts';
import { lookAtOrientation } from '../../src/scene/view/camera.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';

export type MotionKind = 'static' | 'rigid' | 'deforming' | 'cubic';

/** Speed of light of all benchmarks [m/s]; spheres and ripples move at up to half of it. */
export const C = 10;
export const SAMPLES = 250;
/** Length of the sampled motion [s]. */
const SPAN = 10;
const BALLS = 8;

/** Eight spheres with about the given number of triangles in total, for a view from the origin along −Z. */
export function sphereScene(triangles: number, kind: MotionKind, samples = SAMPLES): Scene {
  const mesh = sphereMesh(triangles / BALLS);
  const objects = Array.from({ length: BALLS }, (_, i) => {
    const place: Vec3 = [3 * ((i % 4) - 1.5), 3 * ((i >> 2) - 0.5), -9];
    return makeObject({ path: `/Ball${i}`, mesh, motion: motionOf(kind, mesh, place, samples) });
  });
  return makeScene({ name: `${kind} ${triangles}`, objects, hints: { speedOfLight: C }, endTime: SPAN });
}

/** A sphere of s segments and s/2 rings has s² − 2 s triangles. */
function sphereMesh(triangles: number): Mesh {
  const segments = 2 * Math.round((1 + Math.sqrt(1 + triangles)) / 2);
  return sphere(1.2, { segments });
}

function motionOf(kind: MotionKind, mesh: Mesh, place: Vec3, samples: number): Motion {
  const times = Float64Array.from({ length: samples }, (_, k) => (SPAN * k) / (samples - 1));
  if (kind === 'static') return { kind, pose: { position: place, orientation: [0, 0, 0, 1] } };
  if (kind === 'rigid') return { kind: 'sampled', times, poses: circlingPoses(times, place) };
  const shapes = rippledShapes(mesh, Math.min(samples, 10));
  const inTurn = (of: readonly Float32Array[]) => Array.from(times, (_, k) => of[k % of.length]);
  const points = inTurn(shapes);
  if (kind === 'deforming') return { kind: 'sampled-points', times, origin: place, points };
  // Of the second revolution, if there is one, which has neighbours on both sides.
  const turn = shapes.length;
  const velocities = parabolaVelocities(times.subarray(0, 3 * turn), points.slice(0, 3 * turn)).slice(turn, 2 * turn);
  return { kind: 'sampled-points', times, origin: place, points, velocities: inTurn(velocities) };
}

/** Around a circle of 0.8 m at c/2, rotating along. */
function circlingPoses(times: Float64Array, center: Vec3): Float64Array {
  const poses = new Float64Array(7 * times.length);
  times.forEach((t, k) => {
    const a = (C * t) / 2 / 0.8;
    const turn: Quat = [0, Math.sin(t / 8), 0, Math.cos(t / 8)];
    poses.set([center[0] + 0.8 * Math.cos(a), center[1] + 0.8 * Math.sin(a), center[2], ...turn], 7 * k);
  });
  return poses;
}

/** Ten shapes that repeat: each sample costs as much as a distinct one, but memory suffices. */
function rippledShapes({ positions }: Mesh, count: number): Float32Array[] {
  return Array.from({ length: count }, (_, k) => {
    const swell = 1 + 0.02 * Math.sin((2 * Math.PI * k) / count);
    return positions.map((x) => x * swell);
  });
}

/** The observer of all frame benchmarks: half-way through the motion, moving forward at 0.5 c. */
export const VIEW = {
  t: SPAN / 2 + 1,
  position: [0, 0, 0] as Vec3,
  u: [0, 0, -Math.tan(Math.PI / 6)] as Vec3,
  orientation: lookAtOrientation([0, 0, -1], [0, 1, 0]),
  lens: perspective(Math.PI / 2),
};
