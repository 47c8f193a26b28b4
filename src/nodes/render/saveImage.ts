import { msg } from '../../messages/message.ts';
import { nodeRefusal, timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { checkedFileName } from '../project/outputFiles.ts';
import { pictureSizeParams, pictureToSave, samplesParam } from './saveParams.ts';

/** Requests that an image is saved as a picture of one moment; passes it through. */
export const saveImageNode = defineNode({
  id: 'save-image',
  title: msg`Save image`,
  help: msg`Requests that the image is saved as a picture of one moment, seen by the project’s observer, and passes it through. The node’s button downloads it; “slowlight render PROJECT” without -o writes it.`,
  category: 'render',
  params: {
    name: {
      kind: 'text',
      title: msg`File name`,
      help: msg`Without folders. .png is as displayed; .exr is radiance before exposure and tone curve.`,
      default: 'picture.png',
    },
    ...pictureSizeParams,
    time: {
      ...timeParam(msg`Time`, 0),
      help: msg`World time of the observer’s event; default: the time at which the scene opens.`,
      suggestion: 'openAt',
    },
    samples: samplesParam(4),
  },
  inputs: { image: { type: 'image' } },
  outputs: { image: { type: 'image' }, file: { type: 'file', title: msg`File` } },
  evaluate({ image }, { name, width, height, time, samples }, { node }) {
    const called = checkedFileName(name, ['png', 'exr'], node);
    assertNoFrameNumber(called, node);
    const picture = pictureToSave(image, called, { width, height }, node);
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
  const message = msg`"${name}": # stands for the numbers of frames, and this is one picture; Save Video writes several`;
  throw nodeRefusal('file.frame', `${node}.name`, message, { node, param: 'name', value });
}
