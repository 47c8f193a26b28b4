import { normalize, type Vec3 } from '../../math/vec3.ts';
import { block, copies, MOST_COPIES, ring } from '../../scene/compose/instances.ts';
import { defineNode } from '../define.ts';
import { metres, pieces } from './primitive.ts';
import { refusal, vector } from './shared.ts';
import { surveyed } from './surveyed.ts';

const BLOCK = { param: 'arrangement', is: 'block' } as const;
const RING = { param: 'arrangement', is: 'ring' } as const;

/** Copies that share their meshes, in rows or round a circle. */
export const instancesNode = defineNode({
  id: 'instances',
  title: 'node.instances',
  help: 'node.instances.help',
  category: 'geometry',
  params: {
    arrangement: {
      kind: 'choice',
      title: 'param.arrangement',
      default: 'block',
      options: [
        { value: 'block', title: 'arrangement.block' },
        { value: 'ring', title: 'arrangement.ring' },
      ],
    },
    countX: { ...pieces('param.countX', 3, 1, 1000), onlyWhen: BLOCK },
    countY: { ...pieces('param.countY', 1, 1, 1000), onlyWhen: BLOCK },
    countZ: { ...pieces('param.countZ', 3, 1, 1000), onlyWhen: BLOCK },
    spacing: { ...vector('param.spacing', [2, 2, 2], 'm'), onlyWhen: BLOCK },
    count: { ...pieces('param.count', 8, 1, 1000), onlyWhen: RING },
    radius: { ...metres('param.radius', 4), onlyWhen: RING },
    axis: { ...vector('param.axisVector', [0, 1, 0]), onlyWhen: RING },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry: { scene } }, params, { node }) {
    const { arrangement, countX, countY, countZ, count, spacing, radius, axis } = params;
    const many = (arrangement === 'block' ? countX * countY * countZ : count) * scene.objects.length;
    if (many > MOST_COPIES) {
      const message = `that would be ${many} things, more than ${MOST_COPIES}; take fewer`;
      throw refusal('instances.many', node, message);
    }
    const spots =
      arrangement === 'block'
        ? block([countX, countY, countZ], spacing)
        : ring(count, radius, normalize(axis as Vec3, [0, 1, 0]));
    return { geometry: surveyed(copies(scene, spots)) };
  },
});
