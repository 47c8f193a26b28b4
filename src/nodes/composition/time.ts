import { timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { assertTimeSpan } from '../motion/checkSpan.ts';

/** Time range in which a scene is shown. */
export const timeNode = defineNode({
  id: 'time',
  title: 'node.time',
  help: 'node.time.help',
  category: 'composition',
  params: { from: timeParam('param.from', 0), to: timeParam('param.to', 10), openAt: timeParam('param.openAt', 0) },
  inputs: {},
  outputs: { time: { type: 'time' } },
  evaluate(_inputs, { from, to, openAt }, { node }) {
    assertTimeSpan({ from, to }, node);
    return { time: { start: from, end: to, openAt: Math.min(Math.max(openAt, from), to) } };
  },
});
