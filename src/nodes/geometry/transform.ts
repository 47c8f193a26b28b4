import { placeScene } from '../../scene/compose/place.ts';
import { defineNode } from '../define.ts';
import { rotation, vector } from './shared.ts';
import { surveyed } from './surveyed.ts';

/** Turns, enlarges and carries everything that comes in, with its motions, lamps and cameras. */
export const transformNode = defineNode({
  id: 'transform',
  title: 'node.transform',
  help: 'node.transform.help',
  category: 'geometry',
  params: {
    position: vector('param.position', [0, 0, 0], 'm'),
    rotation: vector('param.rotation', [0, 0, 0], '°'),
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
    geometry: surveyed(placeScene(geometry.scene, { position, orientation: rotation(angles), scale })),
  }),
});
