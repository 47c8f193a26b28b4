import { NodeRefusal } from '../../graph/nodeType.ts';
import { MessageError } from '../../messages/messageError.ts';
import { assertLensEffects } from '../../scene/frameGraph/lensEffects.ts';
import { buildPicture, FrameGraphError } from '../frameGraph/buildFrameGraph.ts';
import { pictureLens } from '../pictures/renderSettings.ts';
import type { ImageSpec, PictureSpec } from '../socketValues.ts';

/** The picture of the image that `node` gets; one with too many parts, or with effects that its lens does not have, is refused there. */
export function buildPictureAt(image: ImageSpec, node: string): PictureSpec {
  try {
    const picture = buildPicture(image);
    if (picture.frameGraph && !picture.outside) assertLensEffects(pictureLens(picture), picture.frameGraph);
    return picture;
  } catch (error) {
    if (!(error instanceof MessageError)) throw error;
    const code = error instanceof FrameGraphError ? 'picture.large' : 'picture.lens';
    throw new NodeRefusal({ severity: 'error', code, place: node, message: error.text });
  }
}
