import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, expectClose, offset, uniform } from '../../tests/support/physicsArbitraries.ts';
import * as mat3 from './mat3.ts';
import * as mat4 from './mat4.ts';
import { closestRotation } from './polar.ts';
import * as quat from './quat.ts';
import { cross, dot, length, type Vec3 } from './vec3.ts';

const rotation = fc
  .tuple(direction, uniform(-Math.PI, Math.PI))
  .map(([axis, angle]) => quat.fromAxisAngle(axis, angle));
const element = uniform(-3, 3);
const nine = fc.array(element, { minLength: 9, maxLength: 9 });
const pose = fc.record({ position: offset, orientation: rotation });
const sameRotation = (a: quat.Quat, b: quat.Quat, tolerance: number) =>
  expectClose(quat.toMatrix(a), quat.toMatrix(b), tolerance);

describe('quaternions', () => {
  it('rotate by Rodrigues’ formula', () =>
    fc.assert(
      fc.property(direction, uniform(-9, 9), offset, (k, angle, v) => {
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        const kv = cross(k, v);
        const expected = v.map((x, i) => x * c + kv[i] * s + k[i] * dot(k, v) * (1 - c));
        expectClose(quat.rotate(quat.fromAxisAngle(k, angle), v), expected, 1e-14 * length(v));
      }),
    ));
  it('compose right to left, and are inverted by the conjugate', () =>
    fc.assert(
      fc.property(rotation, rotation, offset, (a, b, v) => {
        const tolerance = 1e-14 * length(v);
        expectClose(quat.rotate(quat.multiply(a, b), v), quat.rotate(a, quat.rotate(b, v)), tolerance);
        expectClose(quat.rotate(quat.conjugate(a), quat.rotate(a, v)), v, tolerance);
      }),
    ));
  it('convert to matrices and back, at half turns too', () =>
    fc.assert(
      fc.property(rotation, direction, offset, (q, axis, v) => {
        expectClose(mat3.transform(quat.toMatrix(q), v), quat.rotate(q, v), 1e-14 * length(v));
        sameRotation(quat.fromMatrix(quat.toMatrix(q)), q, 1e-14);
        const half = quat.fromAxisAngle(axis, Math.PI);
        sameRotation(quat.fromMatrix(quat.toMatrix(half)), half, 1e-14);
      }),
    ));
  it('are the identity when of length 0', () => {
    expect(quat.normalizeQuat([0, 0, 0, 0])).toEqual(quat.IDENTITY);
    expect(quat.fromMatrix(mat3.IDENTITY)).toEqual(quat.IDENTITY);
    expectClose(quat.fromAxisAngle([0, 0, 7], 0), quat.IDENTITY, 0);
  });
  it('slerp at constant speed along the shorter arc', () =>
    fc.assert(
      fc.property(rotation, direction, uniform(0, 3), element, (a, axis, angle, s) => {
        const b = quat.multiply(a, quat.fromAxisAngle(axis, angle));
        const expected = quat.multiply(a, quat.fromAxisAngle(axis, s * angle));
        sameRotation(quat.slerp(a, b, s), expected, 1e-13);
        sameRotation(quat.slerp(a, [-b[0], -b[1], -b[2], -b[3]], s), expected, 1e-13);
        expectClose(quat.rotationAngle(quat.multiply(quat.conjugate(a), b)), angle, 1e-14);
      }),
    ));
});

describe('3×3 matrices', () => {
  it('multiply like compositions of maps', () =>
    fc.assert(
      fc.property(nine, nine, offset, (a, b, v) => {
        const both = mat3.transform(mat3.multiply(a, b), v);
        expectClose(both, mat3.transform(a, mat3.transform(b, v)), 1e-13 * length(v) * 100);
      }),
    ));
  it('are inverted by the inverse; singular ones have none', () =>
    fc.assert(
      fc.property(nine, (m) => {
        const inverse = mat3.invert(m);
        fc.pre(inverse !== undefined && Math.abs(mat3.determinant(m)) > 1e-2);
        expectClose(mat3.multiply(m, inverse ?? []), mat3.IDENTITY, 1e-10);
      }),
    ));
  it('have no inverse when of lower rank', () => {
    expect(mat3.invert([1, 2, 3, 2, 4, 6, 0, 1, 5])).toBeUndefined();
    expect(mat3.invert(new Array<number>(9).fill(0))).toBeUndefined();
    expect(mat4.invert([1, 2, 3, 4, 2, 4, 6, 8, 0, 1, 0, 0, 0, 0, 0, 1])).toBeUndefined();
    expect(mat4.invert(new Array<number>(16).fill(Number.NaN))).toBeUndefined();
  });
  it('transform normals by their cofactors: (M a) × (M b) = cof(M)(a × b)', () =>
    fc.assert(
      fc.property(nine, direction, direction, (m, a, b) => {
        const expected = cross(mat3.transform(m, a), mat3.transform(m, b));
        expectClose(mat3.transform(mat3.cofactors(m), cross(a, b)), expected, 1e-12);
      }),
    ));
});

describe('4×4 matrices', () => {
  it('of poses compose and invert like rigid motions', () =>
    fc.assert(
      fc.property(pose, pose, offset, (p, q, v) => {
        const [P, Q] = [mat4.fromPose(p), mat4.fromPose(q)];
        const moved = quat.rotate(p.orientation, v).map((x, i) => x + p.position[i]);
        const size = length(v) + length(p.position) + length(q.position);
        expectClose(mat4.transformPoint(P, v), moved, 1e-14 * size);
        expectClose(mat4.transformVector(P, v), quat.rotate(p.orientation, v), 1e-14 * size);
        const steps = mat4.transformPoint(P, mat4.transformPoint(Q, v));
        expectClose(mat4.transformPoint(mat4.multiply(P, Q), v), steps, 1e-13 * size);
        expectClose(mat4.transformPoint(mat4.invert(P) ?? [], mat4.transformPoint(P, v)), v, 1e-13 * size);
        expect(mat4.isRigid(P)).toBe(true);
      }),
    ));
  it('invert every regular matrix', () =>
    fc.assert(
      fc.property(fc.array(element, { minLength: 16, maxLength: 16 }), fc.integer({ min: 0, max: 3 }), (raw, shift) => {
        // Dominated by a shifted diagonal: regular, and in need of pivoting.
        const m = raw.map((x, i) => (i % 4 === (Math.floor(i / 4) + shift) % 4 ? x + 13 : x));
        expectClose(mat4.multiply(m, mat4.invert(m) ?? []), mat4.IDENTITY, 1e-13);
        expectClose(mat4.transpose(mat4.transpose(m)), m, 0);
      }),
    ));
  it('are not rigid with a scale or a reflection', () => {
    expect(mat4.isRigid(mat4.fromParts([2, 0, 0, 0, 1, 0, 0, 0, 1], [1, 2, 3]))).toBe(false);
    expect(mat4.isRigid(mat4.fromParts([-1, 0, 0, 0, 1, 0, 0, 0, 1], [1, 2, 3]))).toBe(false);
    expect(mat4.isRigid(mat4.fromParts([1 + 1e-6, 0, 0, 0, 1, 0, 0, 0, 1], [0, 0, 0]), 1e-5)).toBe(true);
  });
});

describe('polar decomposition into rotation and stretch', () => {
  it('reproduces the matrix by a proper rotation and a symmetric stretch, also singular and reflected', () =>
    fc.assert(
      fc.property(nine, offset, fc.constantFrom(1, 0), (m, t, lastColumn) => {
        const linear = m.map((x, i) => (i % 3 === 2 ? x * lastColumn : x));
        const { pose: p, stretch } = mat4.decomposeRigid(mat4.fromParts(linear, t));
        const back = mat3.multiply(quat.toMatrix(p.orientation), stretch);
        expectClose(back, linear, 1e-11);
        expectClose(mat3.transpose(stretch), stretch, 0);
        expect(p.position).toEqual(t);
        expectClose(Math.hypot(...p.orientation), 1, 1e-14);
      }),
    ));
  it('finds the rotation of a composed matrix', () =>
    fc.assert(
      fc.property(pose, rotation, fc.tuple(element, element, element), (p, q, logs) => {
        // A positive stretch along rotated axes.
        const Q = quat.toMatrix(q);
        const [a, b, c] = logs.map(Math.exp);
        const S = mat3.multiply(Q, mat3.multiply([a, 0, 0, 0, b, 0, 0, 0, c], mat3.transpose(Q)));
        const M = mat4.fromParts(mat3.multiply(quat.toMatrix(p.orientation), S), p.position);
        const found = mat4.decomposeRigid(M);
        sameRotation(found.pose.orientation, p.orientation, 1e-11);
        expectClose(found.stretch, S, 1e-10);
      }),
    ));
  it('needs no iteration where the stretch is known, and only there', () =>
    fc.assert(
      fc.property(pose, element, fc.tuple(element, element, element), (p, log, logs) => {
        const S = [Math.exp(logs[0] / 3), 0, 0, 0, Math.exp(logs[1] / 3), 0, 0, 0, Math.exp(logs[2] / 3)];
        const M = mat4.fromParts(mat3.multiply(quat.toMatrix(p.orientation), S), p.position);
        const inverse = S.map((x) => (x === 0 ? 0 : 1 / x));
        sameRotation(mat4.poseFromStretched(M, inverse)!.orientation, p.orientation, 1e-11);
        expect(mat4.poseFromStretched(M, mat3.multiply(inverse, [1.001, 0, 0, 0, 1, 0, 0, 0, 1]))).toBeUndefined();
        const even = quat.toMatrix(p.orientation).map((x) => x * Math.exp(log));
        sameRotation(mat4.decomposeRigid(mat4.fromParts(even, p.position)).pose.orientation, p.orientation, 1e-11);
      }),
    ));
  it('of a reflection, of a matrix of lower rank and of the zero matrix rotates as little as possible', () => {
    const parts = (x: number, y: number, z: number) =>
      mat4.decomposeRigid(mat4.fromParts([x, 0, 0, 0, y, 0, 0, 0, z], [0, 0, 0] as Vec3));
    for (const s of [
      [-1, 2, 3],
      [1, 1, 1],
      [2, 3, 0],
      [0, 0, 0],
    ])
      expect(parts(s[0], s[1], s[2]).pose.orientation, s.join(' ')).toEqual(quat.IDENTITY);
    expectClose(parts(-1, 2, 3).stretch, [-1, 0, 0, 0, 2, 0, 0, 0, 3], 1e-15);
  });
  it('of an unrotated matrix is the unit quaternion and the matrix itself, to the last bit', () => {
    const size = element.map(Math.exp);
    fc.assert(
      fc.property(size, size, size, offset, (x, y, z, t) => {
        const linear = [x, 0, 0, 0, y, 0, 0, 0, z];
        const found = mat4.decomposeRigid(mat4.fromParts(linear, t));
        expect(found).toEqual({ pose: { position: t, orientation: quat.IDENTITY }, stretch: linear });
        // Horn's method: relative differences of 10⁻¹⁵ become rotations.
        sameRotation(closestRotation([x, 1e-15 * x, 0, 0, y, 0, 0, 0, z]), quat.IDENTITY, 1e-14);
      }),
    );
    expect(mat3.isPositiveDiagonal([1, 0, 0, 0, Infinity, 0, 0, 0, 1])).toBe(false);
    expect(mat3.isPositiveDiagonal([1, 0, 0, 0, 1, 0, 0, 0, Number.NaN])).toBe(false);
    expect(mat3.isPositiveDiagonal([1, 0, 0, 0, 1, 0, 1e-300, 0, 1])).toBe(false);
  });
});

describe('the shortest rotation', () => {
  const turned = (from: Vec3, to: Vec3) => {
    const q = quat.shortestRotation(from, to);
    expectClose(quat.rotate(q, from), to, 1e-9);
    return quat.rotationAngle(q);
  };

  it('takes one direction to another by the angle between them', () =>
    fc.assert(
      fc.property(direction, direction, (a, b) => {
        expectClose([Math.cos(turned(a, b))], [dot(a, b)], 1e-9);
      }),
    ));

  it('of opposite directions is half a turn', () =>
    fc.assert(
      fc.property(direction, (a) => {
        expectClose([turned(a, [-a[0], -a[1], -a[2]])], [Math.PI], 1e-9);
        expectClose([turned([0, 1, 0], [0, -1, 0])], [Math.PI], 1e-9);
      }),
    ));
});
