import type { ReadFont } from '../../formats/font/glyphs.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { fetchFile } from './fetchFile.ts';

/** Reads fonts deployed beside the page by the build. */
export const readFont: ReadFont = async (path) => {
  const response = await fetchFile(new URL(`fonts/${path}`, document.baseURI), path);
  if (!response.ok)
    throw new MessageError(msg`the font ${path} cannot be loaded: the server answers ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
};
