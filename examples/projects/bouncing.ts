import { build } from './build.ts';
import { painted, seen, solidGround } from './simulated.ts';

const ABOUT = {
  title: 'Bouncing lattice',
  lookFor:
    'A lattice of elastic bars falls on a corner and springs back, with light at 10 m/s. The blow runs through it as a wave; what is above hears of it later and is still falling. Straight bars are seen bent where they move fast across your sight, for light from their far ends left earlier.',
};

/** A lattice that falls on a floor and springs back. */
export const bouncing = () =>
  build(ABOUT, {
    bars: { type: 'lattice', set: { name: 'Lattice', x: 3, y: 3, z: 3, cell: 0.36, thickness: 0.07 } },
    brass: painted('bars.geometry', [0.75, 0.5, 0.12], { roughness: 0.4 }),
    high: {
      type: 'transform',
      set: { position: [0, 2.3, 0], rotation: [38, 0, 32] },
      from: { geometry: 'brass.geometry' },
    },
    lattice: {
      type: 'mass-spring',
      set: { structural: 800, shear: 400, bending: 0, velocity: [0.3, -3, 0], spin: [0, 1.2, 0] },
      from: { geometry: 'high.geometry' },
    },
    ...solidGround({ stiffness: 300, margin: 0.02 }),
    weight: { type: 'field', set: { drag: 0.15 } },
    fall: {
      type: 'simulate',
      set: { duration: 3, rate: 48, method: 'leapfrog', step: 0.0003 },
      from: { matter: ['lattice.matter', 'ground.matter', 'weight.matter'] },
    },
    ...seen(['fall.geometry'], { eye: [1.6, 1.5, 4.2], target: [0.1, 1, 0], to: 3, openAt: 0.8, ground: {} }),
  });
