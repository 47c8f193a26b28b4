import { NodeRefusal } from '../../graph/nodeType.ts';
import { buildPicture, FrameGraphError } from '../frameGraph/buildFrameGraph.ts';
import type { ImageSpec, PictureSpec } from '../socketValues.ts';

/** The picture of the image that `node` gets; one with too many parts is refused there. */
export function buildPictureAt(image: ImageSpec, node: string): PictureSpec {
  try {
    return buildPicture(image);
  } catch (error) {
    if (!(error instanceof FrameGraphError)) throw error;
    throw new NodeRefusal({ severity: 'error', code: 'picture.large', place: node, message: error.text });
  }
}
