import type { DecodePicture } from '../../formats/image/foreignPictures.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

const TYPES = { WebP: 'image/webp', AVIF: 'image/avif' } as const;

/** Decodes by the browser. WebGL gives the pixels as they are; a 2D canvas would multiply them with their alpha. */
export const decodePicture: DecodePicture = async (bytes, kind) => {
  const picture = await createImageBitmap(new Blob([bytes], { type: TYPES[kind] }), {
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
  const { width, height } = picture;
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (!gl) throw new MessageError(msg`WebGL2 is not available here`);
  try {
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(
      gl.FRAMEBUFFER,
      gl.COLOR_ATTACHMENT0,
      gl.TEXTURE_2D,
      gl.getParameter(gl.TEXTURE_BINDING_2D),
      0,
    );
    const data = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
    if (gl.getError() !== gl.NO_ERROR)
      throw new MessageError(msg`${width} × ${height} pixels are more than this device reads`);
    return { width, height, data };
  } finally {
    picture.close();
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
};
