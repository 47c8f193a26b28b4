import { NodeRefusal } from '../../graph/nodeType.ts';
import { type Message, msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { numberParam } from './anyNumber.ts';
import { arity, OPERATIONS, type Operation } from './operations.ts';

const NAMES = Object.keys(OPERATIONS) as Operation[];
const TITLES: Readonly<Record<Operation, Message>> = {
  add: msg`A + B`,
  subtract: msg`A − B`,
  multiply: msg`A × B`,
  divide: msg`A ÷ B`,
  power: msg`A to the power B`,
  minimum: msg`Minimum`,
  maximum: msg`Maximum`,
  modulo: msg`Remainder of A ÷ B`,
  mix: msg`Interpolate from A to B by C`,
  clamp: msg`Clamp A between B and C`,
  'square-root': msg`Square root`,
  exponential: msg`Exponential`,
  logarithm: msg`Natural logarithm`,
  absolute: msg`Absolute value`,
  round: msg`Round`,
  floor: msg`Round down`,
  sine: msg`Sine`,
  cosine: msg`Cosine`,
  tangent: msg`Tangent`,
  arcsine: msg`Arcsine`,
  arccosine: msg`Arccosine`,
  arctangent: msg`Angle of the point (B, A)`,
  'gamma-of-beta': msg`γ of the speed β`,
  'beta-of-gamma': msg`Speed β of γ`,
};
const withArity = (least: number): Operation[] => NAMES.filter((name) => arity(name) >= least);

/** An arithmetic operation. */
export const mathNode = defineNode({
  id: 'math',
  title: msg`Math`,
  help: msg`An arithmetic operation; includes conversion between a speed β and its Lorentz factor γ.`,
  category: 'utility',
  params: {
    operation: {
      kind: 'choice',
      title: msg`Operation`,
      default: 'add',
      options: NAMES.map((value) => ({ value, title: TITLES[value] })),
    },
    a: numberParam('A'),
    b: { ...numberParam('B'), onlyWhen: { param: 'operation', is: withArity(2) } },
    c: { ...numberParam('C', 0.5), onlyWhen: { param: 'operation', is: withArity(3) } },
  },
  inputs: {},
  outputs: { number: { type: 'number' } },
  evaluate(_inputs, { operation, a, b, c }, { node }) {
    const number = OPERATIONS[operation as Operation](a, b, c);
    if (Number.isFinite(number)) return { number };
    const values = [a, b, c].slice(0, arity(operation as Operation)).join(', ');
    const message = msg`${operation} of ${values} is no number; change one of them`;
    throw new NodeRefusal({ severity: 'error', code: 'math.undefined', place: node, message });
  },
});
