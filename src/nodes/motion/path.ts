import { timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { assertTimeSpan } from './checkSpan.ts';
import { parsePathPoints } from './keyTable.ts';

/** Along a smooth curve through points, at constant speed. */
export const pathNode = defineNode({
  id: 'motion-path',
  title: 'node.path',
  help: 'node.path.help',
  category: 'geometry',
  params: {
    places: { kind: 'list', title: 'param.places', help: 'param.places.help', default: ['0 0 0', '4 0 0', '4 0 -4'] },
    facing: { kind: 'boolean', title: 'param.facing', help: 'param.facing.help', default: true },
    from: timeParam('param.from', 0),
    to: timeParam('param.to', 10),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { places, ...how }, { node }) {
    assertTimeSpan(how, node);
    return { motion: { kind: 'path', ...how, points: parsePathPoints(places, node) } };
  },
});
