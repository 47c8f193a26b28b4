import { NodeRefusal } from '../../graph/nodeType.ts';
import { defineNode } from '../defineNode.ts';
import { numberParam } from './anyNumber.ts';
import { arity, OPERATIONS, type Operation } from './operations.ts';

const NAMES = Object.keys(OPERATIONS) as Operation[];
const withArity = (least: number): Operation[] => NAMES.filter((name) => arity(name) >= least);

/** An arithmetic operation. */
export const mathNode = defineNode({
  id: 'math',
  title: 'node.math',
  help: 'node.math.help',
  category: 'utility',
  params: {
    operation: {
      kind: 'choice',
      title: 'param.operation',
      default: 'add',
      options: NAMES.map((value) => ({ value, title: `math.${value}` })),
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
    const message = `${operation} of ${values} is no number; change one of them`;
    throw new NodeRefusal({ severity: 'error', code: 'math.undefined', place: node, message });
  },
});
