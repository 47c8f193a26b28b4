import { add, cross, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
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

/** A vector operation. */
export const vectorMathNode = defineNode({
  id: 'vector-math',
  title: 'node.vectorMath',
  help: 'node.vectorMath.help',
  category: 'utility',
  params: {
    operation: {
      kind: 'choice',
      title: 'param.operation',
      default: 'add',
      options: (Object.keys(OPERATIONS) as VectorOperation[]).map((value) => ({ value, title: `vectorMath.${value}` })),
    },
    a: vectorParam('A', [0, 0, 0]),
    b: { ...vectorParam('B', [0, 0, 0]), onlyWhen: { param: 'operation', is: ['add', 'subtract', 'cross', 'dot'] } },
    factor: { ...numberParam('param.factor', 1), onlyWhen: { param: 'operation', is: 'scale' } },
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
    throw nodeRefusal('math.undefined', node, `${operation} of ${a} is beyond all numbers; take smaller ones`);
  },
});
