import { describe, expect, test } from 'vitest';
import { addScaled, dot, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { unaberrate } from '../../physics/optics/aberration.ts';
import { dopplerAtPixel } from '../../physics/optics/doppler.ts';
import { makeMaterial, makeObject, makeScene } from '../../scene/defaults.ts';
import { plane, sphere } from '../../scene/mesh/primitives.ts';
import type { SceneObject } from '../../scene/types.ts';
import { lookAtOrientation } from '../../scene/view/camera.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { probePixel } from './pixelProbe.ts';

const size = { width: 200, height: 100 };
const down: Vec3 = [0, -1, -1];
const view = (beta: Vec3): ViewPoint => ({
  t: 3,
  position: [0, 2, 0],
  u: properVelocity(beta),
  orientation: lookAtOrientation(down, [0, 1, 0]),
  lens: perspective(1),
});

describe('the probe of a pixel', () => {
  test('on a floor at rest is where the ray, transformed to the world, meets it', () => {
    const floor = makeObject({ path: '/Floor', mesh: plane(400, 400, 'Y') });
    const scene = makeScene({ name: 'floor', objects: [floor] });
    // The middle of the picture is the corner between four pixels.
    const seen = probePixel(
      scene,
      view([0.3, 0.2, -0.6]),
      10,
      { view: 'light-cone', coneSlope: 0.5 },
      size,
      [99.5, 49.5],
    );
    const nPrime = scale(down, Math.SQRT1_2);
    const n = unaberrate(nPrime, properVelocity([0.3, 0.2, -0.6]));
    const distance = -2 / n[1];
    const expected: Vec3 = [n[0] * distance, 0, n[2] * distance];
    for (const k of [0, 1, 2]) expect(seen?.position[k]).toBeCloseTo(expected[k], 10);
    expect(seen?.time).toBeCloseTo(3 - distance / 10, 10);
    expect(seen?.doppler).toBeCloseTo(dopplerAtPixel(nPrime, properVelocity([0.3, 0.2, -0.6])), 10);
    expect(seen).toMatchObject({ prim: '/Floor', object: 1 });
    // The picture's middle is straight ahead in any case.
    for (const k of [0, 1, 2]) expect(seen?.apparent[k]).toBeCloseTo(nPrime[k] * (seen?.distance ?? 0), 10);
  });

  test("of a floor in the slice of simultaneity is an event of the observer's own moment: c Δt = β·Δx", () => {
    const scene = makeScene({ name: 'floor', objects: [makeObject({ path: '/Floor', mesh: plane(400, 400, 'Y') })] });
    const beta: Vec3 = [0.3, 0.2, -0.6];
    const seen = probePixel(scene, view(beta), 10, { view: 'simultaneity', coneSlope: 0.5 }, size, [99.5, 49.5]);
    if (!seen) throw new Error('the floor is not hit');
    expect(10 * (seen.time - 3)).toBeCloseTo(dot(beta, sub(seen.position, [0, 2, 0])), 10);
    expect(seen.position[1]).toBeCloseTo(0, 10);
    expect(seen.doppler).toBe(1);
    const direction = normalize(down);
    for (const k of [0, 1, 2]) expect(seen.apparent[k]).toBeCloseTo(direction[k] * seen.distance, 10);
  });

  test('has normal, albedo and the visible part of the sky: all of it on a plain, half of it at the foot of a wall', () => {
    const material = makeMaterial({ name: 'paint', baseColor: [0.2, 0.4, 0.6] });
    const floor = makeObject({ path: '/Floor', mesh: plane(400, 400, 'Y') });
    const wall = makeObject({
      path: '/Wall',
      mesh: plane(400, 400),
      motion: { kind: 'static', pose: { position: [0, 200, -2.001], orientation: [0, 0, 0, 1] } },
    });
    const seenWith = (...objects: SceneObject[]) =>
      probePixel(
        makeScene({ name: 'foot', objects, materials: [material] }),
        view([0, 0, 0]),
        10,
        { view: 'light-cone', coneSlope: 0.5 },
        size,
        [99.5, 49.5],
      );
    const plain = seenWith(floor);
    expect(plain?.normal).toEqual([0, 1, 0]);
    for (const [k, value] of [0.2, 0.4, 0.6].entries()) expect(plain?.albedo[k]).toBeCloseTo(value, 6);
    expect(plain?.occlusion).toBeCloseTo(1, 6);
    const foot = seenWith(floor, wall);
    expect(foot?.prim).toBe('/Floor');
    expect(foot?.occlusion).toBeCloseTo(0.5, 3);
  });

  test('is of the nearest object, and undefined without one', () => {
    const ball = (path: string, along: number) =>
      makeObject({
        path,
        mesh: sphere(0.2),
        motion: { kind: 'static', pose: { position: addScaled([0, 2, 0], down, along), orientation: [0, 0, 0, 1] } },
      });
    const scene = makeScene({ name: 'balls', objects: [ball('/Far', 5), ball('/Near', 2)] });
    expect(
      probePixel(scene, view([0, 0, 0]), 10, { view: 'light-cone', coneSlope: 0.5 }, size, [99.5, 49.5])?.prim,
    ).toBe('/Near');
    expect(
      probePixel(scene, view([0, 0, 0]), 10, { view: 'light-cone', coneSlope: 0.5 }, size, [0, 0]),
    ).toBeUndefined();
  });
});
