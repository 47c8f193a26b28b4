import { build } from './buildProject.ts';
import { simulationScene, withMaterial } from './simulationScene.ts';

const ABOUT = {
  title: 'Bouncing lattice',
  lookFor:
    'A lattice of elastic bars falls on a corner and springs back, with light at 10 m/s. The blow runs through it as a wave; what is above hears of it later and is still falling. Straight bars are seen bent where they move fast across your sight, for light from their far ends left earlier.',
};

/** A lattice that falls on a floor and springs back. */
export const bouncing = () =>
  build(ABOUT, {
    bars: { type: 'lattice', set: { name: 'Lattice', x: 2, y: 2, z: 2, cell: 0.5, thickness: 0.14 } },
    brass: withMaterial('bars.geometry', [0.75, 0.5, 0.12], { roughness: 0.4 }),
    high: {
      type: 'transform',
      set: { position: [0, 1.9, 0], rotation: [38, 0, 32] },
      from: { geometry: 'brass.geometry' },
    },
    lattice: {
      type: 'mass-spring',
      set: {
        ...{ mass: 30, structural: 2500, shear: 1500, bending: 1500, filling: 100 },
        ...{ velocity: [0.3, -1, 0], spin: [0, 1.2, 0] },
      },
      from: { geometry: 'high.geometry' },
    },
    weight: { type: 'field', set: { drag: 0.15 } },
    fall: {
      type: 'simulate',
      set: { duration: 3, rate: 120, method: 'leapfrog', step: 0.0003 },
      from: { matter: ['lattice.matter', 'ground.matter', 'weight.matter'] },
    },
    ...simulationScene(['fall.geometry'], {
      set: 'gym.usdc',
      floor: { which: '/World/Mat', stiffness: 400, margin: 0.24 },
      eye: [1.6, 1.5, 4.4],
      target: [0.1, 0.9, 0],
      to: 3,
      openAt: 0.8,
    }),
  });
