import { build } from './build.ts';
import { painted, seen } from './simulated.ts';

const ABOUT = {
  title: 'Hanging cloth',
  lookFor:
    'A cloth of 625 masses and their springs is let go level, held at two corners, where light goes at 10 m/s. Its free edge swings through at half of that: blue while it comes, red while it goes, and always seen where it was. Nothing in it reaches c, however long it falls: its momentum is what the forces change. Set the view to Simultaneity to see where it is.',
};

/** [m/s] */
const C = 10;

/** A level cloth that is let go, held at the two corners of its far edge. */
export const hangingCloth = () =>
  build(ABOUT, {
    sheet: { type: 'grid', set: { name: 'Cloth', width: 2, length: 2, columns: 24, rows: 24 } },
    silk: painted('sheet.geometry', [0.78, 0.72, 0.62], { roughness: 0.7 }),
    hung: { type: 'transform', set: { position: [0, 2.5, 0] }, from: { geometry: 'silk.geometry' } },
    cloth: {
      type: 'mass-spring',
      set: { structural: 200, shear: 100, bending: 5, pins: 'points', pinned: '600, 624' },
      from: { geometry: 'hung.geometry' },
    },
    weight: { type: 'field', set: { drag: 0.1 } },
    swing: {
      type: 'simulate',
      set: { speedOfLight: C, duration: 6, method: 'leapfrog', step: 0.0004 },
      from: { matter: ['cloth.matter', 'weight.matter'] },
    },
    post: { type: 'cylinder', set: { name: 'Post', radius: 0.035, height: 2.55 } },
    posts: {
      type: 'instances',
      set: { countX: 2, countZ: 1, spacing: [2.07, 0, 0] },
      from: { geometry: 'post.geometry' },
    },
    standing: { type: 'transform', set: { position: [0, 1.275, -1.03] }, from: { geometry: 'posts.geometry' } },
    wood: painted('standing.geometry', [0.25, 0.14, 0.07]),
    ...seen(['swing.geometry', 'wood.geometry'], {
      eye: [3.4, 1.9, 4.6],
      target: [0, 1.35, -0.2],
      to: 6,
      openAt: 0.9,
    }),
  });
