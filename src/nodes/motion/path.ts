import { msg } from '../../messages/message.ts';
import { facingParam, timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { assertTimeSpan } from './checkSpan.ts';
import { parsePathPoints } from './keyTable.ts';

/** Along a smooth curve through points, at constant speed. */
export const pathNode = defineNode({
  id: 'motion-path',
  title: msg`Path`,
  help: msg`Along a smooth curve through points, at constant speed.`,
  category: 'geometry',
  params: {
    places: {
      kind: 'list',
      title: msg`Waypoints`,
      help: msg`One point per line: x y z in metres.`,
      default: ['0 0 0', '4 0 0', '4 0 -4'],
    },
    facing: facingParam,
    from: timeParam(msg`From`, 0),
    to: timeParam(msg`To`, 10),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { places, ...how }, { node }) {
    assertTimeSpan(how, node);
    return { motion: { kind: 'path', ...how, points: parsePathPoints(places, node) } };
  },
});
