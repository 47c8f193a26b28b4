import { msg } from '../../messages/message.ts';
import { keyframedMotion } from '../../scene/compose/motionPaths.ts';
import { defineNode } from '../defineNode.ts';
import { parsePoseKeys } from './keyTable.ts';

/** Through positions at given times, with linear interpolation of position and rotation. */
export const keyframesNode = defineNode({
  id: 'motion-keyframes',
  title: msg`Keyframes`,
  help: msg`Through positions at given times, with linear interpolation of position and rotation.`,
  category: 'geometry',
  params: {
    keys: {
      kind: 'list',
      title: msg`Keyframes`,
      help: msg`One key per line: t x y z, with rotation also rx ry rz; seconds, metres, degrees.`,
      default: ['0 0 0 0', '2 4 0 0 0 90 0'],
    },
  },
  inputs: {},
  outputs: { motion: { type: 'motion' } },
  evaluate: (_inputs, { keys }, { node }) => ({
    motion: { kind: 'frame', motion: keyframedMotion(parsePoseKeys(keys, node)) },
  }),
});
