import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { defineNode } from '../defineNode.ts';
import { checkedFileName } from '../project/outputFiles.ts';

/** Requests that geometry is written as USD; passes it through. */
export const writeUsdNode = defineNode({
  id: 'write-usd',
  title: msg`Write USD`,
  help: msg`Requests that the geometry is written as USD, and passes it through. The node’s button downloads it; “slowlight render PROJECT” without -o writes it.`,
  category: 'geometry',
  params: {
    name: {
      kind: 'text',
      title: msg`File name`,
      help: msg`Without folders. \`.usda\` is text, \`.usdz\` a package with textures, \`.usdc\` binary and smaller.`,
      default: 'geometry.usda',
    },
    motion: {
      kind: 'choice',
      title: msg`Motion`,
      help: msg`Sampled motions can be read by every program; the time range is that of the input, else of the geometry. Exact motions and rest shapes are read by Slowlight only.`,
      default: 'sampled',
      options: [
        { value: 'sampled', title: msg`Sampled` },
        { value: 'exact', title: msg`Exact` },
      ],
    },
    speedOfLight: {
      kind: 'number',
      title: msg`Speed of light`,
      help: msg`Moving rest shapes are contracted by it; it is written to the file as the suggested speed of light.`,
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
  outputs: { geometry: { type: 'geometry' }, file: { type: 'file', title: msg`File` } },
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
