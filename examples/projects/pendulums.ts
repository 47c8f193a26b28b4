import { build } from './buildProject.ts';
import { type NodeSketches, simulationScene, withMaterial } from './simulationScene.ts';

const ABOUT = {
  title: 'Pendulums at c = 1, 10 and 100',
  lookFor:
    'Three pendulums of a metre, let go level, in worlds where the speed of light is 1, 10 and 100 m/s. Those at 10 and 100 swing nearly as Newton would have it, in 2.4 s. The one at 1 m/s goes at almost 1 m/s nearly all of the way: it takes 6.7 s to come back. You see them by light of 10 m/s.',
};

const COLORS = [
  [0.8, 0.12, 0.06],
  [0.06, 0.42, 0.16],
  [0.08, 0.3, 0.75],
] as const;
/** Length of the rods [m]. */
const LENGTH = 1;
const HEIGHT = 1.5;
/** Distance between pendulums [m]. */
const PITCH = 1.25;

/** A pendulum that is released level, with its own speed of light and a label below. */
function pendulum(c: number, i: number): NodeSketches {
  const z = PITCH * (i - 1);
  return {
    [`bob${c}`]: { type: 'sphere', set: { name: `Bob${c}`, radius: 0.16, segments: 48, rings: 24 } },
    [`paint${c}`]: withMaterial(`bob${c}.geometry`, COLORS[i], { roughness: 0.35 }),
    [`place${c}`]: {
      type: 'transform',
      set: { position: [LENGTH, HEIGHT, z] },
      from: { geometry: `paint${c}.geometry` },
    },
    [`held${c}`]: {
      type: 'collider',
      set: { free: true, rods: 'pivot', pivot: [-LENGTH, 0, 0], rodStiffness: 20000, thickness: 0.03 },
      from: { geometry: `place${c}.geometry` },
    },
    [`swing${c}`]: {
      type: 'simulate',
      set: { speedOfLight: c, duration: 14, rate: 30, method: 'yoshida-4', step: 0.001 },
      from: { matter: [`held${c}.matter`, 'weight.matter'] },
    },
    [`name${c}`]: { type: 'solid-text', set: { name: `Name${c}`, text: `c = ${c}`, size: 0.15, depth: 0.05 } },
    [`sign${c}`]: withMaterial(`name${c}.geometry`, COLORS[i]),
    [`label${c}`]: {
      type: 'transform',
      set: { position: [0, HEIGHT + 0.1, z], rotation: [0, 43, 0] },
      from: { geometry: `sign${c}.geometry` },
    },
  };
}

const SPEEDS = [1, 10, 100];

/** Pendulums at several speeds of light. */
export const pendulums = () => {
  const picture = simulationScene([...SPEEDS.flatMap((c) => [`swing${c}.geometry`, `label${c}.geometry`])], {
    set: 'classroom.usdc',
    eye: [3.3, 1.6, 3.7],
    target: [0.1, 0.95, 0.1],
    to: 14,
    openAt: 2.2,
  });
  return build(ABOUT, {
    weight: { type: 'field' },
    ...Object.assign({}, ...SPEEDS.map(pendulum)),
    ...picture,
    console: { ...picture.console!, set: { speedOfLight: 10 } },
  });
};
