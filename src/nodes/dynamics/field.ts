import { msg } from '../../messages/message.ts';
import { vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { quantityParam } from './params.ts';

/** A field that acts on everything simulated; several add up. */
export const fieldNode = defineNode({
  id: 'field',
  title: msg`Field`,
  help: msg`Fields that act on everything simulated; several are added. Electric and magnetic fields act on charges.`,
  category: 'dynamics',
  params: {
    gravity: {
      ...vectorParam(msg`Gravity`, [0, -9.8, 0], 'm/s²'),
      help: msg`Force per kilogram of rest mass, independent of speed.`,
    },
    drag: quantityParam({
      title: msg`Air drag`,
      help: msg`Fraction of the momentum that air removes per second.`,
      unit: '1/s',
      default: 0,
      max: 1e6,
    }),
    electric: vectorParam(msg`Electric field`, [0, 0, 0], 'V/m'),
    magnetic: vectorParam(msg`Magnetic field`, [0, 0, 0], 'T'),
    coulomb: {
      kind: 'boolean',
      title: msg`Charges act on each other`,
      help: msg`Instantaneous, without propagating fields.`,
      default: false,
    },
  },
  inputs: {},
  outputs: { matter: { type: 'matter' } },
  evaluate: (_inputs, field, { node }) => ({ matter: { kind: 'field', node, ...field } }),
});
