import { msg } from '../../messages/message.ts';
import type { DomeFilm, FilmLayout } from '../../scene/film/film.ts';
import type { InputError, Scene } from '../../scene/types.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { FileSource } from '../files/fileSource.ts';
import { RangedFile } from '../files/rangedFile.ts';
import { MAX_PIXELS } from '../image/decodeImage.ts';
import type { PanoramaPicture } from '../panorama/faces.ts';
import { unfoldedPicture } from '../panorama/unfoldPicture.ts';
import { coverageOf } from '../panorama/wholeSphere.ts';
import type { ReadOptions } from '../readOptions.ts';
import { randomAccess, readFilmTrack } from './filmTrack.ts';

/** What a panoramic film is made of: the picture of its first frame, the film, and its frames a second. */
export interface PanoramicFilm {
  readonly picture: PanoramaPicture;
  readonly film: DomeFilm;
  readonly timeCodesPerSecond: Scene['timeCodesPerSecond'];
}

/** Reads a film of all directions. Throws an InputError where it is none, or cannot be decoded. */
export async function readFilm(
  source: FileSource,
  entry: string,
  { fisheye, openFilm }: ReadOptions,
  notes: DiagnosticLog,
): Promise<PanoramicFilm> {
  if (!openFilm)
    throw inputError('film.undecodable', entry, msg`films are not decoded here; give the frame as a picture`);
  const content = await contentOf(source, entry);
  const track = await readFilmTrack(content.file, content.size);
  if (track.width * track.height > MAX_PIXELS) throw noPanorama(entry, track);
  const marked = await coverageOf(randomAccess(content), entry, notes);
  const layout: FilmLayout = { ...(fisheye && { fisheye }), ...(marked && { coverage: marked }) };
  const frames = openFilm(track);
  try {
    const picture = unfoldedPicture({ ...(await frames.frame(0)), colorSpace: 'srgb' }, layout, entry, notes);
    if (!picture) throw noPanorama(entry, track);
    const { times, end } = track;
    const duration = end - times[0]!;
    const film = { track, layout, start: 0, speed: 1, repeats: false };
    return { picture, film, timeCodesPerSecond: frameRate(times.length / duration) };
  } finally {
    frames.close();
  }
}

async function contentOf(source: FileSource, entry: string): Promise<RangedFile> {
  const opened = await source.open?.(entry);
  if (opened) return opened;
  const bytes = await source.read(entry);
  if (!bytes) throw inputError('file.missing', entry, msg`no such file`);
  return new RangedFile({ name: entry, handle: bytes }, bytes.length);
}

/** Frames a second as they are usually told: whole, or in thousandths. */
const frameRate = (mean: number): number =>
  Math.abs(mean - Math.round(mean)) < 0.01 ? Math.max(1, Math.round(mean)) : Math.round(1000 * mean) / 1000;

const noPanorama = (entry: string, { width, height }: PictureSize): InputError =>
  inputError(
    'panorama.size',
    entry,
    msg`the film has ${width} × ${height} pixels, and is no panorama: one is twice as wide as high, or has six square faces, in a strip, a grid or a cross; of a fisheye or a dome master say so in the node Panorama`,
  );
