import { nodeRefusal, timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { checkedFileName } from '../project/outputFiles.ts';
import { pictureSizeParams, pictureToSave, samplesParam } from './saveParams.ts';

/** Requests that an image is saved as a picture of one moment; passes it through. */
export const saveImageNode = defineNode({
  id: 'save-image',
  title: 'node.saveImage',
  help: 'node.saveImage.help',
  category: 'render',
  params: {
    name: { kind: 'text', title: 'param.fileName', help: 'param.imageName.help', default: 'picture.png' },
    ...pictureSizeParams,
    time: { ...timeParam('param.pictureTime', 0), help: 'param.pictureTime.help', suggestion: 'openAt' },
    samples: samplesParam(4),
  },
  inputs: { image: { type: 'image' } },
  outputs: { image: { type: 'image' }, file: { type: 'file', title: 'socket.file' } },
  evaluate({ image }, { name, width, height, time, samples }, { node }) {
    const called = checkedFileName(name, ['png', 'exr'], node);
    assertNoFrameNumber(called, node);
    const picture = pictureToSave(image, called, node);
    const { hints, startTime } = picture.scene;
    const at = time ?? hints.openAt ?? startTime;
    return { image, file: { kind: 'image', name: called, picture, width, height, samples, time: at } };
  },
});

/** A single picture has no frame number. */
function assertNoFrameNumber(name: string, node: string): void {
  if (!name.includes('#')) return;
  const bare = name.replace(/[._-]?#+/g, '');
  const value = bare.startsWith('.') ? `picture${bare}` : bare;
  const message = `"${name}": # stands for the numbers of frames, and this is one picture; Save Video writes several`;
  throw nodeRefusal('file.frame', `${node}.name`, message, { node, param: 'name', value });
}
