import { grid } from '../../src/scene/mesh/primitives.ts';
import { build } from './buildProject.ts';
import { simulationScene, withMaterial } from './simulationScene.ts';

const ABOUT = {
  title: 'Hanging cloth',
  lookFor:
    'A cloth of 625 masses with springs between them is let go level, held at two corners, where light goes at 10 m/s. When its hem cracks like a whip a point comes to 0.86 c; none reaches c, for what forces change is its momentum. It is bright while it comes and dark while it goes, and you see each part of it where it was. Set the view to Simultaneity to see where it is.',
};

/** [m/s] */
const C = 10;
const SIDE = 2;
const CELLS = 24;

/** Vertex indices of both ends of a square grid's far edge. */
export function farCorners(side: number, cells: number): string {
  const { positions } = grid(side, side, cells, cells, 'Y');
  const at = (x: number): number =>
    Array.from({ length: positions.length / 3 }, (_, v) => v).find(
      (v) => positions[3 * v] === x && positions[3 * v + 2] === -side / 2,
    )!;
  return `${at(-side / 2)}, ${at(side / 2)}`;
}

/** A cloth that is released level, pinned at the two corners of its far edge. */
export const hangingCloth = () =>
  build(ABOUT, {
    sheet: { type: 'grid', set: { name: 'Cloth', width: SIDE, length: SIDE, columns: CELLS, rows: CELLS } },
    silk: withMaterial('sheet.geometry', [0.85, 0.3, 0.08], { roughness: 0.6 }),
    hung: {
      type: 'transform',
      set: { position: [0, 2.6, -2], rotation: [0, 180, 0] },
      from: { geometry: 'silk.geometry' },
    },
    cloth: {
      type: 'mass-spring',
      set: { structural: 200, shear: 100, bending: 10, pins: 'points', pinned: farCorners(SIDE, CELLS) },
      from: { geometry: 'hung.geometry' },
    },
    weight: { type: 'field', set: { drag: 0.25 } },
    swing: {
      type: 'simulate',
      set: { speedOfLight: C, duration: 6, rate: 48, method: 'leapfrog', step: 0.0004 },
      from: { matter: ['cloth.matter', 'weight.matter'] },
    },
    post: { type: 'cylinder', set: { name: 'Post', radius: 0.035, height: 2.65 } },
    posts: {
      type: 'instances',
      set: { countX: 2, countZ: 1, spacing: [2.07, 0, 0] },
      from: { geometry: 'post.geometry' },
    },
    standing: { type: 'transform', set: { position: [0, 1.325, -1] }, from: { geometry: 'posts.geometry' } },
    wood: withMaterial('standing.geometry', [0.3, 0.18, 0.09]),
    ...simulationScene(['swing.geometry', 'wood.geometry'], {
      set: 'terrace.usdc',
      eye: [2.4, 1.6, 3.4],
      target: [0, 1.5, -1],
      to: 6,
      openAt: 1.25,
    }),
  });
