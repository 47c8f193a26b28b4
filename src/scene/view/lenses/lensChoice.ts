import { degrees, radians } from '../../../math/angle.ts';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import type { PictureSize } from '../pictureSize.ts';
import { CUBE_GRIDS } from './cubeLens.ts';
import { domeLens, type FisheyeLens } from './fisheyeLens.ts';
import type { Lens, PanoramicLens } from './lenses.ts';

/** The lenses that a camera can be given, by the names of flags and parameters. */
export const LENS_CHOICES = {
  perspective: msg`Perspective`,
  equirectangular: msg`Equirectangular, 360°`,
  fisheye: msg`Fisheye`,
  dome: msg`Dome`,
  cube: msg`Cube, 3 × 2 faces`,
  'cube-strip': msg`Cube, faces in a row`,
  stereo: msg`Stereo, 360°`,
} as const satisfies Readonly<Record<string, LocalizedText>>;
export type LensChoice = keyof typeof LENS_CHOICES;

/** A lens as people choose it. */
export interface ChosenLens {
  readonly lens: LensChoice;
  /** Of fisheyes and domes: the angle across the circle [°]. */
  readonly aperture: number;
  /** Of domes: by how much they are tilted towards the front [°]. */
  readonly domeTilt: number;
  /** Of stereo: the distance of the eyes [m]. */
  readonly eyeSeparation: number;
}

/** Usual values: a hemispherical dome that is not tilted; eyes as far apart as people's are on average. */
export const USUAL_LENS: ChosenLens = { lens: 'perspective', aperture: 180, domeTilt: 0, eyeSeparation: 0.063 };

/** The panoramic lens of a choice; undefined for the perspective one, which is the camera's. */
export function panoramicLens({ lens, aperture, domeTilt, eyeSeparation }: ChosenLens): PanoramicLens | undefined {
  switch (lens) {
    case 'perspective':
      return undefined;
    case 'equirectangular':
      return { kind: 'equirectangular' };
    case 'fisheye':
    case 'dome':
      return fisheyeLens({ lens, aperture, domeTilt });
    case 'cube':
      return { kind: 'cube', layout: '3x2' };
    case 'cube-strip':
      return { kind: 'cube', layout: '6x1' };
    case 'stereo':
      return { kind: 'stereo', separation: eyeSeparation };
  }
}

/** The same of a choice that is known to be a fisheye. */
export const fisheyeLens = ({
  lens,
  aperture,
  domeTilt,
}: Pick<ChosenLens, 'aperture' | 'domeTilt'> & { readonly lens: 'fisheye' | 'dome' }): FisheyeLens =>
  lens === 'dome'
    ? domeLens(radians(aperture), radians(domeTilt))
    : { kind: 'fisheye', aperture: radians(aperture), elevation: 0 };

/** A choice of which `panoramicLens` makes this lens. */
export function choiceOf(lens: PanoramicLens): ChosenLens {
  switch (lens.kind) {
    case 'equirectangular':
      return { ...USUAL_LENS, lens: 'equirectangular' };
    case 'fisheye': {
      const aperture = degrees(lens.aperture);
      if (lens.elevation === 0) return { ...USUAL_LENS, lens: 'fisheye', aperture };
      return { ...USUAL_LENS, lens: 'dome', aperture, domeTilt: 90 - degrees(lens.elevation) };
    }
    case 'cube':
      return { ...USUAL_LENS, lens: lens.layout === '3x2' ? 'cube' : 'cube-strip' };
    case 'stereo':
      return { ...USUAL_LENS, lens: 'stereo', eyeSeparation: lens.separation };
  }
}

/** The largest picture of whole pixels within a size that a lens fills; any size for one whose picture is a circle. */
export function fittedSize(lens: Lens, { width, height }: PictureSize): PictureSize {
  if (lens.kind === 'perspective' || lens.kind === 'fisheye') return { width, height };
  // A stereo picture has two halves of twice as many pixels across as up.
  if (lens.kind === 'stereo') {
    const side = Math.max(2, 2 * Math.floor(Math.min(width, height) / 2));
    return { width: side, height: side };
  }
  const [columns, rows] = lens.kind === 'cube' ? CUBE_GRIDS[lens.layout] : [2, 1];
  const side = Math.max(1, Math.floor(Math.min(width / columns, height / rows)));
  return { width: side * columns, height: side * rows };
}

/** Whether a lens fills a picture, without bars beside what it shows. */
export function fillsPicture(lens: Lens, { width, height }: PictureSize): boolean {
  const fitted = fittedSize(lens, { width, height });
  return fitted.width === width && fitted.height === height;
}

/** Throws a MessageError if a file's picture would have bars beside what its lens shows. */
export function assertLensShape(lens: Lens, size: PictureSize): void {
  if (fillsPicture(lens, size)) return;
  const { width, height } = size;
  const { width: w, height: h } = fittedSize(lens, size);
  if (lens.kind === 'stereo')
    throw new MessageError(
      msg`a stereo picture has one eye’s picture, twice as wide as high, above the other’s, and is as wide as high; ${width} × ${height} is not, or not even: take ${w} × ${h}`,
    );
  throw new MessageError(
    lens.kind === 'equirectangular'
      ? msg`an equirectangular picture is twice as wide as high, and ${width} × ${height} is not; take ${w} × ${h}`
      : msg`the faces of a cube are square, ${lens.kind === 'cube' ? lens.layout.replace('x', ' × ') : ''} of them, and those of ${width} × ${height} are not; take ${w} × ${h}`,
  );
}
