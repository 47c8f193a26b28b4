import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import { ZERO } from '../../../src/math/vec3.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import type { LocalLight, Material, UniformMotion } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { area, GREY, lambert, lamp, lit, SPECTRAL } from '../../support/lightKit.ts';
import { compareWithReference, type Difference } from '../support/agreement.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(40, 40);
});
afterAll(() => headless?.close());

const VIEW: ViewPoint = { t: 0, position: [0, 0, 3], u: ZERO, orientation: IDENTITY, lens: perspective(1.4) };
const MATT = { ...lambert(0.8), ior: 1.5, roughness: 1 };
const GLOSSY = { ...MATT, roughness: 0.3 };

/** About 1 m across. */
const LAMPS = ['rect', 'disk', 'cylinder', 'sphere'] as const;

/** Past the floor at `height` [light sizes = m], above its centre when the visible light was emitted. */
function passing(kind: (typeof LAMPS)[number], height: number, beta: number): LocalLight {
  const motion: UniformMotion = {
    kind: 'uniform',
    pose: { position: [beta * (3 + height), 0, height], orientation: fromAxisAngle([0, 1, 0], 0.3) },
    velocity: [beta, 0, 0],
  };
  if (kind === 'sphere') return lamp([0, 0, 0], { radius: 0.5, motion });
  if (kind === 'rect') return area('rect', [0, 0, 0], { width: 1, height: 1, motion });
  if (kind === 'disk') return area('disk', [0, 0, 0], { radius: 0.5, motion });
  return area('cylinder', [0, 0, 0], { radius: 0.15, length: 1, motion });
}

const compared = (
  light: LocalLight,
  material: Material,
  settings: RenderSettings,
  samples: number,
): Promise<Difference> =>
  compareWithReference(
    headless,
    lit([{ mesh: plane(60, 60), material }], [light]),
    VIEW,
    { ...settings, grid: false },
    samples,
  );

describe('a light passing close by agrees with the reference, although D varies over it', () => {
  const cases = LAMPS.flatMap((kind) => ([0.5, 0.9] as const).map((beta) => [kind, beta] as const));

  it.each(cases)('on matt surfaces: a %s at %f c, brightness', async (kind, beta) => {
    const { mean, max: most } = await compared(passing(kind, 1, beta), MATT, GREY, 128);
    expect(mean).toBeLessThan(0.002);
    // Relative to the D of its centre it is 0.3 to 0.8.
    expect(most).toBeLessThan(0.02);
  });

  it.each(LAMPS)('on matt surfaces: a %s, colour', async (kind) => {
    const { mean, max: most } = await compared(passing(kind, 1, 0.6), MATT, SPECTRAL, 128);
    expect(mean).toBeLessThan(0.002);
    expect(most).toBeLessThan(0.05);
  });

  it.each(LAMPS)('on glossy surfaces, approximately: a %s', async (kind) => {
    const { mean, max: most } = await compared(passing(kind, 1, 0.6), GLOSSY, GREY, 128);
    expect(mean).toBeLessThan(0.002);
    expect(most).toBeLessThan(0.04);
  });

  it('a sphere light cut by the horizon, at rest and moving', async () => {
    // It passes the floor's edge.
    const board = lit([{ mesh: plane(2, 3), material: MATT }], [lamp([1.6, 0, 0.2], { radius: 0.5 })]);
    const flying = lit([{ mesh: plane(2, 3), material: MATT }], [passingAside(0.6)]);
    for (const scene of [board, flying]) {
      const { mean, max: most } = await compareWithReference(headless, scene, VIEW, { ...GREY, grid: false }, 256);
      expect(mean).toBeLessThan(0.003);
      expect(most).toBeLessThan(0.08);
    }
  });
});

const passingAside = (beta: number): LocalLight =>
  lamp([0, 0, 0], {
    radius: 0.5,
    motion: {
      kind: 'uniform',
      pose: { position: [1.6, beta * 4, 0.2], orientation: IDENTITY },
      velocity: [0, beta, 0],
    },
  });
