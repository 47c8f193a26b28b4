import { type Message, msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { numberParam } from './anyNumber.ts';

const RELATIONS = {
  less: (a, b) => a < b,
  'less-or-equal': (a, b) => a <= b,
  greater: (a, b) => a > b,
  'greater-or-equal': (a, b) => a >= b,
  equal: (a, b, tolerance) => Math.abs(a - b) <= tolerance,
  unequal: (a, b, tolerance) => Math.abs(a - b) > tolerance,
} as const satisfies Record<string, (a: number, b: number, tolerance: number) => boolean>;
type Relation = keyof typeof RELATIONS;
const TITLES: Readonly<Record<Relation, Message>> = {
  less: msg`A < B`,
  'less-or-equal': msg`A ≤ B`,
  greater: msg`A > B`,
  'greater-or-equal': msg`A ≥ B`,
  equal: msg`A = B`,
  unequal: msg`A ≠ B`,
};
const NAMES = Object.keys(RELATIONS) as Relation[];

/** 1 where a comparison of two numbers holds, else 0. */
export const compareNode = defineNode({
  id: 'compare',
  title: msg`Compare`,
  help: msg`1 if the relation holds, otherwise 0.`,
  category: 'utility',
  params: {
    relation: {
      kind: 'choice',
      title: msg`Relation`,
      default: 'less',
      options: NAMES.map((value) => ({ value, title: TITLES[value] })),
    },
    a: numberParam('A'),
    b: numberParam('B'),
    tolerance: {
      kind: 'number',
      title: msg`Tolerance`,
      default: 1e-6,
      min: 0,
      max: 1e12,
      step: 1e-6,
      slider: false,
      onlyWhen: { param: 'relation', is: ['equal', 'unequal'] },
    },
  },
  inputs: {},
  outputs: { number: { type: 'number' } },
  evaluate: (_inputs, { relation, a, b, tolerance }) => ({
    number: RELATIONS[relation as Relation](a, b, tolerance) ? 1 : 0,
  }),
});
