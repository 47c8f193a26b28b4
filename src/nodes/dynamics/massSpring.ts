import type { Vec3 } from '../../math/vec3.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { nodeRefusal, vectorParam, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { PinSelection } from './matter.ts';
import { chargeParam, massParam, quantityParam, splitByPath } from './params.ts';

const stiffnessParam = (title: LocalizedText, help: LocalizedText, value = 1000) =>
  quantityParam({ title, help, unit: 'N/m', default: value, step: 1 });
const BOX = { param: 'pins', is: 'box' } as const;

/** Objects as mass–spring nets: cloth and elastic solids. */
export const massSpringNode = defineNode({
  id: 'mass-spring',
  title: msg`Mass spring`,
  help: msg`Objects as mass–spring nets: each point has a share of the mass, and springs run along edges, across faces and to second neighbours. For cloth and elastic solids. Coincident points are merged.`,
  category: 'dynamics',
  params: {
    which: whichParam,
    mass: massParam,
    structural: stiffnessParam(msg`Along edges`, msg`Stiffness of these springs; 0: none.`),
    shear: stiffnessParam(msg`Across faces`, msg`Along the diagonals of quads.`),
    bending: stiffnessParam(msg`Against bending`, msg`From each point to its second neighbours.`),
    filling: stiffnessParam(
      msg`To the centre`,
      msg`From each point to the centre of its object: hollow objects keep their shape.`,
      0,
    ),
    tension: quantityParam({
      title: msg`Rest length`,
      help: msg`As a fraction of the initial length of the springs: below 1 they are under tension.`,
      unit: '×',
      default: 1,
      min: 0.01,
      max: 100,
      step: 0.01,
    }),
    pins: {
      kind: 'choice',
      title: msg`Pinned points`,
      help: msg`Points that stay in place or, if the object is animated, follow its animation.`,
      default: 'none',
      options: [
        { value: 'none', title: msg`None` },
        { value: 'corners', title: msg`Upper corners` },
        { value: 'top', title: msg`Top` },
        { value: 'box', title: msg`Points in a box` },
        { value: 'points', title: msg`Points by number` },
      ],
    },
    pinCenter: { ...vectorParam(msg`Centre`, [0, 0, 0], 'm'), onlyWhen: BOX },
    pinSize: { ...vectorParam(msg`Size`, [1, 1, 1], 'm'), onlyWhen: BOX },
    pinned: {
      kind: 'text',
      title: msg`Points`,
      help: msg`Vertex numbers starting at 0: 0, 9, 20-29.`,
      default: '0',
      onlyWhen: { param: 'pins', is: 'points' },
    },
    velocity: vectorParam(msg`Initial velocity`, [0, 0, 0], 'm/s'),
    spin: vectorParam(msg`Initial spin`, [0, 0, 0], 'rad/s'),
    charge: chargeParam,
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { matter: { type: 'matter' }, rest: { type: 'geometry', title: msg`The rest` } },
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
      const message = msg`"${part.slice(0, 80)}" is no number of a point, nor two with - between them; write them like 0, 9, 20-29`;
      throw nodeRefusal('pins.numbers', `${node}.pinned`, message, { node, param: 'pinned', value: '0' });
    }
    return Array.from({ length: count }, (_, i) => Number(from) + i);
  });
}
