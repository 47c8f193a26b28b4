import { msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import type { FisheyeLens } from '../../scene/view/lenses/fisheyeLens.ts';
import { fisheyeOfMetadata } from '../../scene/view/pictureMetadata.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { MAX_PIXELS } from '../image/decodeImage.ts';
import { imageKind } from '../image/imageKind.ts';
import { pngTexts } from '../image/pngText.ts';
import { readExrHeader } from '../image/readExr.ts';
import { sphericalOf } from '../spherical/sphericalOf.ts';
import { croppedArea, eyeSize } from '../spherical/sphericalPicture.ts';
import type { RandomAccessFile } from '../zip/directory.ts';
import type { PanoramaPicture } from './faces.ts';

/** What the file of a picture or a film says of how it covers the sphere; undefined where it says nothing, or what cannot be read, which is noted: its shape tells most. */
export async function coverageOf(
  file: RandomAccessFile,
  name: string,
  notes: DiagnosticLog,
): Promise<SphericalPicture | undefined> {
  try {
    return await sphericalOf(file, name);
  } catch (error) {
    if (!(error instanceof MessageError)) throw error;
    notes.add('warning', 'panorama.mark', '', messageOf(error));
    return undefined;
  }
}

/** The lens that the header of a dome master or a fisheye of this program names; undefined for all others. */
export function fisheyeOf(bytes: Uint8Array, name: string): FisheyeLens | undefined {
  const kind = imageKind(bytes);
  const text =
    kind === 'PNG'
      ? pngTexts(bytes).get('lens')
      : kind === 'OpenEXR'
        ? readExrHeader(bytes, name).attributes?.lens
        : undefined;
  return text === undefined ? undefined : fisheyeOfMetadata(text);
}

/** The left eye's picture of the whole sphere, black where the file has none. Throws an InputError where that would be too large. */
export function wholeSphere(
  picture: PanoramaPicture,
  coverage: SphericalPicture,
  name: string,
  notes: DiagnosticLog,
): PanoramaPicture {
  const { stereo } = coverage;
  if (stereo !== 'none')
    notes.add('warning', 'panorama.stereo', '', msg`it has a picture for each eye: the left one is shown`);
  const eye = stereo === 'none' ? picture : placed(picture, eyeSize(picture, stereo), 0, 0);
  if (coverage.projection !== 'equirectangular' || !coverage.crop) return eye;
  const { full, left, top } = croppedArea(coverage.crop, eye);
  if (full.width * full.height > MAX_PIXELS)
    throw inputError(
      'panorama.size',
      name,
      msg`it is a part of a picture of all directions of ${full.width} × ${full.height} pixels, of which at most ${MAX_PIXELS / 2 ** 20} Mi are read; make it smaller`,
    );
  notes.add('warning', 'panorama.part', '', msg`it does not show all directions: the others are black`);
  return placed(eye, full, left, top);
}

/** A picture of another size with this one at a place in it [px]; what is outside is cut, and the rest is black. */
function placed(picture: PanoramaPicture, { width, height }: PictureSize, left: number, top: number): PanoramaPicture {
  const make = (size: number): Uint8Array | Uint16Array =>
    picture.data instanceof Uint16Array ? new Uint16Array(size) : new Uint8Array(size);
  const data = make(4 * width * height);
  const columns = Math.min(picture.width, width - left);
  for (let row = 0; row < Math.min(picture.height, height - top); row++) {
    const from = 4 * row * picture.width;
    data.set(picture.data.subarray(from, from + 4 * columns), 4 * ((row + top) * width + left));
  }
  return { ...picture, width, height, data } as PanoramaPicture;
}
