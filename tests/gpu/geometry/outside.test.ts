import { perspectiveOf } from '../../../src/scene/view/lenses/lenses.ts';
import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { conjugate, IDENTITY, rotate } from '../../../src/math/quat.ts';
import { add, distance, length, sub, type Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import type { FrameGraph } from '../../../src/scene/frameGraph/frameGraph.ts';
import { box, grid, sphere } from '../../../src/scene/mesh/primitives.ts';
import { BUFFER_SETTINGS, pickSettings } from '../../../src/scene/settings/settings.ts';
import { frustumOf, perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { orbitCamera } from '../../../src/scene/view/outsideCamera.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../../src/scene/view/view.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = { width: 120, height: 80 };
const C = 10;
const PLAIN: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: C, occlusionRadius: 0, antialiasing: false };
/** A floor, a box at rest, and a ball that passes at 0.8 c. */
const SCENE = makeScene({
  name: 'passing',
  materials: [makeMaterial({ name: 'matte', baseColor: [0.6, 0.5, 0.4], ior: 1, roughness: 1 })],
  objects: [
    makeObject({ path: '/Floor', mesh: grid(60, 60, 6, 6, 'Y'), motion: restingAt([0, -2, 0]) }),
    makeObject({ path: '/Box', mesh: box([2, 4, 2]), motion: restingAt([4, 0, -8]) }),
    makeObject({
      path: '/Ball',
      mesh: sphere(1.5),
      motion: { kind: 'uniform', pose: { position: [-4, 0, -6], orientation: IDENTITY }, velocity: [0.8 * C, 0, 0] },
    }),
  ],
});
const OBSERVER: ViewPoint = {
  t: 0.4,
  position: [1, 0.5, 2],
  u: properVelocity([0, 0, -0.6]),
  orientation: IDENTITY,
  lens: perspective(1.5),
};
const CAMERA = orbitCamera({ distance: 22, azimuth: 0.5, elevation: 0.6, fovY: 0.9 }, [0, 1, 0]);
const PLACE = add(OBSERVER.position, CAMERA.place);

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE.width, SIZE.height);
  await headless.renderer.setScene(SCENE);
});
afterAll(() => headless?.close());

async function pixelsOf(view: ViewPoint, settings: RenderSettings): Promise<Uint8Array> {
  pumpFrame();
  headless.renderer.render([view], settings, 1);
  return headless.renderer.readPixels();
}

const different = (a: Uint8Array, b: Uint8Array): number =>
  a.filter((value, i) => Math.abs(value - b[i]!) > 1).length / a.length;

describe('a picture from outside', () => {
  const now = { ...PLAIN, view: 'galilean', outside: CAMERA } as const;
  const { outside: _, ...same } = now;
  const there: ViewPoint = { ...OBSERVER, position: PLACE, orientation: CAMERA.orientation, lens: perspective(0.9) };

  it('of the world’s moment is that of a camera there, also as one of several G-buffers of other lenses', async () => {
    const truth = await pixelsOf(there, same);
    expect(new Set(truth).size).toBeGreaterThan(20);
    expect(different(await pixelsOf(OBSERVER, now), truth)).toBe(0);
    const buffer = { ...pickSettings(BUFFER_SETTINGS, now), scene: 0, outside: CAMERA } as never;
    const frameGraph: FrameGraph = {
      extraBuffers: [buffer],
      passes: [
        { kind: 'light', buffer: 0, shadows: true, occlusion: false },
        { kind: 'light', buffer: 1, shadows: true, occlusion: false },
        { kind: 'mix', mode: 'normal', alpha: 1, below: 0, above: 1 },
      ],
    };
    expect(different(await pixelsOf(OBSERVER, { ...PLAIN, frameGraph }), truth)).toBe(0);
  });

  it('of what an observer sees shows every event of his past light cone where it was', async () => {
    const { renderer } = headless;
    pumpFrame();
    renderer.render([OBSERVER], { ...PLAIN, aberration: false, outside: CAMERA }, 1);
    const [object, position, time] = [
      await renderer.readAov('object'),
      await renderer.readAov('position'),
      await renderer.readAov('emission_time'),
    ];
    const { tanX, tanY } = frustumOf(perspectiveOf(there.lens), SIZE.width, SIZE.height);
    const seen = new Set<number>();
    for (let i = 0; i < object.length; i++) {
      if (object[i]! < 0.5) continue;
      seen.add(object[i]!);
      const event = Array.from(position.subarray(3 * i, 3 * i + 3)) as unknown as Vec3;
      const away = distance(event, OBSERVER.position);
      expect(Math.abs(C * (OBSERVER.t - time[i]!) - away)).toBeLessThan(1e-3 * away);
      const [right, up, back] = rotate(conjugate(CAMERA.orientation), sub(event, PLACE));
      const x = ((right / -back / tanX + 1) / 2) * SIZE.width;
      const y = ((1 - up / -back / tanY) / 2) * SIZE.height;
      expect(Math.abs(x - 0.5 - (i % SIZE.width))).toBeLessThan(0.5);
      expect(Math.abs(y - 0.5 - Math.floor(i / SIZE.width))).toBeLessThan(0.5);
      if (object[i] === 3) {
        const centre: Vec3 = [-4 + 0.8 * C * time[i]!, 0, -6];
        expect(length(sub(event, centre))).toBeLessThan(1.5 * 1.7);
      }
    }
    expect([...seen].sort()).toEqual([1, 2, 3]);
  });
});
