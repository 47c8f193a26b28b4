import { defineNode } from '../define.ts';
import { fileName } from '../files.ts';
import { refusal, seconds } from '../geometry/shared.ts';
import { samples, savedPicture, saving } from './saving.ts';

/** Asks for an image to be written as a picture of one moment, and passes it on. */
export const saveImageNode = defineNode({
  id: 'save-image',
  title: 'node.saveImage',
  help: 'node.saveImage.help',
  category: 'render',
  params: {
    name: { kind: 'text', title: 'param.fileName', help: 'param.imageName.help', default: 'picture.png' },
    ...saving,
    time: { ...seconds('param.pictureTime', 0), help: 'param.pictureTime.help', suggestion: 'openAt' },
    samples: samples(4),
  },
  inputs: { image: { type: 'image' } },
  outputs: { image: { type: 'image' }, file: { type: 'file', title: 'socket.file' } },
  evaluate({ image }, { name, width, height, time, samples }, { node }) {
    const called = fileName(name, ['png', 'exr'], node);
    checkNumber(called, node);
    const picture = savedPicture(image, called, node);
    const { hints, startTime } = picture.scene;
    const at = time ?? hints.openAt ?? startTime;
    return { image, file: { kind: 'image', name: called, picture, width, height, samples, time: at } };
  },
});

/** A single picture is no frame of anything. */
function checkNumber(name: string, node: string): void {
  if (!name.includes('#')) return;
  const bare = name.replace(/[._-]?#+/g, '');
  const value = bare.startsWith('.') ? `picture${bare}` : bare;
  const message = `"${name}": # stands for the numbers of frames, and this is one picture; Save Video writes several`;
  throw refusal('file.frame', `${node}.name`, message, { node, param: 'name', value });
}
