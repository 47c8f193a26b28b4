import type { Vec3 } from '../../math/vec3.ts';
import { nodeRefusal, vectorParam, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { PinSelection } from './matter.ts';
import { chargeParam, massParam, quantityParam, splitByPath } from './params.ts';

const stiffnessParam = (title: string, help: string, value = 1000) =>
  quantityParam({ title, help, unit: 'N/m', default: value, step: 1 });
const BOX = { param: 'pins', is: 'box' } as const;

/** Objects as mass–spring nets: cloth and elastic solids. */
export const massSpringNode = defineNode({
  id: 'mass-spring',
  title: 'node.massSpring',
  help: 'node.massSpring.help',
  category: 'dynamics',
  params: {
    which: whichParam,
    mass: massParam,
    structural: stiffnessParam('param.structural', 'param.structural.help'),
    shear: stiffnessParam('param.shear', 'param.shear.help'),
    bending: stiffnessParam('param.bending', 'param.bending.help'),
    filling: stiffnessParam('param.filling', 'param.filling.help', 0),
    tension: quantityParam({
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
    pinCenter: { ...vectorParam('param.center', [0, 0, 0], 'm'), onlyWhen: BOX },
    pinSize: { ...vectorParam('param.pinSize', [1, 1, 1], 'm'), onlyWhen: BOX },
    pinned: {
      kind: 'text',
      title: 'param.pinned',
      help: 'param.pinned.help',
      default: '0',
      onlyWhen: { param: 'pins', is: 'points' },
    },
    velocity: vectorParam('param.startVelocity', [0, 0, 0], 'm/s'),
    spin: vectorParam('param.startSpin', [0, 0, 0], 'rad/s'),
    charge: chargeParam,
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { matter: { type: 'matter' }, rest: { type: 'geometry', title: 'socket.rest' } },
  evaluate({ geometry }, params, { node }) {
    const { structural, shear, bending, filling, tension, mass, velocity, spin, charge } = params;
    const { chosen, rest } = splitByPath(geometry, params.which, node, 'rigid');
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

function pinsOf({ pins, pinCenter, pinSize, pinned }: PinParams, node: string): PinSelection {
  if (pins === 'box') return { kind: 'box', center: pinCenter, size: pinSize };
  if (pins === 'points') return { kind: 'points', vertices: parseVertices(pinned, node) };
  return { kind: pins as 'none' };
}

const MAX_PINS = 1_000_000;

/** `0, 9, 20-29` */
function parseVertices(text: string, node: string): number[] {
  const parts = text.split(/[\s,;]+/).filter((part) => part !== '');
  return parts.flatMap((part) => {
    const [, from, to = from] = /^(\d{1,9})(?:-(\d{1,9}))?$/.exec(part) ?? [];
    const count = Number(to) - Number(from) + 1;
    if (!(count >= 1 && count <= MAX_PINS)) {
      const message = `"${part.slice(0, 80)}" is no number of a point, nor two with - between them; write them like 0, 9, 20-29`;
      throw nodeRefusal('pins.numbers', `${node}.pinned`, message, { node, param: 'pinned', value: '0' });
    }
    return Array.from({ length: count }, (_, i) => Number(from) + i);
  });
}
