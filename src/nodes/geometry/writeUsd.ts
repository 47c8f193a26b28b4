import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { defineNode } from '../defineNode.ts';
import { checkedFileName } from '../project/outputFiles.ts';

/** Requests that geometry is written as USD; passes it through. */
export const writeUsdNode = defineNode({
  id: 'write-usd',
  title: 'node.writeUsd',
  help: 'node.writeUsd.help',
  category: 'geometry',
  params: {
    name: { kind: 'text', title: 'param.fileName', help: 'param.fileName.help', default: 'geometry.usda' },
    motion: {
      kind: 'choice',
      title: 'param.writtenMotion',
      help: 'param.writtenMotion.help',
      default: 'sampled',
      options: [
        { value: 'sampled', title: 'writtenMotion.sampled' },
        { value: 'exact', title: 'writtenMotion.exact' },
      ],
    },
    speedOfLight: {
      kind: 'number',
      title: 'param.speedOfLight',
      help: 'param.writtenLight.help',
      unit: 'm/s',
      default: SPEED_OF_LIGHT,
      min: 0.1,
      max: SPEED_OF_LIGHT,
      step: 0.1,
      scale: 'log',
      suggestion: 'speedOfLight',
    },
  },
  inputs: { geometry: { type: 'geometry' }, time: { type: 'time', optional: true } },
  outputs: { geometry: { type: 'geometry' }, file: { type: 'file', title: 'socket.file' } },
  evaluate({ geometry, time }, { name, motion, speedOfLight }, { node }) {
    const during = time ? { startTime: time.start, endTime: time.end } : {};
    const { hints } = geometry.scene;
    const scene = { ...geometry.scene, ...during, hints: { ...hints, ...(speedOfLight && { speedOfLight }) } };
    return {
      geometry,
      file: {
        kind: 'scene',
        name: checkedFileName(name, ['usda', 'usdz', 'usdc'], node),
        scene,
        sampled: motion === 'sampled',
      },
    };
  },
});
