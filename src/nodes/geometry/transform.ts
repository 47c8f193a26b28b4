import { transformScene } from '../../scene/compose/transformScene.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { rotationXYZ, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Rotates, scales and translates everything in its input, with motions, lights and cameras. */
export const transformNode = defineNode({
  id: 'transform',
  title: 'node.transform',
  help: 'node.transform.help',
  category: 'geometry',
  params: {
    position: vectorParam('param.position', [0, 0, 0], 'm'),
    rotation: vectorParam('param.rotation', [0, 0, 0], '°'),
    scale: {
      kind: 'number',
      title: 'param.scale',
      help: 'param.scale.help',
      unit: '×',
      default: 1,
      min: 1e-6,
      max: 1e6,
      step: 0.01,
      slider: false,
    },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate: ({ geometry }, { position, rotation: angles, scale }) => ({
    geometry: toLoadedScene(transformScene(geometry.scene, { position, orientation: rotationXYZ(angles), scale })),
  }),
});
