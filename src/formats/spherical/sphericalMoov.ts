import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { joinedBytes } from '../files/joinedBytes.ts';
import { changedAt, contentsAt, type Mp4Box, readMp4Boxes, writeMp4Boxes } from './mp4Boxes.ts';
import { isSphericalV1, sphericalOfV1, sphericalOfV2, sphericalV1, sphericalV2 } from './sphericalBoxes.ts';

const SAMPLE_DESCRIPTION = ['mdia', 'minf', 'stbl', 'stsd'];
/** Bytes before the entries of `stsd`, before the boxes of a visual sample entry, and before the sizes in it (ISO/IEC 14496-12, 8.5.2 and 12.1.3). */
const [ENTRIES, ENTRY_BOXES, ENTRY_SIZE] = [8, 78, 24];
/** Optional boxes that end a visual sample entry: those of V2 come before them. */
const LAST_BOXES = ['clap', 'pasp', 'colr', 'btrt'];

/** The content of a film's `moov` with boxes of both versions in all video tracks, in place of those that they had. Chunk offsets stay. */
export function withSphericalBoxes(moov: Uint8Array, picture: SphericalPicture): Uint8Array {
  let tracks = 0;
  const marked = changedAt(moov, ['trak'], 'moov', (track, place) => {
    if (!isVideo(track, place)) return track;
    tracks++;
    return withTrackBoxes(track, place, picture);
  });
  if (tracks === 0) throw new MessageError(msg`the film has no video track`);
  return marked;
}

const isVideo = (track: Uint8Array, place: string): boolean =>
  contentsAt(track, ['mdia', 'hdlr'], place).some((handler) => handlerType(handler) === 'vide');

const handlerType = (handler: Uint8Array): string => String.fromCharCode(...handler.subarray(8, 12));

function withTrackBoxes(track: Uint8Array, place: string, picture: SphericalPicture): Uint8Array {
  const sizes: PictureSize[] = [];
  const described = changedAt(track, SAMPLE_DESCRIPTION, place, (description, at) => {
    const entries = readMp4Boxes(description.subarray(ENTRIES), at);
    const boxes = entries.boxes.map((entry) => {
      sizes.push(entrySize(entry, at));
      return { ...entry, content: withEntryBoxes(entry, at, picture) };
    });
    return joinedBytes([description.subarray(0, ENTRIES), writeMp4Boxes({ ...entries, boxes })]);
  });
  const [size] = sizes;
  if (!size) throw new MessageError(msg`${place} does not describe its frames`);
  const { boxes, rest } = readMp4Boxes(described, place);
  const others = boxes.filter(({ type, content }) => type !== 'uuid' || !isSphericalV1(content));
  const v1 = sphericalV1(picture, size) ?? new Uint8Array(0);
  return joinedBytes([writeMp4Boxes({ boxes: others, rest: v1 }), rest]);
}

function entrySize({ type, content }: Mp4Box, place: string): PictureSize {
  if (content.length < ENTRY_BOXES)
    throw new MessageError(msg`${`${place}/${type}`} has ${content.length} bytes, less than ${ENTRY_BOXES}`);
  const view = new DataView(content.buffer, content.byteOffset);
  return { width: view.getUint16(ENTRY_SIZE), height: view.getUint16(ENTRY_SIZE + 2) };
}

function withEntryBoxes({ type, content }: Mp4Box, place: string, picture: SphericalPicture): Uint8Array {
  const { boxes, rest } = readMp4Boxes(content.subarray(ENTRY_BOXES), `${place}/${type}`);
  const others = boxes.filter((box) => box.type !== 'st3d' && box.type !== 'sv3d');
  const last = others.findIndex((box) => LAST_BOXES.includes(box.type));
  const split = last < 0 ? others.length : last;
  const none = new Uint8Array(0);
  return joinedBytes([
    content.subarray(0, ENTRY_BOXES),
    writeMp4Boxes({ boxes: others.slice(0, split), rest: none }),
    sphericalV2(picture),
    writeMp4Boxes({ boxes: others.slice(split), rest }),
  ]);
}

/** What the `moov` of a film says of its first video track that says something: V2, or else V1; undefined where none does. */
export function sphericalOfMoov(moov: Uint8Array): SphericalPicture | undefined {
  for (const track of contentsAt(moov, ['trak'], 'moov')) {
    const picture = isVideo(track, 'moov/trak') ? sphericalOfTrack(track, 'moov/trak') : undefined;
    if (picture) return picture;
  }
  return undefined;
}

function sphericalOfTrack(track: Uint8Array, place: string): SphericalPicture | undefined {
  for (const description of contentsAt(track, SAMPLE_DESCRIPTION, place)) {
    const at = [place, ...SAMPLE_DESCRIPTION].join('/');
    for (const entry of readMp4Boxes(description.subarray(ENTRIES), at).boxes) {
      entrySize(entry, at);
      const picture = sphericalOfV2(entry.content.subarray(ENTRY_BOXES), `${at}/${entry.type}`);
      if (picture) return picture;
    }
  }
  const [v1] = contentsAt(track, ['uuid'], place).filter(isSphericalV1);
  return v1 && sphericalOfV1(v1);
}
