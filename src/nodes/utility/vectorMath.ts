import { add, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { type Message, msg } from '../../messages/message.ts';
import { nodeRefusal, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { numberParam } from './anyNumber.ts';

/** Operations by menu names. */
const OPERATIONS = {
  add,
  subtract: sub,
  scale: (a, _, factor) => scale(a, factor),
  cross,
  normalize: (a) => normalize(a, a),
  dot,
  length,
} as const satisfies Record<string, (a: Vec3, b: Vec3, factor: number) => Vec3 | number>;
type VectorOperation = keyof typeof OPERATIONS;
const TITLES: Readonly<Record<VectorOperation, Message>> = {
  add: msg`A + B`,
  subtract: msg`A − B`,
  scale: msg`A times the factor`,
  cross: msg`A × B (cross product)`,
  normalize: msg`A normalized`,
  dot: msg`A · B (dot product)`,
  length: msg`Length of A`,
};

/** A vector operation. */
export const vectorMathNode = defineNode({
  id: 'vector-math',
  title: msg`Vector math`,
  help: msg`A vector operation. If the result is a vector, the number output is its length; if it is a number, all three components equal it.`,
  category: 'utility',
  params: {
    operation: {
      kind: 'choice',
      title: msg`Operation`,
      default: 'add',
      options: (Object.keys(OPERATIONS) as VectorOperation[]).map((value) => ({ value, title: TITLES[value] })),
    },
    a: vectorParam('A', [0, 0, 0]),
    b: { ...vectorParam('B', [0, 0, 0]), onlyWhen: { param: 'operation', is: ['add', 'subtract', 'cross', 'dot'] } },
    factor: { ...numberParam(msg`Factor`, 1), onlyWhen: { param: 'operation', is: 'scale' } },
  },
  inputs: {},
  outputs: { vector: { type: 'vector' }, number: { type: 'number' } },
  evaluate(_inputs, { operation, a, b, factor }, { node }) {
    const found = (OPERATIONS[operation as VectorOperation] as (a: Vec3, b: Vec3, factor: number) => Vec3 | number)(
      a,
      b,
      factor,
    );
    const result: Vec3 = typeof found === 'number' ? [found, found, found] : found;
    const number = typeof found === 'number' ? found : length(found);
    if (Number.isFinite(number)) return { vector: result, number };
    throw nodeRefusal(
      'math.undefined',
      node,
      msg`${operation} of ${a.join(', ')} is beyond all numbers; take smaller ones`,
    );
  },
});
