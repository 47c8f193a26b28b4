import { msg } from '../../messages/message.ts';
import { mergeScenes } from '../../scene/compose/mergeScenes.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { defineNode } from '../defineNode.ts';

/** Merges geometry; for what can occur only once the first input wins. */
export const mergeNode = defineNode({
  id: 'merge',
  title: msg`Merge`,
  help: msg`Merges several inputs. Duplicate names get a number.`,
  category: 'geometry',
  params: {},
  inputs: { geometry: { type: 'geometry', many: true } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate: ({ geometry }) => ({ geometry: toLoadedScene(mergeScenes(geometry.map(({ scene }) => scene))) }),
});
