import { build } from './buildProject.ts';
import { simulationScene, withMaterial } from './simulationScene.ts';

const ABOUT = {
  title: 'Elastic ball against rigid ball',
  lookFor:
    'A ball of springs at 0.6 c meets a rigid one of the same mass that is free. Momentum passes to the last digit, but the springs keep some of the energy: the red ball wobbles from then on, and the blue one leaves at 0.57 c. Between two rigid balls all of it would have passed.',
};

/** [m/s] */
const C = 10;

/** A collision of an elastic sphere with a rigid one. */
export const impact = () =>
  build(ABOUT, {
    soft: { type: 'sphere', set: { name: 'Elastic', radius: 0.5, segments: 32, rings: 16 } },
    rubber: withMaterial('soft.geometry', [0.8, 0.1, 0.05], { roughness: 0.45 }),
    coming: { type: 'transform', set: { position: [-2.2, 0.9, 0] }, from: { geometry: 'rubber.geometry' } },
    elastic: {
      type: 'mass-spring',
      set: { structural: 120, shear: 40, bending: 25, filling: 8, velocity: [0.6 * C, 0, 0] },
      from: { geometry: 'coming.geometry' },
    },
    hard: { type: 'sphere', set: { name: 'Rigid', radius: 0.4, segments: 64, rings: 32 } },
    steel: withMaterial('hard.geometry', [0.08, 0.2, 0.75], { roughness: 0.3 }),
    waiting: { type: 'transform', set: { position: [0.2, 0.9, 0] }, from: { geometry: 'steel.geometry' } },
    rigid: {
      type: 'collider',
      set: { shape: 'ball', free: true, stiffness: 200, scale: 1.1 },
      from: { geometry: 'waiting.geometry' },
    },
    meeting: {
      type: 'simulate',
      set: { speedOfLight: C, duration: 1.6, rate: 240, method: 'leapfrog', step: 0.0003 },
      from: { matter: ['elastic.matter', 'rigid.matter'] },
    },
    ...simulationScene(['meeting.geometry'], {
      set: 'laboratory.usda',
      eye: [0.1, 1.4, 4.2],
      target: [0.1, 0.85, 0],
      to: 1.6,
      openAt: 0.72,
    }),
  });
