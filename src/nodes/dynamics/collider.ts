import { NodeRefusal } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { vectorParam, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { ColliderMatter } from './matter.ts';
import { chargeParam, massParam, penaltyParam, quantityParam, splitByPath } from './params.ts';

const FREE = { param: 'free', is: true } as const;
const HELD = { param: 'rods', is: ['pivot', 'chain'] } as const;

/** Rigid obstacles: floors, boxes, spheres; spheres may be dynamic. */
export const colliderNode = defineNode({
  id: 'collider',
  title: msg`Collider`,
  help: msg`Solids that nothing penetrates: infinite planes, boxes, and spheres, which can be free to be moved by contact. Animated objects keep their motion whatever they hit.`,
  category: 'dynamics',
  params: {
    which: whichParam,
    shape: {
      kind: 'choice',
      title: msg`Shape`,
      help: msg`A plane is solid behind its front.`,
      default: 'ball',
      options: [
        { value: 'plane', title: msg`Plane` },
        { value: 'box', title: msg`Box` },
        { value: 'ball', title: msg`Ball` },
      ],
    },
    stiffness: penaltyParam,
    scale: {
      ...quantityParam({
        title: msg`Contact scale`,
        help: msg`Size in contact relative to the displayed size.`,
        unit: '×',
        default: 1.1,
        min: 0.01,
      }),
      max: 100,
      onlyWhen: { param: 'shape', is: 'ball' },
    },
    margin: {
      ...quantityParam({ title: msg`Margin`, help: msg`Distance at which contact begins.`, unit: 'm', default: 0.01 }),
      onlyWhen: { param: 'shape', is: ['plane', 'box'] },
    },
    free: {
      kind: 'boolean',
      title: msg`Free`,
      help: msg`Moved by contact; otherwise it is fixed, or keeps its animation.`,
      default: false,
      onlyWhen: { param: 'shape', is: 'ball' },
    },
    mass: { ...massParam, onlyWhen: FREE },
    velocity: { ...vectorParam(msg`Initial velocity`, [0, 0, 0], 'm/s'), onlyWhen: FREE },
    charge: { ...chargeParam, onlyWhen: { param: 'shape', is: 'ball' } },
    rods: {
      kind: 'choice',
      title: msg`Held by rods`,
      help: msg`Thin springs as stiff as rods: pendulums, or chains of the objects in order.`,
      default: 'none',
      options: [
        { value: 'none', title: msg`None` },
        { value: 'pivot', title: msg`Each from its own pivot` },
        { value: 'chain', title: msg`Each from the one before` },
      ],
      onlyWhen: FREE,
    },
    pivot: {
      ...vectorParam(msg`Pivot`, [0, 1, 0], 'm'),
      help: msg`Position of the fixed end relative to the sphere’s centre.`,
      onlyWhen: HELD,
    },
    rodStiffness: {
      ...quantityParam({ title: msg`Stiffness of rods`, unit: 'N/m', default: 100_000, min: 1e-6, step: 1 }),
      onlyWhen: HELD,
    },
    thickness: {
      ...quantityParam({
        title: msg`Thickness of rods`,
        help: msg`0: rods are not displayed.`,
        unit: 'm',
        default: 0.02,
      }),
      onlyWhen: HELD,
    },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { matter: { type: 'matter' }, rest: { type: 'geometry', title: msg`The rest` } },
  evaluate({ geometry }, params, { node }) {
    const { shape, stiffness, scale, margin, mass, velocity, charge } = params;
    const { chosen, rest } = splitByPath(geometry, params.which, node, params.free ? 'rest' : 'rigid');
    if (params.free && shape !== 'ball') {
      const message = msg`only balls can be free; choose the shape Ball, or turn Free off`;
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
