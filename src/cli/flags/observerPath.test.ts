import { describe, expect, test } from 'vitest';
import { rotate } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import { makeScene } from '../../scene/defaults.ts';
import type { SceneCamera } from '../../scene/types.ts';
import { perspectiveOf } from '../../scene/view/lenses/lenses.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { observerPathFrom } from '../../scene/view/observerPath.ts';
import { observerPath, observerSetup } from './observerPath.ts';

const c = 10;
const straight = [0, 0, 0, 1];
const flying: SceneCamera = {
  path: '/Flying',
  fovY: 1,
  motion: {
    kind: 'sampled',
    times: Float64Array.of(0, 2),
    poses: Float64Array.of(0, 0, 0, ...straight, 12, 0, 0, ...straight),
  },
};
const scene = makeScene({ name: 'test', cameras: [flying] });
const cameraPath = 'smooth' as const;
const close = (a: Vec3, b: Vec3) => {
  for (const k of [0, 1, 2]) expect(a[k]).toBeCloseTo(b[k], 12);
};

describe('the observer', () => {
  test('follows the moving camera with its velocity', () => {
    const at = observerPath(scene, { cameraPath }, c, 0)(1);
    close(at.position, [6, 0, 0]);
    close(velocity(at.u), [0.6, 0, 0]);
    expect(at.lens).toEqual(perspective(1));
  });

  test('keeps the path and takes a given velocity', () => {
    const at = observerPath(scene, { cameraPath, beta: [0, 0, -0.8] }, c, 0)(1);
    close(at.position, [6, 0, 0]);
    close(velocity(at.u), [0, 0, -0.8]);
  });

  test('coasts from a given position, unless it stays in place', () => {
    const flags = { cameraPath, beta: [0, 0.5, 0] as Vec3, position: [1, 1, 1] as Vec3 };
    close(observerPath(scene, flags, c, 3)(3).position, [1, 1, 1]);
    close(observerPath(scene, flags, c, 3)(5).position, [1, 11, 1]);
    close(observerPathFrom(observerSetup(scene, { ...flags, stayInPlace: true }, c, 3), c, 3)(5).position, [1, 1, 1]);
  });

  test('has a camera that stands elsewhere and looks at a point from there', () => {
    const vantage: Vec3 = [0, 0, -6];
    const flags = { cameraPath, position: [1, 1, 1] as Vec3, lookAt: [1, 1, -9] as Vec3, vantage };
    const view = observerPathFrom(observerSetup(scene, flags, c, 0), c, 0)(0);
    close(view.position, [1, 1, 1]);
    expect(view.vantage).toEqual(vantage);
    close(rotate(view.orientation, [0, 0, -1]), [0, 0, -1]);
    const behind = observerSetup(scene, { ...flags, vantage: [0, 0, -20] }, c, 0);
    close(rotate(observerPathFrom(behind, c, 0)(0).orientation, [0, 0, -1]), [0, 0, 1]);
    expect(() => observerSetup(scene, { ...flags, vantage: [0, 0, -10] }, c, 0)).toThrow(/where the camera is/);
  });

  test('is at rest at a given position without a velocity', () => {
    const at = observerPath(scene, { cameraPath, position: [1, 1, 1] }, c, 0)(1);
    close(at.position, [1, 1, 1]);
    close(at.u, [0, 0, 0]);
  });

  test('rides on a smooth path through more than two samples, or in straight lines', () => {
    const poses = Float64Array.of(0, 0, 0, ...straight, 1, 0, 0, ...straight, 3, 0, 0, ...straight);
    const camera = { ...flying, motion: { kind: 'sampled', times: Float64Array.of(0, 1, 2), poses } as const };
    const turning = makeScene({ name: 'test', cameras: [camera] });
    const speeds = (cameraPath: 'smooth' | 'straight', times: readonly number[]) =>
      times.map((t) => c * velocity(observerPath(turning, { cameraPath }, c, 0)(t).u)[0]);
    // The natural cubic spline through 0, 1, 3 has the slopes 3/4, 3/2, 9/4.
    const [start, middle, end] = speeds('smooth', [0, 1, 2]);
    expect(start).toBeCloseTo(0.75, 12);
    expect(middle).toBeCloseTo(1.5, 12);
    expect(end).toBeCloseTo(2.25, 12);
    // With a velocity of his own he is where the page's observer is, who does not ride.
    const beta = [0, 0, 0] as const;
    close(observerPath(turning, { cameraPath: 'smooth', beta }, c, 0)(1.5).position, [2, 0, 0]);
    const [one, two] = speeds('straight', [0.5, 1.5]);
    expect(one).toBeCloseTo(1, 12);
    expect(two).toBeCloseTo(2, 12);
  });

  test('looks along target − position', () => {
    const at = observerPath(scene, { cameraPath, position: [0, 0, 5], lookAt: [0, 0, -5], fov: 90 }, c, 0)(0);
    close([at.orientation[0], at.orientation[1], at.orientation[2]], [0, 0, 0]);
    expect(perspectiveOf(at.lens).fovY).toBeCloseTo(Math.PI / 2, 15);
  });

  test('lists the existing cameras', () => {
    expect(() => observerPath(scene, { cameraPath, camera: '/Nothing' }, c, 0)).toThrow('/Flying');
  });
});
