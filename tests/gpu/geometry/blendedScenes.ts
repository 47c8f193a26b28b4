import { IDENTITY } from '../../../src/math/quat.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { SceneRenderer } from '../../../src/render/renderer.ts';
import { makeMaterial, makeObject, makeScene } from '../../../src/scene/defaults.ts';
import { withListedPoints } from '../../../src/scene/streaming/samplePoints.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS } from '../../../src/scene/view/view.ts';
import { blendedArm } from '../../support/blendedArm.ts';

export const SIZE = 64;

/** Whether skins are drawn from their joints, or from points of all vertices at all nodes. */
type SkinForm = 'joints' | 'points';

const TIMES = Float64Array.from({ length: 80 }, (_, k) => 0.1 * k);

/** A skin with a blend shape, under light that makes it cast shadows on itself. */
function skinScene(form: SkinForm): Scene {
  const { mesh, motion } = blendedArm(TIMES, [-0.1, 0, -5], 12);
  const skin = form === 'joints' ? motion : withListedPoints(motion);
  return makeScene({
    name: form,
    materials: [makeMaterial({ name: 'skin', baseColor: [0.8, 0.5, 0.3] })],
    objects: [makeObject({ path: '/Skin', mesh, motion: skin })],
    lights: [{ kind: 'distant', path: '/Sun', direction: [-0.8, -0.2, -0.5], color: [2, 2, 2] }],
  });
}

/** When the blend shape has about its greatest weight. */
const VIEWS = [
  { t: 6, beta: [0.2, 0, 0.5] as Vec3, view: 'light-cone' },
  { t: 5.2, beta: [0.3, 0.1, 0.3] as Vec3, view: 'simultaneity' },
] as const;

/** By form and view: positions, emission times, normals, and the picture. */
export const renderForms = async (renderer: SceneRenderer): Promise<number[][][][]> => [
  await renderSkins(renderer, 'joints'),
  await renderSkins(renderer, 'points'),
];

async function renderSkins(renderer: SceneRenderer, form: SkinForm): Promise<number[][][]> {
  renderer.setSize(SIZE, SIZE);
  await renderer.setScene(skinScene(form));
  const seen: number[][][] = [];
  for (const { t, beta, view } of VIEWS) {
    const eye = {
      t,
      position: [0, 0, 0] as Vec3,
      u: properVelocity(beta),
      orientation: IDENTITY,
      lens: perspective(0.7),
    };
    renderer.render([eye], { ...DEFAULT_SETTINGS, speedOfLight: 6, view });
    const parts: number[][] = [];
    for (const name of ['position', 'emission_time', 'normal', 'beauty'] as const)
      parts.push(Array.from(await renderer.readAov(name)));
    seen.push(parts);
  }
  return seen;
}
