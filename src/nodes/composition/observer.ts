import { length } from '../../math/vec3.ts';
import { defineNode } from '../define.ts';
import { refusal, vector } from '../geometry/shared.ts';

/** How fast the observer goes when the scene is opened. */
export const observerNode = defineNode({
  id: 'observer',
  title: 'node.observer',
  help: 'node.observer.help',
  category: 'composition',
  params: { beta: vector('param.beta', [0, 0, -0.5], 'c') },
  inputs: {},
  outputs: { observer: { type: 'observer' } },
  evaluate(_inputs, { beta }, { node }) {
    if (length(beta) < 1) return { observer: beta };
    const message = `${length(beta).toPrecision(4)} c is not slower than light; take less`;
    throw refusal('observer.fast', `${node}.beta`, message, { node, param: 'beta', value: [0, 0, -0.9] });
  },
});
