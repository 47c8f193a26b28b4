import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { formatBytes } from '../diagnostics/inputError.ts';
import { imageKind } from '../image/imageKind.ts';
import type { RandomAccessFile } from '../zip/directory.ts';
import { inFile } from './inFile.ts';
import { panoramaOfXmp } from './panorama.ts';
import { sphericalOfMp4 } from './sphericalMp4.ts';
import { sphericalOfExr } from './sphericalPictures.ts';
import { jpegXmp, pngXmp } from './xmpPackets.ts';

/** Largest picture that is read [bytes]. */
const MAX_PICTURE = 2 ** 30;

/**
 * What a PNG, JPEG, EXR or MP4 says of itself, by its content: how it covers the sphere, or undefined where it is flat,
 * says nothing, or is another kind of file. Of a film little more than its `moov` is read.
 * Throws a MessageError that begins with `name` where the file is damaged, or spherical in a way that is not read.
 * @example
 * import type { SphericalPicture } from 'slowlight/scene';
 * const png = encodePng(2, 1, new Uint8Array(8));
 * const panorama = withSphericalPng(png, { projection: 'equirectangular', stereo: 'none' });
 * async function told(bytes: Uint8Array): Promise<SphericalPicture | undefined> {
 *   return sphericalOf(memoryFile(bytes), 'a.png');
 * }
 */
export const sphericalOf = (file: RandomAccessFile, name: string): Promise<SphericalPicture | undefined> =>
  inFile(name, async () => {
    const head = await file.read(0, Math.min(file.size, 16));
    if (isFilm(head)) return sphericalOfMp4(file);
    const read = READERS[imageKind(head)];
    if (!read) return undefined;
    if (file.size > MAX_PICTURE)
      throw new MessageError(
        msg`the picture has ${formatBytes(file.size)}; at most ${formatBytes(MAX_PICTURE)} are read`,
      );
    return read(await file.read(0, file.size), name);
  });

const READERS: Readonly<Record<string, (bytes: Uint8Array, name: string) => SphericalPicture | undefined>> = {
  PNG: (bytes) => fromXmp(pngXmp(bytes)),
  JPEG: (bytes) => fromXmp(jpegXmp(bytes)),
  OpenEXR: sphericalOfExr,
};

const fromXmp = (packet: Uint8Array | undefined): SphericalPicture | undefined => packet && panoramaOfXmp(packet);

/** First boxes of films of MP4 and QuickTime; other files of this structure, such as AVIF, have another brand. */
function isFilm(head: Uint8Array): boolean {
  const type = String.fromCharCode(...head.subarray(4, 8));
  return type === 'ftyp' ? imageKind(head) !== 'AVIF' : ['moov', 'mdat', 'wide'].includes(type);
}
