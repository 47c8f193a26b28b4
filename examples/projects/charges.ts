import { build } from './build.ts';
import { painted, type Sketches, seen } from './simulated.ts';

const ABOUT = {
  title: 'Two charges',
  lookFor:
    'A positive and a negative charge of one mass draw each other round, at up to 0.6 c. Newton would have them on one ellipse for ever; here their momentum grows faster than their speed, which turns the ellipse by 45° each time round: they draw a rosette. Both touch the ring when they are farthest apart. Each is seen where it was, so that they do not stand opposite each other. The force acts at once, without the waves that real charges would lose.',
};

/** Each [C], and how fast each is when they are farthest apart [m/s]. */
const CHARGE = 9.37e-5;
const SPEED = 2.6;
/** From the middle, then [m]. */
const AWAY = 1.6;

const charge = (name: string, color: readonly [number, number, number], side: 1 | -1): Sketches => ({
  [`${name}Ball`]: { type: 'sphere', set: { name, radius: 0.16, segments: 48, rings: 24 } },
  [`${name}Paint`]: painted(`${name}Ball.geometry`, color, { roughness: 0.4 }),
  [`${name}At`]: {
    type: 'transform',
    set: { position: [side * AWAY, 0.5, 0] },
    from: { geometry: `${name}Paint.geometry` },
  },
  [name]: {
    type: 'collider',
    set: { free: true, scale: 0.01, charge: side * CHARGE, velocity: [0, 0, -side * SPEED] },
    from: { geometry: `${name}At.geometry` },
  },
});

/** Two opposite charges round each other. */
export const charges = () =>
  build(ABOUT, {
    ...charge('Positive', [0.8, 0.04, 0.02], 1),
    ...charge('Negative', [0.02, 0.1, 0.75], -1),
    field: { type: 'field', set: { gravity: [0, 0, 0], coulomb: true } },
    dance: {
      type: 'simulate',
      set: { duration: 12, rate: 60, method: 'yoshida-6', step: 0.0005 },
      from: { matter: ['Positive.matter', 'Negative.matter', 'field.matter'] },
    },
    circle: { type: 'torus', set: { name: 'Circle', ring: AWAY, tube: 0.008, segments: 160, rings: 8 } },
    line: painted('circle.geometry', [0.9, 0.85, 0.7], { glow: 0.1 }),
    round: { type: 'transform', set: { position: [0, 0.5, 0] }, from: { geometry: 'line.geometry' } },
    floor: { type: 'grid', set: { name: 'Floor', width: 40, length: 40, columns: 40, rows: 40 } },
    night: painted('floor.geometry', [0.2, 0.21, 0.24], { roughness: 0.8 }),
    ...seen(['dance.geometry', 'round.geometry', 'night.geometry'], {
      eye: [0, 3.3, 3.3],
      target: [0, 0.35, 0.1],
      to: 12,
      openAt: 0.9,
      ground: {},
    }),
  });
