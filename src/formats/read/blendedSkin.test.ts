import { describe, expect, it } from 'vitest';
import { blendedArm } from '../../../tests/support/blendedArm.ts';
import { transformPoint } from '../../math/mat4.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { addScaled, distance, length, sub, type Vec3 } from '../../math/vec3.ts';
import { sampleBoundingBox, sampleBoundingSphere } from '../../scene/bounds/bounds.ts';
import { makeObject, makeScene } from '../../scene/defaults.ts';
import { pointAt } from '../../scene/mesh/polygons.ts';
import { fly } from '../../scene/motion/fly.ts';
import { fastestVertex, vertexPosition } from '../../scene/motion/motion.ts';
import { motionKind } from '../../scene/motion/motions.ts';
import { displacementBounds } from '../../scene/streaming/blendedBounds.ts';
import { normalsAt, pointsAt, vertexSamples, withListedPoints } from '../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion, SceneObject } from '../../scene/types.ts';
import { blendedSkin, jointPoses, ONE_JOINT } from './blendedSkin.ts';

const C = 1e9;
const TIMES = Float64Array.from({ length: 12 }, (_, k) => 0.3 * k + 0.02 * k * k);
/** So far away that places in f32 would have 0.06 m steps. */
const FAR: Vec3 = [1e6, -2e6, 5e5];
const { mesh, motion, jointsAt, shapeAt, bend, bulge } = blendedArm(TIMES, FAR);
const vertices = mesh.positions.length / 3;

/** Σ w M (p + b δ), from the definition. */
function placed(v: number, t: number): Vec3 {
  const p = addScaled(pointAt(mesh.positions, v), bulge(v), shapeAt(t));
  const [a, b] = jointsAt(t).map((m) => transformPoint(m, p));
  return [0, 1, 2].map((i) => (1 - bend[v]) * a[i] + bend[v] * b[i]) as unknown as Vec3;
}

describe('blended points', () => {
  it('are Σ w M (p + Σ b δ) at the nodes, far from the origin too', () => {
    for (const [k, t] of TIMES.entries())
      for (let v = 0; v < vertices; v += 7) {
        const wanted = sub(placed(v, t), FAR);
        // f32 at 3 m; f64 at 2 000 km.
        expect(distance(pointAt(pointsAt(motion, k), v), wanted)).toBeLessThan(2e-6);
        expect(vertexSamples(motion, v)(k)).toEqual(pointAt(pointsAt(motion, k), v));
      }
  });

  it('move straight between nodes', () => {
    const object = makeObject({ path: '/Arm', mesh, motion });
    for (const k of [0, 4, 10]) {
      const [a, b] = [vertexPosition(object, 5, TIMES[k], C), vertexPosition(object, 5, TIMES[k + 1], C)];
      const middle = vertexPosition(object, 5, (TIMES[k] + TIMES[k + 1]) / 2, C);
      expect(distance(middle, a) + distance(middle, b) - distance(a, b)).toBeLessThan(1e-6);
    }
  });

  it('have normals across their surface', () => {
    // Of a surface that is swept smoothly, a normal is across each edge of its triangles, nearly.
    const [points, normals] = [pointsAt(motion, 7), normalsAt(motion, 7)!];
    for (let i = 0; i < mesh.indices.length; i += 9) {
      const [a, b, c] = [...mesh.indices.subarray(i, i + 3)].map((v) => pointAt(points, v));
      const n = pointAt(normals, mesh.indices[i]);
      expect(length(n)).toBeCloseTo(1, 6);
      const face = crossOf(sub(b, a), sub(c, a));
      if (length(face) > 1e-4) expect(dotOf(face, n) / length(face)).toBeGreaterThan(0.8);
    }
  });

  it('stay within their bounds, and these are not much too large', () => {
    const displacements = displacementBounds(motion.points);
    for (let k = 0; k < TIMES.length; k++) {
      const points = pointsAt(motion, k);
      const box = sampleBoundingBox(motion, k)!;
      const { center, radius } = sampleBoundingSphere(motion, k);
      let [reach, moved] = [0, 0];
      for (let v = 0; v < vertices; v++) {
        const p = pointAt(points, v);
        reach = Math.max(reach, distance(p, center));
        for (let i = 0; i < 3; i++) expect(p[i] >= box.min[i] - 1e-6 && p[i] <= box.max[i] + 1e-6).toBe(true);
        if (k > 0) moved = Math.max(moved, distance(p, pointAt(pointsAt(motion, k - 1), v)));
      }
      expect(reach).toBeLessThan(radius + 1e-6);
      expect(radius).toBeLessThan(2 * reach);
      if (k === 0) continue;
      expect(moved).toBeLessThan(displacements[k - 1] + 1e-6);
      expect(displacements[k - 1]).toBeLessThan(3 * moved);
    }
  });

  it('have the fastest vertex that all samples in memory have', () => {
    const of = (m: SampledPointsMotion) => fastestVertex(makeObject({ path: '/Arm', mesh, motion: m }), C);
    const [own, listed] = [of(motion), of(withListedPoints(motion))];
    expect(own).toEqual(listed);
    expect(own.speed).toBeGreaterThan(1);
    expect(fastestVertex(makeObject({ path: '/Arm', mesh, motion }), C, [0, 0], own.speed * 1.001).speed).toBe(0);
  });

  it('turn, scale, move and fly as samples in memory do', () => {
    const by = { orientation: fromAxisAngle([1, 2, 3], 0.7), scale: 1.5, position: [3, 4, 5] as const };
    const near = blendedArm(TIMES).motion;
    const changed = (m: SampledPointsMotion): SceneObject => {
      const turned = motionKind(m).transform(m, by);
      const scene = makeScene({ name: 'a', objects: [makeObject({ path: '/Arm', mesh, motion: turned })], endTime: 3 });
      return fly(scene, { path: '/Arm', beta: [0.1, 0, 0.2], at: 1, authoredIn: 'world' }, 10).objects[0]!;
    };
    const [own, listed] = [changed(near), changed(withListedPoints(near))];
    for (const t of [-5, 0, 0.4, 2, 7])
      for (const v of [0, 40, vertices - 1])
        expect(distance(vertexPosition(own, v, t, 10), vertexPosition(listed, v, t, 10))).toBeLessThan(2e-5);
  });

  const single = (weights: readonly number[], matrix: readonly number[], rest = [1, 2, 3]) =>
    blendedSkin({
      rest: { positions: Float32Array.from(rest), normals: Float32Array.of(0, 0, 1) },
      shapes: [],
      shapeWeights: new Float64Array(0),
      skin: { perPoint: weights.length, joints: weights.map(() => 0), weights },
      poses: jointPoses(1, ONE_JOINT, (_, out) => out.set(matrix)),
      origin: [10, 0, 0],
    });
  const SHIFT = [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0];

  it('leave the missing part of weights at the world’s origin, as a plain sum does', () => {
    // ½ (6, 2, 3) − (10, 0, 0)
    expect([...pointsAt({ points: single([0.5], SHIFT) }, 0)]).toEqual([-7, 1, 1.5]);
    expect([...pointsAt({ points: single([0], SHIFT) }, 0)]).toEqual([-10, 0, 0]);
    // Negative weights are allowed for in the bounds.
    const points = single([2, -0.5], SHIFT);
    expect([...pointsAt({ points }, 0)]).toEqual([-1, 3, 4.5]);
    const sphere = sampleBoundingSphere({ kind: 'sampled-points', times: TIMES, origin: [10, 0, 0], points }, 0);
    expect(distance(sphere.center, [-1, 3, 4.5])).toBeLessThanOrEqual(sphere.radius);
  });

  it('are at the world’s origin, and told, where a joint or a place is not finite', () => {
    for (const points of [
      single(
        [1],
        SHIFT.map((x, i) => (i === 3 ? Number.NaN : x)),
      ),
      single([1], SHIFT, [Number.POSITIVE_INFINITY, 0, 0]),
      single(
        [1],
        SHIFT.map((x) => 1e38 * x),
        [1e25, 0, 0],
      ),
    ]) {
      expect([...points.nonFiniteVertices!]).toEqual([1]);
      expect([...pointsAt({ points }, 0)]).toEqual([-10, 0, 0]);
    }
    expect(single([1], SHIFT).nonFiniteVertices).toBeUndefined();
  });
});

const crossOf = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const dotOf = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
