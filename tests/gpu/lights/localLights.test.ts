import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import { ZERO } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { FOREVER, restingAt } from '../../../src/scene/defaults.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import type { AreaLight, LocalLight, Material, Motion, RigidMotion } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { area, GREY, lambert, lamp, lit } from '../../support/lightKit.ts';
import { compareWithReference, type Difference } from '../support/agreement.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 40;
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

/** From 3 m above the floor, straight down; in the simultaneity view a scene at rest is lit at once. */
const VIEW: ViewPoint = { t: 0, position: [0, 0, 3], u: ZERO, orientation: IDENTITY, lens: perspective(1.4) };
const SETTINGS: RenderSettings = { ...GREY, grid: false };

/** The rasterizer ignores refractive indices: all dielectrics reflect like ior 1.5. */
const MATT = { ...lambert(0.8), ior: 1.5, roughness: 1 };

interface Case {
  readonly material?: Material;
  readonly motion?: Motion;
  readonly view?: ViewPoint;
  readonly settings?: RenderSettings;
  readonly samples?: number;
}

/** Difference of the rasterizer's light on a floor from the reference's. */
const onFloor = (
  light: LocalLight,
  { material = MATT, motion, view = VIEW, settings = SETTINGS, samples = 256 }: Case = {},
): Promise<Difference> =>
  compareWithReference(
    headless,
    lit([{ mesh: plane(60, 60), material, ...(motion && { motion }) }], [light]),
    view,
    settings,
    samples,
  );

const tilted = (x: number, z: number, angle: number): Pick<AreaLight, 'motion'> => ({
  motion: { kind: 'static', pose: { position: [x, 0.3, z], orientation: fromAxisAngle([0.3, 1, 0], angle) } },
});

const LAMPS: readonly (readonly [string, LocalLight])[] = [
  ['a rectangle', area('rect', [0, 0, 0], { width: 1.6, height: 0.7, ...tilted(0.4, 1.2, 0.5) })],
  [
    'a rectangle that stands on the floor',
    area('rect', [0, 0, 0], { width: 1.5, height: 1, ...tilted(1, 0.4, Math.PI / 2) }),
  ],
  ['a rectangle near by', area('rect', [0.3, 0, 0.25], { width: 1, height: 1 })],
  ['a disk', area('disk', [0, 0, 0], { radius: 0.6, ...tilted(-0.5, 1, -0.4) })],
  ['a tube', area('cylinder', [0, 0, 0], { radius: 0.2, length: 2, ...tilted(0, 0.9, 0.3) })],
  ['a tube on its end', area('cylinder', [0, 0, 0], { radius: 0.3, length: 1, ...tilted(0.5, 0.7, Math.PI / 2) })],
  ['a line', area('cylinder', [0, 0, 0], { radius: 0, length: 2, ...tilted(0, 0.9, 0.1) })],
];

describe('the rasterizer’s lighting agrees with the reference', () => {
  it.each(LAMPS)('on matt surfaces, with %s', async (_, light) => {
    const { mean, max: most } = await onFloor(light);
    expect(mean).toBeLessThan(0.004);
    // The arcs at a cylinder's ends are polygons.
    expect(most).toBeLessThan(light.kind === 'cylinder' ? 0.04 : 0.015);
  });

  it('with a cone from a point and from a small disk', async () => {
    const shaping = { inner: 0.3, outer: 0.8, focus: 2 };
    const turned = { motion: tilted(0.5, 2, 0.3).motion, shaping };
    for (const light of [lamp([0, 0, 0], turned), area('disk', [0, 0, 0], { radius: 0.05, ...turned })]) {
      const { mean, max: most } = await onFloor(light);
      expect(mean).toBeLessThan(0.003);
      expect(most).toBeLessThan(0.02);
    }
  });

  it.each(LAMPS)('on glossy surfaces, approximately, with %s', async (_, light) => {
    const { mean, max: most } = await onFloor(light, { material: { ...MATT, roughness: 0.4 } });
    expect(mean).toBeLessThan(0.02);
    expect(most).toBeLessThan(0.15);
  });

  it('on a passing surface, for a moving observer', async () => {
    const light = area('rect', [0, 0, 1], { width: 0.3, height: 0.3 });
    const pose = { position: [2.1, 0, 0], orientation: IDENTITY } as const;
    const motion = { kind: 'uniform', pose, velocity: [0.7, 0, 0] } as const;
    const view = { ...VIEW, u: properVelocity([0, 0.3, -0.2]) };
    const { mean, max: most } = await onFloor(light, { motion, view });
    expect(mean).toBeLessThan(0.01);
    expect(most).toBeLessThan(0.05);
  });

  it('for a light that is dark before its birth', async () => {
    const light = {
      ...area('disk', [0, 0, 1], { radius: 0.5 }),
      lifetime: { ...FOREVER, birth: 1 },
      motion: restingAt([0, 0, 1]),
    };
    const scene = lit([{ mesh: plane(60, 60), material: lambert(0.8) }], [light]);
    await headless.renderer.setScene(scene.scene);
    pumpFrame();
    headless.renderer.render([VIEW], SETTINGS, 1);
    expect(Math.max(...(await headless.renderer.readAov('beauty')))).toBe(0);
  });
});

/** Slow light, so that the travel times from light to floor and from floor to observer matter. */
const LATER: ViewPoint = { ...VIEW, t: 4 };

const pose = { position: [-1.5, 0.2, 0.8], orientation: fromAxisAngle([0, 1, 0], 0.4) } as const;
const COURSES: readonly (readonly [string, RigidMotion])[] = [
  ['that flies past', { kind: 'uniform', pose, velocity: [0.8, 0.1, 0] }],
  ['that is accelerated', { kind: 'hyperbolic', pose, properAcceleration: [0.7, 0, 0.1], t0: -1 }],
  ['that turns as it goes', turning()],
];

/** Along an arc at up to 0.8 c, rotating. */
function turning(): RigidMotion {
  const times = Float64Array.from({ length: 60 }, (_, k) => -4 + 0.15 * k);
  const poses = Array.from(times, (t) => [
    ...[1.6 * Math.sin(0.5 * t), 1.2 * Math.cos(0.4 * t), 0.9],
    ...fromAxisAngle([0.3, 1, 0], 0.4 * Math.sin(t)),
  ]);
  return { kind: 'sampled', times, poses: Float64Array.from(poses.flat()) };
}

describe('a light is at its emission event for each surface point, as in the reference', () => {
  it.each(COURSES)('a point %s', async (_, motion) => {
    const { mean, max: most } = await onFloor(lamp([0, 0, 0], { motion }), { view: LATER, samples: 1 });
    expect(mean).toBeLessThan(0.002);
    expect(most).toBeLessThan(0.03);
  });

  it.each(COURSES)('a rectangle with a cone %s, past a moving floor and observer', async (_, motion) => {
    const light = area('rect', [0, 0, 0], {
      width: 0.4,
      height: 0.3,
      motion,
      shaping: { inner: 1, outer: 1.5, focus: 1 },
    });
    const flying = {
      kind: 'uniform',
      pose: { position: [0, 0, 0], orientation: IDENTITY },
      velocity: [0, 0.5, 0],
    } as const;
    const view = { ...LATER, u: properVelocity([0.2, 0, 0.3]) };
    const { mean, max: most } = await onFloor(light, { motion: flying, view, samples: 64 });
    expect(mean).toBeLessThan(0.004);
    expect(most).toBeLessThan(0.05);
  });

  it('between a light and a surface that move together there is no shift', async () => {
    const velocity = [0.6, 0, 0] as const;
    const motion = { kind: 'uniform', pose: { position: [-2.4, 0, 1], orientation: IDENTITY }, velocity } as const;
    const floor = { ...motion, pose: { position: [0, 0, 0], orientation: IDENTITY } } as const;
    const { mean, max: most } = await onFloor(lamp([0, 0, 0], { motion }), { motion: floor, view: LATER, samples: 1 });
    expect(mean).toBeLessThan(0.002);
    expect(most).toBeLessThan(0.03);
  });

  it('in the simultaneity view', async () => {
    const light = lamp([0, 0, 0], { motion: COURSES[0][1] });
    const view = { ...VIEW, t: 2, u: properVelocity([0.3, 0.2, 0]) };
    for (const given of [{ lightDelay: false }, { view: 'simultaneity' }, { view: 'galilean' }] as const) {
      const { mean, max: most } = await onFloor(light, { view, settings: { ...SETTINGS, ...given }, samples: 1 });
      expect(mean, JSON.stringify(given)).toBeLessThan(0.002);
      expect(most).toBeLessThan(0.03);
    }
  });

  it('birth and death spread over the floor at the speed of light', async () => {
    const light = lamp([0.3, 0, 0.5], { lifetime: { birth: -1.2, death: -0.4 } });
    const { mean } = await onFloor(light, { view: { ...VIEW, t: 2.6 }, samples: 1 });
    expect(mean).toBeLessThan(0.01);
  });
});
