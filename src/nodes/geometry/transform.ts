import { msg } from '../../messages/message.ts';
import { transformScene } from '../../scene/compose/transformScene.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { rotationXYZ, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Rotates, scales and translates everything in its input, with motions, lights and cameras. */
export const transformNode = defineNode({
  id: 'transform',
  title: msg`Transform`,
  help: msg`Rotates, scales and translates the input, with its motions, lamps and cameras.`,
  category: 'geometry',
  params: {
    position: vectorParam(msg`Position`, [0, 0, 0], 'm'),
    rotation: vectorParam(msg`Rotation`, [0, 0, 0], '°'),
    scale: {
      kind: 'number',
      title: msg`Scale`,
      help: msg`Scales sizes, and with them the distances and speeds of motions.`,
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
