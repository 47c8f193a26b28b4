import { expect, it } from 'vitest';
import { fromPose, type Mat4, transformPoint } from '../../math/mat4.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { random as seeded } from '../../math/random.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { BlendBudget } from './blendBudget.ts';
import { blendedPlaces, jointOutline, type OutlinedMesh } from './jointOutline.ts';

const random = seeded(7);
const size = (most: number): number => most * (2 * random() - 1);
const vector = (most: number): Vec3 => [size(most), size(most), size(most)];
const VERTICES = 400;
const JOINTS = 3;
/** The only vertex that the blend shape moves. */
const LONE = 137;

const binds: Mat4[] = Array.from({ length: JOINTS }, () =>
  fromPose({ position: vector(1), orientation: fromAxisAngle(vector(1), size(2)) }),
);
const turns = Array.from({ length: JOINTS }, () => ({ axis: vector(1), by: size(3), to: vector(2) }));
const framesAt = (t: number): Float64Array =>
  Float64Array.from([
    ...turns.flatMap(({ axis, by, to }) =>
      fromPose({ position: to.map((x) => x * t * t) as never, orientation: fromAxisAngle(axis, by * t) }).slice(0, 12),
    ),
    ...new Array<number>(12).fill(0),
  ]);
const plain: OutlinedMesh = {
  positions: Float32Array.from({ length: 3 * VERTICES }, () => size(1)),
  skin: {
    perPoint: 2,
    joints: Uint16Array.from({ length: 2 * VERTICES }, () => Math.floor(JOINTS * random())),
    weights: Float32Array.from({ length: VERTICES }, random).reduce(
      (all, w, v) => {
        all.set([w, 1 - w], 2 * v);
        return all;
      },
      new Float32Array(2 * VERTICES),
    ),
  },
  binds,
  shapes: [],
  weightsAt: () => [],
};
const shaped: OutlinedMesh = {
  ...plain,
  shapes: [{ positions: Float32Array.from({ length: 3 * VERTICES }, (_, i) => (Math.floor(i / 3) === LONE ? 2 : 0)) }],
  weightsAt: (t) => [t * t],
};

/** The greatest distance from the chord between two times, in their middle. */
function chordDistance(path: (t: number) => Float64Array, from: number, to: number): number {
  const [a, b, middle] = [from, to, (from + to) / 2].map((t) => path(t).slice());
  let most = 0;
  for (let i = 0; i < a.length; i += 3)
    most = Math.max(most, Math.hypot(...[0, 1, 2].map((k) => middle[i + k] - (a[i + k] + b[i + k]) / 2)));
  return most;
}

it('places are Σ w M B (p + Σ b δ)', () => {
  const [t, { skin, positions }] = [0.4, shaped];
  const places = blendedPlaces(shaped, framesAt(t), t);
  for (const v of [0, LONE, VERTICES - 1]) {
    const p = [0, 1, 2].map((k) => positions[3 * v + k] + (v === LONE ? 2 * t * t : 0)) as unknown as Vec3;
    const wanted = [0, 0, 0];
    for (const i of [2 * v, 2 * v + 1]) {
      const joint = skin!.joints[i];
      const frame = [...framesAt(t).subarray(12 * joint, 12 * joint + 12), 0, 0, 0, 1];
      transformPoint(frame, transformPoint(binds[joint], p)).forEach((x, k) => {
        wanted[k] += skin!.weights[i] * x;
      });
    }
    expect([...places.subarray(3 * v, 3 * v + 3)]).toEqual(wanted.map((x) => expect.closeTo(x, 10)));
    expect([...blendedPlaces(shaped, framesAt(t), t, [v])]).toEqual([...places.subarray(3 * v, 3 * v + 3)]);
  }
});

it('no vertex is farther from its chord than the outline', () => {
  const [outline, all] = [jointOutline([plain], framesAt), (t: number) => blendedPlaces(plain, framesAt(t), t)];
  for (const [from, to] of [
    [0, 1],
    [0.2, 0.4],
    [0.7, 0.75],
  ]) {
    const [bound, most] = [chordDistance(outline, from, to), chordDistance(all, from, to)];
    expect(most).toBeGreaterThan(0.3 * bound);
    expect(most).toBeLessThanOrEqual(bound);
  }
});

it('the outline has the vertex that a blend shape moves most', () => {
  const places = [...jointOutline([shaped], framesAt)(0.6)];
  const [lone] = blendedPlaces(shaped, framesAt(0.6), 0.6, [LONE]);
  expect(places).toContain(lone);
  expect([...jointOutline([plain], framesAt)(0.6)]).not.toContain(lone);
});

it('memory is shared evenly, and what one does not need goes to the others', () => {
  const nodeBytes = 8 * 12 * (JOINTS + 1);
  const budget = new BlendBudget(3, 90 * nodeBytes);
  const bending = { meshes: [plain], knots: [0, 1], cost: 1, tolerance: 1e-6, framesAt };
  const resting = { ...bending, framesAt: () => framesAt(0) };
  expect(budget.follow(resting)).toMatchObject({ error: 0, isFollowed: true, isCoarse: false });
  for (const each of [budget.follow(bending), budget.follow(bending)]) {
    expect(each.isCoarse).toBe(true);
    expect(each.times.length).toBe(44);
    expect([each.times[0], each.times.at(-1)]).toEqual([0, 1]);
  }
});
