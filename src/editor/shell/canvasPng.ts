import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** What a canvas shows, as PNG. */
export const canvasPng = (canvas: HTMLCanvasElement): Promise<Blob> =>
  new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new MessageError(msg`the browser made no PNG`))),
      'image/png',
    );
  });
