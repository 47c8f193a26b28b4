import { livingIn } from '../../scene/compose/dress.ts';
import { defineNode } from '../define.ts';
import { checkPath, refusal, seconds, whichParam } from './shared.ts';

/** From when to when things are there. */
export const lifetimeNode = defineNode({
  id: 'lifetime',
  title: 'node.lifetime',
  help: 'node.lifetime.help',
  category: 'geometry',
  params: { which: whichParam, birth: seconds('param.birth', 0), death: seconds('param.death', 10) },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry }, { which, birth, death }, { node }) {
    checkPath(geometry.scene, which, node);
    if (!(death > birth)) {
      const remedy = { node, param: 'death', value: birth + 1 };
      throw refusal('lifetime.empty', `${node}.death`, `it ends at ${death} s, before it begins at ${birth} s`, remedy);
    }
    return { geometry: { ...geometry, scene: livingIn(geometry.scene, which, { birth, death }) } };
  },
});
