import { msg } from '../../messages/message.ts';
import { withLifetime } from '../../scene/compose/assignMaterial.ts';
import { assertPathExists, nodeRefusal, timeParam, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Limits objects and lights to a time range. */
export const lifetimeNode = defineNode({
  id: 'lifetime',
  title: msg`Lifetime`,
  help: msg`Objects and lights exist only within this time range, and there only when they already did.`,
  category: 'geometry',
  params: { which: whichParam, birth: timeParam(msg`Begins at`, 0), death: timeParam(msg`Ends at`, 10) },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry }, { which, birth, death }, { node }) {
    assertPathExists(geometry.scene, which, node);
    if (!(death > birth)) {
      const remedy = { node, param: 'death', value: birth + 1 };
      throw nodeRefusal(
        'lifetime.empty',
        `${node}.death`,
        msg`it ends at ${death} s, before it begins at ${birth} s`,
        remedy,
      );
    }
    return { geometry: { ...geometry, scene: withLifetime(geometry.scene, which, { birth, death }) } };
  },
});
