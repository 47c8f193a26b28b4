import { normalize, type Vec3 } from '../../math/vec3.ts';
import { arrangeCopies, gridPoses, MAX_COPIES, ringPoses } from '../../scene/compose/arrange.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { nodeRefusal, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { countParam, lengthParam } from './primitives/definePrimitive.ts';

const BLOCK = { param: 'arrangement', is: 'block' } as const;
const RING = { param: 'arrangement', is: 'ring' } as const;

/** Copies that share their meshes, in rows or around a circle. */
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
    countX: { ...countParam('param.countX', 3, 1, 1000), onlyWhen: BLOCK },
    countY: { ...countParam('param.countY', 1, 1, 1000), onlyWhen: BLOCK },
    countZ: { ...countParam('param.countZ', 3, 1, 1000), onlyWhen: BLOCK },
    spacing: { ...vectorParam('param.spacing', [2, 2, 2], 'm'), onlyWhen: BLOCK },
    count: { ...countParam('param.count', 8, 1, 1000), onlyWhen: RING },
    radius: { ...lengthParam('param.radius', 4), onlyWhen: RING },
    axis: { ...vectorParam('param.axisVector', [0, 1, 0]), onlyWhen: RING },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry: { scene } }, params, { node }) {
    const { arrangement, countX, countY, countZ, count, spacing, radius, axis } = params;
    const many = (arrangement === 'block' ? countX * countY * countZ : count) * scene.objects.length;
    if (many > MAX_COPIES) {
      const message = `that would be ${many} things, more than ${MAX_COPIES}; take fewer`;
      throw nodeRefusal('instances.many', node, message);
    }
    const spots =
      arrangement === 'block'
        ? gridPoses([countX, countY, countZ], spacing)
        : ringPoses(count, radius, normalize(axis as Vec3, [0, 1, 0]));
    return { geometry: toLoadedScene(arrangeCopies(scene, spots)) };
  },
});
