import { CustomSource, EncodedPacketSink, Input, MATROSKA, MP4, QTFF, WEBM } from 'mediabunny';
import { msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import type { FilmTrack } from '../../scene/film/film.ts';
import { readRange, type StoredFile } from '../../scene/streaming/storedNumbers.ts';
import { InputError } from '../../scene/types.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { RangedFile } from '../files/rangedFile.ts';
import type { RandomAccessFile } from '../zip/directory.ts';
import { checkMp4Tables } from './mp4Tables.ts';

/** Widest frame [px]: larger ones are made smaller when they are decoded. */
export const MAX_WIDTH = 8192;
/** Most frames: eleven hours of 25 a second. */
export const MAX_FRAMES = 1_000_000;

/** A file whose parts are read as those of archives are. */
export const randomAccess = (content: RangedFile): RandomAccessFile => ({
  size: content.size,
  read: async (from, to) => content.read(from, to - from),
});

/** How often a film is read until it counts as damaged: the library follows places that lead round in circles for ever. */
export class ReadBudget {
  private readonly most: number;
  private left = 0;

  /** `bytes`: size of the film. Every part that is read has a header of some bytes. */
  constructor(bytes: number) {
    this.most = 1000 + bytes / 8;
    this.renew();
  }

  /** For another task. */
  renew(): void {
    this.left = this.most;
  }

  /** One more. Throws a MessageError when it is used up. */
  spend(): void {
    if (--this.left < 0) throw new MessageError(msg`its parts lead round in circles`);
  }
}

/** A film, opened for reading; dispose of it. What is read is not kept, so that each time counts. */
export const filmInput = ({ file, bytes }: Pick<FilmTrack, 'file' | 'bytes'>, budget: ReadBudget): Input =>
  new Input({
    formats: [MP4, QTFF, MATROSKA, WEBM],
    source: new CustomSource({
      getSize: () => bytes,
      read: (from, to) => {
        budget.spend();
        return readRange(file, from, to - from);
      },
      maxCacheSize: 0,
    }),
  });

/**
 * Reads when the frames of a film are shown, and their size; no frame is decoded. Throws an InputError where it is no film, or one with high dynamic range, whose colours
 * would be wrong.
 */
export async function readFilmTrack(file: StoredFile, bytes: number): Promise<FilmTrack> {
  const { name } = file;
  const input = filmInput({ file, bytes }, new ReadBudget(bytes));
  try {
    await checkMp4Tables(randomAccess(new RangedFile(file, bytes)));
    if (!(await input.canRead())) throw unreadable(name);
    const track = await input.getPrimaryVideoTrack();
    if (!track) throw inputError('film.empty', name, msg`there are no pictures in it`);
    if (await track.hasHighDynamicRange())
      throw inputError(
        'film.hdr',
        name,
        msg`its colours are of high dynamic range (PQ or HLG), which are not read; convert it to BT.709`,
      );
    const size = { width: await track.getDisplayWidth(), height: await track.getDisplayHeight() };
    const times = await timesOf(new EncodedPacketSink(track), name);
    const end = Math.max(await track.computeDuration({ metadataOnly: true }), times.at(-1)!);
    return { file, bytes, ...decodedSize(size), times, end: end > times[0]! ? end : times[0]! + 1 };
  } catch (error) {
    if (error instanceof MessageError && !(error instanceof InputError))
      throw inputError('film.unreadable', name, msg`it is damaged: ${messageOf(error)}`, error);
    // Of other damage the library says only that an assertion failed.
    throw error instanceof InputError ? error : unreadable(name, error);
  } finally {
    input.dispose();
  }
}

const unreadable = (name: string, cause?: unknown): InputError =>
  inputError(
    'film.unreadable',
    name,
    msg`it is no film in MP4, QuickTime, Matroska or WebM, or it is damaged; convert it, for instance with ffmpeg`,
    cause,
  );

function decodedSize({ width, height }: PictureSize): PictureSize {
  const shrink = Math.min(1, MAX_WIDTH / width);
  return { width: Math.round(shrink * width), height: Math.round(shrink * height) };
}

/** When each frame begins, in the order in which they are shown [s]. */
async function timesOf(packets: EncodedPacketSink, name: string): Promise<Float64Array> {
  const times: number[] = [];
  for await (const { timestamp } of packets.packets(undefined, undefined, { metadataOnly: true })) {
    if (times.length === MAX_FRAMES)
      throw inputError('film.long', name, msg`it has more than ${MAX_FRAMES} frames; cut it into parts`);
    // What begins before 0 is cut off by the film's own edit list.
    if (timestamp >= 0) times.push(timestamp);
  }
  if (times.length === 0) throw inputError('film.empty', name, msg`there are no pictures in it`);
  return Float64Array.from(times).sort();
}
