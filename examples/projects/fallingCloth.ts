import { build } from './buildProject.ts';
import { simulationScene, withMaterial } from './simulationScene.ts';

const ABOUT = {
  title: 'Cloth on a ball',
  lookFor:
    'A cloth falls on a ball that stands fast, with light at 10 m/s. Its middle is stopped, its corners fall on and swing under the ball. Ball and floor push back what gets into them, the harder the deeper it is, so that a fast blow goes in a little. The air takes energy, nothing else does: open the energy panel to see where it goes.',
};

/** A cloth that falls on a fixed sphere above a floor. */
export const fallingCloth = () =>
  build(ABOUT, {
    sheet: { type: 'grid', set: { name: 'Cloth', width: 2.4, length: 2.4, columns: 28, rows: 28 } },
    linen: withMaterial('sheet.geometry', [0.82, 0.76, 0.66], { roughness: 0.7 }),
    above: {
      type: 'transform',
      set: { position: [0, 2.2, 0], rotation: [0, 30, 0] },
      from: { geometry: 'linen.geometry' },
    },
    cloth: {
      type: 'mass-spring',
      set: { mass: 3, structural: 100, shear: 60, bending: 6 },
      from: { geometry: 'above.geometry' },
    },
    round: { type: 'sphere', set: { name: 'Ball', radius: 0.6, segments: 96, rings: 48 } },
    gold: { type: 'material', set: { preset: 'gold' }, from: { geometry: 'round.geometry' } },
    lying: { type: 'transform', set: { position: [0, 0.9, 0] }, from: { geometry: 'gold.geometry' } },
    ball: {
      type: 'collider',
      set: { shape: 'ball', scale: 1.07, stiffness: 400 },
      from: { geometry: 'lying.geometry' },
    },
    weight: { type: 'field', set: { drag: 3 } },
    fall: {
      type: 'simulate',
      // Contact distance of about a cell between folds.
      set: { duration: 4, rate: 120, method: 'leapfrog', step: 0.0006, reach: 0.08, stiffness: 400 },
      from: { matter: ['cloth.matter', 'ball.matter', 'ground.matter', 'weight.matter'] },
    },
    kept: { type: 'cache', from: { geometry: 'fall.geometry' } },
    ...simulationScene(['kept.geometry'], {
      set: 'studio.usdc',
      floor: { which: '/World/Floor', stiffness: 400, margin: 0.05 },
      eye: [1.1, 1.9, 3.9],
      target: [0, 0.95, 0],
      to: 4,
      openAt: 1.2,
    }),
  });
