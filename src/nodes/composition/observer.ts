import { length } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { nodeRefusal, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Velocity of the observer when the scene is opened. */
export const observerNode = defineNode({
  id: 'observer',
  title: msg`Observer`,
  help: msg`The observer’s velocity when the scene is opened.`,
  category: 'composition',
  params: { beta: vectorParam(msg`Velocity`, [0, 0, -0.5], 'c') },
  inputs: {},
  outputs: { observer: { type: 'observer' } },
  evaluate(_inputs, { beta }, { node }) {
    if (length(beta) < 1) return { observer: beta };
    const message = msg`${length(beta).toPrecision(4)} c is not slower than light; take less`;
    throw nodeRefusal('observer.fast', `${node}.beta`, message, { node, param: 'beta', value: [0, 0, -0.9] });
  },
});
