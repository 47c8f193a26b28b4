import { mergeScenes } from '../../scene/compose/mergeScenes.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { defineNode } from '../defineNode.ts';

/** Several things together; the first has the say where there can be only one. */
export const mergeNode = defineNode({
  id: 'merge',
  title: 'node.merge',
  help: 'node.merge.help',
  category: 'geometry',
  params: {},
  inputs: { geometry: { type: 'geometry', many: true } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate: ({ geometry }) => ({ geometry: toLoadedScene(mergeScenes(geometry.map(({ scene }) => scene))) }),
});
