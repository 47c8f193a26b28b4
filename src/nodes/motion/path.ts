import { defineNode } from '../define.ts';
import { readPlaces } from '../geometry/readPlaces.ts';
import { seconds } from '../geometry/shared.ts';
import { checkSpan } from './span.ts';

/** Along a smooth curve through places, at one speed. */
export const pathNode = defineNode({
  id: 'motion-path',
  title: 'node.path',
  help: 'node.path.help',
  category: 'geometry',
  params: {
    places: { kind: 'list', title: 'param.places', help: 'param.places.help', default: ['0 0 0', '4 0 0', '4 0 -4'] },
    facing: { kind: 'boolean', title: 'param.facing', help: 'param.facing.help', default: true },
    from: seconds('param.from', 0),
    to: seconds('param.to', 10),
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate(_inputs, { places, ...how }, { node }) {
    checkSpan(how, node);
    return { motion: { kind: 'path', ...how, places: readPlaces(places, node) } };
  },
});
