import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import type { ExrImage } from '../image/exr.ts';
import { imageKind } from '../image/imageKind.ts';
import { readExrHeader } from '../image/readExr.ts';
import { panoramaOfXmp, panoramaXmp } from './panorama.ts';
import { withPngXmp } from './xmpPackets.ts';

/** Of the width and height in a PNG's header [bytes]. */
const PNG_SIZE = 16;
/** Text attribute of an EXR that holds XMP: there is no standard one, but darktable and KDE write it. */
const EXR_XMP = 'xmp';

/**
 * A PNG that says how it covers the sphere, in XMP. Replaces XMP that it had.
 * @example
 * const png = encodePng(2, 1, new Uint8Array(8));
 * const panorama = withSphericalPng(png, { projection: 'equirectangular', stereo: 'none' });
 * new TextDecoder().decode(panorama).includes('GPano:ProjectionType="equirectangular"'); // true
 */
export function withSphericalPng(png: Uint8Array, picture: SphericalPicture): Uint8Array<ArrayBuffer> {
  if (imageKind(png) !== 'PNG' || png.length < PNG_SIZE + 8) throw new MessageError(msg`this is no PNG`);
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  const size = { width: view.getUint32(PNG_SIZE), height: view.getUint32(PNG_SIZE + 4) };
  return withPngXmp(png, panoramaXmp(picture, size));
}

/**
 * The parts of an EXR that say how it covers the sphere: XMP as a text attribute, and the standard `envmap` where the
 * picture is the latitude–longitude map of OpenEXR: one view of the full sphere, twice as wide as high. That map's axes
 * are then those of the camera turned by half a turn about its up axis: +Z is forward, +X left, +Y up. OpenEXR puts the
 * middles of the first and last pixel of a row at longitude ±π, others put their outer edges there: half a pixel of difference.
 * Its cube map is a column of faces, which ours is not.
 * @example
 * const size = { width: 4, height: 2 };
 * sphericalExr({ projection: 'equirectangular', stereo: 'none' }, size).envmap; // 'latlong'
 */
export function sphericalExr(
  picture: SphericalPicture,
  size: PictureSize,
): Required<Pick<ExrImage, 'attributes'>> & Pick<ExrImage, 'envmap'> {
  const isWhole = picture.projection === 'equirectangular' && picture.stereo === 'none' && !picture.crop;
  const isLatLong = isWhole && size.width === 2 * size.height;
  return {
    attributes: { [EXR_XMP]: panoramaXmp(picture, size) },
    ...(isLatLong && { envmap: 'latlong' }),
  };
}

/** What an EXR says; undefined where it says nothing. Throws where it is damaged or of an unsupported kind, and for the cube maps of OpenEXR. */
export function sphericalOfExr(bytes: Uint8Array, name: string): SphericalPicture | undefined {
  const { attributes, envmap } = readExrHeader(bytes, name);
  const xmp = attributes?.[EXR_XMP];
  const told = xmp === undefined ? undefined : panoramaOfXmp(new TextEncoder().encode(xmp));
  if (told || !envmap) return told;
  if (envmap === 'cube') throw new MessageError(msg`a cube map in a column is not read; one of 3 × 2 faces is`);
  return { projection: 'equirectangular', stereo: 'none' };
}
