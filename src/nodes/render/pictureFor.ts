import { NodeRefusal } from '../../graph/nodeType.ts';
import type { Image, Picture } from '../define.ts';
import { PlanError, planned } from '../plan.ts';

/** The picture of an image that comes into `node`; what is put together of too much is refused there. */
export function pictureFor(image: Image, node: string): Picture {
  try {
    return planned(image);
  } catch (error) {
    if (!(error instanceof PlanError)) throw error;
    throw new NodeRefusal({ severity: 'error', code: 'picture.large', place: node, message: error.message });
  }
}
