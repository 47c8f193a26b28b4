import { msg } from '../../messages/message.ts';
import type { FilmLayout } from '../../scene/film/film.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { facesIn, type PanoramaPicture } from './faces.ts';
import { edgesMeet, unfoldedCube, unfoldedFisheye } from './unfold.ts';
import { wholeSphere } from './wholeSphere.ts';

/** How far twice the height may be from the width of a picture by latitude and longitude, as a fraction of it. */
const ASPECT_TOLERANCE = 0.01;

/**
 * The picture by latitude and longitude of one that shows the directions in some way, by `layout` and by its shape; undefined if it is none. Throws an InputError where that would be too
 * large, with `name`. `notes` is told what is left out.
 */
export function unfoldedPicture(
  decoded: PanoramaPicture,
  { fisheye, coverage }: FilmLayout,
  name: string,
  notes: DiagnosticLog,
): PanoramaPicture | undefined {
  if (fisheye) return unfoldedFisheye(decoded, fisheye);
  const picture = coverage ? wholeSphere(decoded, coverage, name, notes) : decoded;
  const { width, height } = picture;
  if (Math.abs(width - 2 * height) <= ASPECT_TOLERANCE * width) return picture;
  const faces = facesIn(picture);
  if (faces && width * 2 === height * 3 && !edgesMeet(faces)) {
    const message = msg`it is taken for a grid of 3 × 2 faces of a cube, by its aspect ratio, but their edges do not meet: if it is a photograph, it is no panorama`;
    notes.add('warning', 'panorama.edges', '', message);
  }
  return faces && unfoldedCube(faces);
}
