import { withLifetime } from '../../scene/compose/assignMaterial.ts';
import { assertPathExists, nodeRefusal, timeParam, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Time range in which objects exist. */
export const lifetimeNode = defineNode({
  id: 'lifetime',
  title: 'node.lifetime',
  help: 'node.lifetime.help',
  category: 'geometry',
  params: { which: whichParam, birth: timeParam('param.birth', 0), death: timeParam('param.death', 10) },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry }, { which, birth, death }, { node }) {
    assertPathExists(geometry.scene, which, node);
    if (!(death > birth)) {
      const remedy = { node, param: 'death', value: birth + 1 };
      throw nodeRefusal(
        'lifetime.empty',
        `${node}.death`,
        `it ends at ${death} s, before it begins at ${birth} s`,
        remedy,
      );
    }
    return { geometry: { ...geometry, scene: withLifetime(geometry.scene, which, { birth, death }) } };
  },
});
