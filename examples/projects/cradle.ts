import { build } from './buildProject.ts';
import { type NodeSketches, simulationScene, withMaterial } from './simulationScene.ts';

const ABOUT = {
  title: "Relativistic Newton's cradle",
  lookFor:
    'Five balls on rods of 3 m, with light at 10 m/s. The first one falls and meets the row at 0.47 c; the last one takes all of its momentum and swings out, the others hardly move. Equal masses hand their velocities on near c as they do at rest: momentum and energy leave them no other choice. The ball that comes towards you is brighter than the one that goes.',
};

const LENGTH = 3;
const RADIUS = 0.2;
/** Gap between neighbours, so that they touch one after the other. */
const GAP = 0.02;
const PIVOT = 3.5;
/** Deflection of the first ball. */
const ANGLE = (57 * Math.PI) / 180;
const PITCH = 2 * RADIUS + GAP;
const COUNT = 5;

const held = {
  type: 'collider',
  set: { free: true, rods: 'pivot', rodStiffness: 200_000, thickness: 0.035, stiffness: 1_000_000, scale: 1 },
} as const;

const balls: NodeSketches = {
  round: { type: 'sphere', set: { name: 'Ball', radius: RADIUS, segments: 64, rings: 32 } },
  steel: withMaterial('round.geometry', [0.62, 0.64, 0.68], { roughness: 0.25 }),
  row: {
    type: 'instances',
    set: { countX: COUNT - 1, countZ: 1, spacing: [PITCH, 0, 0] },
    from: { geometry: 'steel.geometry' },
  },
  hanging: {
    type: 'transform',
    set: { position: [PITCH / 2, PIVOT - LENGTH, 0] },
    from: { geometry: 'row.geometry' },
  },
  others: { ...held, set: { ...held.set, pivot: [0, LENGTH, 0] }, from: { geometry: 'hanging.geometry' } },
  apple: { type: 'sphere', set: { name: 'First', radius: RADIUS, segments: 64, rings: 32 } },
  copper: withMaterial('apple.geometry', [0.85, 0.25, 0.1], { roughness: 0.3 }),
  raised: {
    type: 'transform',
    set: {
      position: [(-(COUNT - 1) / 2) * PITCH - LENGTH * Math.sin(ANGLE), PIVOT - LENGTH * Math.cos(ANGLE), 0],
    },
    from: { geometry: 'copper.geometry' },
  },
  first: {
    ...held,
    set: { ...held.set, pivot: [LENGTH * Math.sin(ANGLE), LENGTH * Math.cos(ANGLE), 0] },
    from: { geometry: 'raised.geometry' },
  },
};

/** A row of balls on rods, of which the first is raised and released. */
export const cradle = () =>
  build(ABOUT, {
    ...balls,
    weight: { type: 'field' },
    swing: {
      type: 'simulate',
      set: { duration: 6, rate: 60, method: 'leapfrog', step: 0.0001 },
      from: { matter: ['first.matter', 'others.matter', 'weight.matter'] },
    },
    ...simulationScene(['swing.geometry'], {
      set: 'library.usdc',
      eye: [2, 1.7, 6.9],
      target: [0, 1.8, 0],
      to: 6,
      openAt: 2.1,
    }),
  });
