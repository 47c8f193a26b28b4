import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { makeObject, makeScene } from '../../../src/scene/defaults.ts';
import { box, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { DATA_SETTINGS } from '../support/dataSettings.ts';

export const SIZE = { width: 64, height: 48 };
export const SETTINGS: RenderSettings = { ...DATA_SETTINGS, speedOfLight: 1 };

/**
 * Bodies of proper acceleration `a` towards +z that turn at z = −3: a point at z₀ is seen by observers at z + t > z₀ − 1/a. Seen from the world at t = −1, u along
 * z, at (x, 0, z), turned by `turn` about y.
 */
export interface HorizonCase {
  readonly name: string;
  readonly mesh: Mesh;
  readonly a: number;
  readonly x: number;
  readonly z: number;
  readonly u: number;
  readonly turn: number;
  /** Fewest pixels that show it; 0: none do. */
  readonly atLeast: number;
}

const ball = sphere(1);
/** In the second and third the centre, and a row of vertices, is on the horizon to the last bit. */
export const CASES: readonly HorizonCase[] = [
  { name: 'a ball, half of it behind', mesh: ball, a: 0.5, x: 3, z: -4, u: 0, turn: 2.4, atLeast: 50 },
  { name: 'a ball, from within', mesh: ball, a: 1, x: 0.25, z: -3, u: 0, turn: 3.1, atLeast: 0 },
  { name: 'a ball, from within, flying', mesh: ball, a: 1, x: 0.25, z: -3, u: 0.75, turn: 3.1, atLeast: 0 },
  { name: 'a box, most of it behind', mesh: box([2, 2, 2]), a: 1, x: 2, z: -3, u: 0, turn: 2.4, atLeast: 1000 },
];

export const sceneOf = ({ mesh, a }: HorizonCase): Scene =>
  makeScene({
    name: 'horizon',
    objects: [
      makeObject({
        path: '/body',
        mesh,
        motion: {
          kind: 'hyperbolic',
          pose: { position: [0, 0, -3], orientation: IDENTITY },
          properAcceleration: [0, 0, a],
          t0: 0,
        },
      }),
    ],
  });

export const viewOf = ({ x, z, u, turn }: HorizonCase): ViewPoint => ({
  t: -1,
  position: [x, 0, z],
  u: [0, 0, u],
  orientation: fromAxisAngle([0, 1, 0], turn),
  lens: perspective(1.2),
});

/** Objects and Doppler factors by the rasterizer. */
export async function drawHorizon(renderer: RasterRenderer, name: string, pump: () => void) {
  const horizonCase = CASES.find((each) => each.name === name)!;
  renderer.setSize(SIZE.width, SIZE.height);
  await renderer.setScene(sceneOf(horizonCase));
  pump();
  renderer.render([viewOf(horizonCase)], SETTINGS, 1);
  const read = async (aov: 'object' | 'doppler'): Promise<number[]> => Array.from(await renderer.readAov(aov));
  return { object: await read('object'), doppler: await read('doppler') };
}
