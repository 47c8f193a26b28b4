import { build } from './buildProject.ts';
import { type NodeSketches, simulationScene, withMaterial } from './simulationScene.ts';

const ABOUT = {
  title: 'Two charges',
  lookFor:
    'A positive and a negative charge of one mass draw each other round, at up to 0.6 c. Newton would have them on one ellipse for ever; here their momentum grows faster than their speed, which turns the ellipse by 45° each time round: they draw a rosette. The gold line on the table is the way that Sommerfeld found for it by formula, and the balls keep to it; they touch the blue ring when they are farthest apart. Each is seen where it was, so that they do not stand opposite each other. The force acts at once, without the waves that real charges would lose.',
};

/** [m/s] */
export const C = 10;
/** Charge of each [C], and their speed at the largest distance [m/s]. */
export const CHARGE = 9.37e-5;
export const SPEED = 2.6;
/** Distance of each from the centre at that time [m]. */
export const AWAY = 1.6;
/** Height above the table [m]. */
export const HEIGHT = 0.22;

const charge = (name: string, color: readonly [number, number, number], side: 1 | -1): NodeSketches => ({
  [`${name}Ball`]: { type: 'sphere', set: { name, radius: 0.16, segments: 48, rings: 24 } },
  [`${name}Paint`]: withMaterial(`${name}Ball.geometry`, color, { roughness: 0.4 }),
  [`${name}At`]: {
    type: 'transform',
    set: { position: [side * AWAY, HEIGHT, 0] },
    from: { geometry: `${name}Paint.geometry` },
  },
  [name]: {
    type: 'collider',
    set: { free: true, scale: 0.01, charge: side * CHARGE, velocity: [0, 0, -side * SPEED] },
    from: { geometry: `${name}At.geometry` },
  },
});

/** Two opposite charges that orbit each other. */
export const charges = () =>
  build(ABOUT, {
    ...charge('Positive', [0.8, 0.04, 0.02], 1),
    ...charge('Negative', [0.02, 0.1, 0.75], -1),
    field: { type: 'field', set: { gravity: [0, 0, 0], coulomb: true } },
    dance: {
      type: 'simulate',
      set: { speedOfLight: C, duration: 14.5, rate: 60, method: 'yoshida-6', step: 0.0005 },
      from: { matter: ['Positive.matter', 'Negative.matter', 'field.matter'] },
    },
    stars: { type: 'sky', set: { name: 'Stars', sky: 'stars', brightness: 40 } },
    ...simulationScene(['dance.geometry'], {
      set: 'planetarium.usdc',
      eye: [0, 4.1, 4.7],
      target: [0, 0, 0.2],
      to: 14.5,
      openAt: 2.3,
      lights: ['stars.lights'],
    }),
  });
