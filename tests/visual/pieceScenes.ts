import { IDENTITY } from '../../src/math/quat.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { makeObject, makeScene, restingAt } from '../../src/scene/defaults.ts';
import { box, grid, plane } from '../../src/scene/mesh/primitives.ts';
import type { Lifetime, Mesh, Motion, Scene, SceneObject } from '../../src/scene/types.ts';

/** [m/s] */
export const C = 10;
/** The observer's event. */
export const EYE: Vec3 = [0, 0, 0];
export const NOW = 1.6;

/** Distance of the wall [m], and its lives: as rings at the time NOW. */
export const WALL_DISTANCE = 10;
export const WALL_LIVES: readonly Lifetime[] = [
  { birth: 0.05, death: 0.25 },
  { birth: 0.4, death: 0.5 },
];
/** When each of three pieces begins; light of the last two boundaries is on its way through the picture. */
export const PIECE_STARTS = [Number.NEGATIVE_INFINITY, 0.85, 0.93] as const;

const lives = (path: string, mesh: Mesh, motion: Motion, all: readonly Lifetime[]): SceneObject[] =>
  all.map((lifetime, i) => ({
    ...makeObject({ path: `${path}/piece${i + 1}`, mesh, motion, lifetime }),
    pieceOf: path,
  }));

/** A sheet with ever more triangles, which moves with another velocity in each piece. */
function sheet(): SceneObject[] {
  const velocities: readonly Vec3[] = [
    [0, 0, 3],
    [0, -4, 0],
    [6, 0, 0],
  ];
  return velocities.map((velocity, k): SceneObject => {
    const mesh = grid(6, 4, 1 + 2 * k, 1 + k);
    const [birth, death] = [PIECE_STARTS[k], PIECE_STARTS[k + 1] ?? Number.POSITIVE_INFINITY];
    // Each moves on before and after its life, as what readers make of files.
    const [from, to] = [-2, 3];
    const at = (t: number): Float32Array =>
      mesh.positions.map((x, i) => x + velocity[i % 3] * (t - (k === 0 ? 0.8 : birth)));
    const motion: Motion = {
      kind: 'sampled-points',
      times: Float64Array.of(from, to),
      origin: [-2, 0, -6],
      points: [at(from), at(to)],
    };
    return {
      ...makeObject({ path: `/Sheet/piece${k + 1}`, mesh, motion, lifetime: { birth, death } }),
      pieceOf: '/Sheet',
    };
  });
}

/** What exists at several times: a wall that blinks, a box that blinks in flight, and a sheet of three pieces. */
export const PIECES: Scene = makeScene({
  name: 'pieces that take turns',
  objects: [
    makeObject({ path: '/Behind', mesh: plane(80, 60, 'Z'), motion: restingAt([0, 0, -14]) }),
    ...lives('/Wall', plane(60, 40, 'Z'), restingAt([0, 0, -WALL_DISTANCE]), WALL_LIVES),
    ...lives(
      '/Box',
      box([3, 1, 1]),
      { kind: 'uniform', pose: { position: [-4, -2, -6], orientation: IDENTITY }, velocity: [6, 0, 0] },
      [
        { birth: 0.5, death: 0.83 },
        { birth: 0.93, death: Number.POSITIVE_INFINITY },
      ],
    ),
    ...sheet(),
  ],
  hints: { speedOfLight: C },
});
