import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../math/vec3.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import { makeScene } from '../../scene/defaults.ts';
import type { SceneCamera } from '../../scene/types.ts';
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
const close = (a: Vec3, b: Vec3) => {
  for (const k of [0, 1, 2]) expect(a[k]).toBeCloseTo(b[k], 12);
};

describe('the observer', () => {
  test('follows the moving camera with its velocity', () => {
    const at = observerPath(scene, {}, c, 0)(1);
    close(at.position, [6, 0, 0]);
    close(velocity(at.u), [0.6, 0, 0]);
    expect(at.lens.fovY).toBe(1);
  });

  test('keeps the path and takes a given velocity', () => {
    const at = observerPath(scene, { beta: [0, 0, -0.8] }, c, 0)(1);
    close(at.position, [6, 0, 0]);
    close(velocity(at.u), [0, 0, -0.8]);
  });

  test('coasts from a given position, unless held', () => {
    const flags = { beta: [0, 0.5, 0] as Vec3, position: [1, 1, 1] as Vec3 };
    close(observerPath(scene, flags, c, 3)(3).position, [1, 1, 1]);
    close(observerPath(scene, flags, c, 3)(5).position, [1, 11, 1]);
    close(observerPathFrom(observerSetup(scene, flags, c, 3, true), c, 3)(5).position, [1, 1, 1]);
  });

  test('is at rest at a given position without a velocity', () => {
    const at = observerPath(scene, { position: [1, 1, 1] }, c, 0)(1);
    close(at.position, [1, 1, 1]);
    close(at.u, [0, 0, 0]);
  });

  test('looks along target − position', () => {
    const at = observerPath(scene, { position: [0, 0, 5], lookAt: [0, 0, -5], fov: 90 }, c, 0)(0);
    close([at.orientation[0], at.orientation[1], at.orientation[2]], [0, 0, 0]);
    expect(at.lens.fovY).toBeCloseTo(Math.PI / 2, 15);
  });

  test('lists the existing cameras', () => {
    expect(() => observerPath(scene, { camera: '/Nothing' }, c, 0)).toThrow('/Flying');
  });
});
