import { stat } from 'node:fs/promises';
import { describe, expect, it } from 'vitest';
import { scenes } from '../../examples/scenes/index.ts';
import { distance, length } from '../../src/math/vec3.ts';
import { velocity } from '../../src/physics/lorentz/boost.ts';
import { sampleTimes } from '../../src/scene/motion/motion.ts';
import type { Scene } from '../../src/scene/types.ts';
import { validate } from '../../src/scene/validation/validate.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import { NAMES, openExample, speedOfLight } from './open.ts';

// Reading a scene takes seconds on a busy machine.
describe.each(NAMES)('examples/%s.usdc', (name) => {
  it('opens without diagnostics, and nothing is faster than light', async () => {
    const scene = await openExample(name);
    // For deforming meshes undersampling is always reported.
    expect(scene.diagnostics.filter(({ code }) => code !== 'usd.between-samples')).toEqual([]);
    expect(validate(scene, speedOfLight(scene))).toEqual([]);
  });

  it('has a title and a text on what to look for, and its opening time is within its time range', async () => {
    const { hints, startTime, endTime, cameras, lights } = await openExample(name);
    expect(hints.title).toMatch(/^[A-Z]/);
    expect(hints.lookFor?.length).toBeGreaterThan(60);
    expect(hints.openAt).toBeGreaterThanOrEqual(startTime);
    expect(hints.openAt).toBeLessThan(endTime);
    expect(cameras.length).toBeGreaterThan(0);
    expect(lights.length).toBeGreaterThan(0);
  });

  it('has a smooth camera: no start or stop at a noticeable speed', async () => {
    const scene = await openExample(name);
    const c = speedOfLight(scene);
    const [camera] = scene.cameras;
    const times = sampleTimes(camera.motion);
    if (!times) return;
    const betas = [...times].map((t) => velocity(observerFromCamera(camera, t, c).u));
    for (let k = 1; k < times.length; k++) {
      const change = distance(betas[k], betas[k - 1]) / (times[k] - times[k - 1]);
      expect(change, `at ${times[k]} s`).toBeLessThan(1);
    }
    expect(length(betas[0])).toBeLessThan(0.1);
  });

  it('equals the output of its script', async () => {
    const [file, made] = [await openExample(name), scenes.find((scene) => scene.name === name)!.make()];
    const outline = ({ objects }: Scene) =>
      objects.map(({ path, mesh, motion }) => `${path} ${motion.kind} ${mesh.indices.length}`).sort();
    expect(outline(file)).toEqual(outline(made));
    expect(file.hints).toEqual(made.hints);
    expect(file.cameras.map(({ path }) => path).sort()).toEqual(made.cameras.map(({ path }) => path).sort());
  });

  it('is small enough to load quickly', async () => {
    const { size } = await stat(new URL(`../../examples/${name}.usdc`, import.meta.url));
    expect(size).toBeLessThan(1e6);
  });
});
