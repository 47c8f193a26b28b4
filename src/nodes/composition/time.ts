import { defineNode } from '../define.ts';
import { seconds } from '../geometry/shared.ts';
import { checkSpan } from '../motion/span.ts';

/** From when to when a scene is shown. */
export const timeNode = defineNode({
  id: 'time',
  title: 'node.time',
  help: 'node.time.help',
  category: 'composition',
  params: { from: seconds('param.from', 0), to: seconds('param.to', 10), openAt: seconds('param.openAt', 0) },
  inputs: {},
  outputs: { time: { type: 'time' } },
  evaluate(_inputs, { from, to, openAt }, { node }) {
    checkSpan({ from, to }, node);
    return { time: { start: from, end: to, openAt: Math.min(Math.max(openAt, from), to) } };
  },
});
