import type { Vec3 } from '../../math/vec3.ts';
import { defineNode } from '../define.ts';
import { refusal, vector, whichParam } from '../geometry/shared.ts';
import type { Pins } from './matter.ts';
import { amount, chargeParam, massParam, parted } from './shared.ts';

const stiffness = (title: string, help: string, value = 1000) =>
  amount({ title, help, unit: 'N/m', default: value, step: 1 });
const BOX = { param: 'pins', is: 'box' } as const;

/** Things as nets of masses and springs: cloth, and what is elastic. */
export const massSpringNode = defineNode({
  id: 'mass-spring',
  title: 'node.massSpring',
  help: 'node.massSpring.help',
  category: 'dynamics',
  params: {
    which: whichParam,
    mass: massParam,
    structural: stiffness('param.structural', 'param.structural.help'),
    shear: stiffness('param.shear', 'param.shear.help'),
    bending: stiffness('param.bending', 'param.bending.help'),
    filling: stiffness('param.filling', 'param.filling.help', 0),
    tension: amount({
      title: 'param.tension',
      help: 'param.tension.help',
      unit: '×',
      default: 1,
      min: 0.01,
      max: 100,
      step: 0.01,
    }),
    pins: {
      kind: 'choice',
      title: 'param.pins',
      help: 'param.pins.help',
      default: 'none',
      options: [
        { value: 'none', title: 'pins.none' },
        { value: 'corners', title: 'pins.corners' },
        { value: 'top', title: 'pins.top' },
        { value: 'box', title: 'pins.box' },
        { value: 'points', title: 'pins.points' },
      ],
    },
    pinCenter: { ...vector('param.center', [0, 0, 0], 'm'), onlyWhen: BOX },
    pinSize: { ...vector('param.pinSize', [1, 1, 1], 'm'), onlyWhen: BOX },
    pinned: {
      kind: 'text',
      title: 'param.pinned',
      help: 'param.pinned.help',
      default: '0',
      onlyWhen: { param: 'pins', is: 'points' },
    },
    velocity: vector('param.startVelocity', [0, 0, 0], 'm/s'),
    spin: vector('param.startSpin', [0, 0, 0], 'rad/s'),
    charge: chargeParam,
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { matter: { type: 'matter' }, rest: { type: 'geometry', title: 'socket.rest' } },
  evaluate({ geometry }, params, { node }) {
    const { structural, shear, bending, filling, tension, mass, velocity, spin, charge } = params;
    const { chosen, rest } = parted(geometry, params.which, node, 'rigid');
    const stiffness = { structural, shear, bending, filling };
    const pins = pinsOf(params, node);
    return {
      matter: { kind: 'net', node, scene: chosen, mass, stiffness, tension, pins, velocity, spin, charge },
      rest,
    };
  },
});

interface PinParams {
  readonly pins: string;
  readonly pinCenter: Vec3;
  readonly pinSize: Vec3;
  readonly pinned: string;
}

function pinsOf({ pins, pinCenter, pinSize, pinned }: PinParams, node: string): Pins {
  if (pins === 'box') return { kind: 'box', center: pinCenter, size: pinSize };
  if (pins === 'points') return { kind: 'points', vertices: verticesIn(pinned, node) };
  return { kind: pins as 'none' };
}

const MOST_PINS = 1_000_000;

/** `0, 9, 20-29` */
function verticesIn(text: string, node: string): number[] {
  const parts = text.split(/[\s,;]+/).filter((part) => part !== '');
  return parts.flatMap((part) => {
    const [, from, to = from] = /^(\d{1,9})(?:-(\d{1,9}))?$/.exec(part) ?? [];
    const count = Number(to) - Number(from) + 1;
    if (!(count >= 1 && count <= MOST_PINS)) {
      const message = `"${part.slice(0, 80)}" is no number of a point, nor two with - between them; write them like 0, 9, 20-29`;
      throw refusal('pins.numbers', `${node}.pinned`, message, { node, param: 'pinned', value: '0' });
    }
    return Array.from({ length: count }, (_, i) => Number(from) + i);
  });
}
