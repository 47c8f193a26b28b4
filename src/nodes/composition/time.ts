import { msg } from '../../messages/message.ts';
import { timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { assertTimeSpan } from '../motion/checkSpan.ts';

/** Time range in which a scene is shown. */
export const timeNode = defineNode({
  id: 'time',
  title: msg`Time`,
  help: msg`The time range in which the scene is shown.`,
  category: 'composition',
  params: { from: timeParam(msg`From`, 0), to: timeParam(msg`To`, 10), openAt: timeParam(msg`Opens at`, 0) },
  inputs: {},
  outputs: { time: { type: 'time' } },
  evaluate(_inputs, { from, to, openAt }, { node }) {
    assertTimeSpan({ from, to }, node);
    return { time: { start: from, end: to, openAt: Math.min(Math.max(openAt, from), to) } };
  },
});
