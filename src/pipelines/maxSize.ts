import { msg } from '../messages/message.ts';
import { MessageError } from '../messages/messageError.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';

/** A picture larger than the graphics device supports, which it would leave blank. */
export class PictureTooLargeError extends MessageError {}

/** `largest`: maximum pixels per side. */
export function assertPictureSize({ width, height }: PictureSize, largest: number): void {
  if (Math.max(width, height) > largest)
    throw new PictureTooLargeError(
      msg`${width} × ${height} pixels are too many for the graphics device here, which draws up to ${largest} along each side; make the picture smaller.`,
    );
}
