import { NodeRefusal } from '../../graph/nodeType.ts';
import { vectorParam, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { ColliderMatter } from './matter.ts';
import { chargeParam, massParam, penaltyParam, quantityParam, splitByPath } from './params.ts';

const FREE = { param: 'free', is: true } as const;
const HELD = { param: 'rods', is: ['pivot', 'chain'] } as const;

/** Rigid obstacles: floors, boxes, spheres; spheres may be dynamic. */
export const colliderNode = defineNode({
  id: 'collider',
  title: 'node.collider',
  help: 'node.collider.help',
  category: 'dynamics',
  params: {
    which: whichParam,
    shape: {
      kind: 'choice',
      title: 'param.solidShape',
      help: 'param.solidShape.help',
      default: 'ball',
      options: [
        { value: 'plane', title: 'solid.plane' },
        { value: 'box', title: 'node.box' },
        { value: 'ball', title: 'solid.ball' },
      ],
    },
    stiffness: penaltyParam,
    scale: {
      ...quantityParam({
        title: 'param.contactScale',
        help: 'param.contactScale.help',
        unit: '×',
        default: 1.1,
        min: 0.01,
      }),
      max: 100,
      onlyWhen: { param: 'shape', is: 'ball' },
    },
    margin: {
      ...quantityParam({ title: 'param.margin', help: 'param.margin.help', unit: 'm', default: 0.01 }),
      onlyWhen: { param: 'shape', is: ['plane', 'box'] },
    },
    free: {
      kind: 'boolean',
      title: 'param.free',
      help: 'param.free.help',
      default: false,
      onlyWhen: { param: 'shape', is: 'ball' },
    },
    mass: { ...massParam, onlyWhen: FREE },
    velocity: { ...vectorParam('param.startVelocity', [0, 0, 0], 'm/s'), onlyWhen: FREE },
    charge: { ...chargeParam, onlyWhen: { param: 'shape', is: 'ball' } },
    rods: {
      kind: 'choice',
      title: 'param.rods',
      help: 'param.rods.help',
      default: 'none',
      options: [
        { value: 'none', title: 'rods.none' },
        { value: 'pivot', title: 'rods.pivot' },
        { value: 'chain', title: 'rods.chain' },
      ],
      onlyWhen: FREE,
    },
    pivot: { ...vectorParam('param.pivot', [0, 1, 0], 'm'), help: 'param.pivot.help', onlyWhen: HELD },
    rodStiffness: {
      ...quantityParam({ title: 'param.rodStiffness', unit: 'N/m', default: 100_000, min: 1e-6, step: 1 }),
      onlyWhen: HELD,
    },
    thickness: {
      ...quantityParam({ title: 'param.rodThickness', help: 'param.rodThickness.help', unit: 'm', default: 0.02 }),
      onlyWhen: HELD,
    },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { matter: { type: 'matter' }, rest: { type: 'geometry', title: 'socket.rest' } },
  evaluate({ geometry }, params, { node }) {
    const { shape, stiffness, scale, margin, mass, velocity, charge } = params;
    const { chosen, rest } = splitByPath(geometry, params.which, node, params.free ? 'rest' : 'rigid');
    if (params.free && shape !== 'ball') {
      const message = 'only balls can be free; choose the shape Ball, or turn Free off';
      const remedy = { node, param: 'free', value: false };
      throw new NodeRefusal({ severity: 'error', code: 'collider.free', place: `${node}.free`, message, remedy });
    }
    const rods = rodsOf(params);
    const free = { mass, velocity, ...(rods && { rods }) };
    const matter: ColliderMatter = {
      ...{ kind: 'solid', node, scene: chosen, shape: shape as 'ball', stiffness, scale, margin, charge },
      ...(params.free && { free }),
    };
    return { matter, rest };
  },
});

interface RodParams {
  readonly rods: string;
  readonly pivot: readonly [number, number, number];
  readonly rodStiffness: number;
  readonly thickness: number;
}

function rodsOf({ rods, pivot, rodStiffness, thickness }: RodParams) {
  return rods === 'none' ? undefined : { to: rods as 'pivot', pivot, stiffness: rodStiffness, thickness };
}
