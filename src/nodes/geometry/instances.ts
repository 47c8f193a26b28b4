import { normalize, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
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
  title: msg`Instances`,
  help: msg`Copies that share their meshes, in rows or around a circle.`,
  category: 'geometry',
  params: {
    arrangement: {
      kind: 'choice',
      title: msg`Arrangement`,
      default: 'block',
      options: [
        { value: 'block', title: msg`In rows` },
        { value: 'ring', title: msg`Circle` },
      ],
    },
    countX: { ...countParam(msg`Count in x`, 3, 1, 1000), onlyWhen: BLOCK },
    countY: { ...countParam(msg`Count in y`, 1, 1, 1000), onlyWhen: BLOCK },
    countZ: { ...countParam(msg`Count in z`, 3, 1, 1000), onlyWhen: BLOCK },
    spacing: { ...vectorParam(msg`Spacing`, [2, 2, 2], 'm'), onlyWhen: BLOCK },
    count: { ...countParam(msg`Count`, 8, 1, 1000), onlyWhen: RING },
    radius: { ...lengthParam(msg`Radius`, 4), onlyWhen: RING },
    axis: { ...vectorParam(msg`Axis`, [0, 1, 0]), onlyWhen: RING },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry: { scene } }, params, { node }) {
    const { arrangement, countX, countY, countZ, count, spacing, radius, axis } = params;
    const many = (arrangement === 'block' ? countX * countY * countZ : count) * scene.objects.length;
    if (many > MAX_COPIES) {
      const message = msg`that would be ${many} things, more than ${MAX_COPIES}; take fewer`;
      throw nodeRefusal('instances.many', node, message);
    }
    const spots =
      arrangement === 'block'
        ? gridPoses([countX, countY, countZ], spacing)
        : ringPoses(count, radius, normalize(axis as Vec3, [0, 1, 0]));
    return { geometry: toLoadedScene(arrangeCopies(scene, spots)) };
  },
});
