import { decompress } from 'fzstd';
import { type KTX2Container, read } from 'ktx-parse';
import { type LocalizedText, type Message, msg } from '../../../messages/message.ts';
import { MessageError, messageOf } from '../../../messages/messageError.ts';
import { InputError } from '../../../scene/types.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import { checkSize, type DecodedImage } from '../decodeImage.ts';
import { type CodeBooks, readCodeBooks, readSlice } from './basisLz.ts';
import { decodeUastc } from './uastc.ts';

/** Where the width and the height stand [bytes]. */
const [WIDTH_AT, HEIGHT_AT] = [20, 24];
/** Most mip levels: more than the largest picture that is read has. */
const MAX_LEVELS = 16;

/** Names in KTX 2.0: super-compression, and colour models and channels of data format descriptors. */
const [NO_COMPRESSION, BASIS_LZ, ZSTD] = [0, 1, 2];
const [ETC1S, UASTC] = [163, 166];
/** A second channel that is green, not alpha. */
const [ETC1S_GREEN, UASTC_RED_RED_RED_GREEN] = [4, 5];

/** Vulkan's numbers of formats with 8 bits a channel, and where these have red, green, blue and alpha. */
const PLAIN_FORMATS: Readonly<Record<number, readonly number[]>> = {
  9: [0],
  15: [0],
  16: [0, 1],
  22: [0, 1],
  23: [0, 1, 2],
  29: [0, 1, 2],
  30: [2, 1, 0],
  36: [2, 1, 0],
  37: [0, 1, 2, 3],
  43: [0, 1, 2, 3],
  44: [2, 1, 0, 3],
  50: [2, 1, 0, 3],
};

/**
 * Decodes the largest level of a KTX 2.0 picture to straight RGBA: Basis Universal's ETC1S and UASTC, and formats of 8 bits a channel, also compressed by Zstandard. Throws an
 * InputError that names `name`.
 */
export function decodeKtx2(bytes: Uint8Array, name: LocalizedText): DecodedImage {
  if (bytes.length < HEIGHT_AT + 4) throw damaged(name, msg`it ends too early`);
  const head = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  checkSize(head.getUint32(WIDTH_AT, true), head.getUint32(HEIGHT_AT, true), name);
  try {
    // Offsets are from the start of its buffer, whose end is the file's.
    const file = read(bytes.slice());
    checkKind(file, name);
    return oriented(pixelsOf(file, name), `${file.keyValue.KTXorientation ?? ''}`);
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    throw damaged(name, messageOf(thrown), thrown);
  }
}

const damaged = (name: LocalizedText, why: LocalizedText, cause?: unknown): InputError =>
  inputError('image.damaged', name, msg`the KTX2 is damaged or cut off (${why}); export it again`, cause);

const unread = (name: LocalizedText, what: Message): InputError =>
  inputError(
    'image.unknown-format',
    name,
    msg`the picture is a KTX2 with ${what}, which is not read; convert it to Basis Universal, PNG or JPEG`,
  );

function checkKind({ pixelDepth, layerCount, faceCount, levelCount }: KTX2Container, name: LocalizedText): void {
  if (pixelDepth > 1 || layerCount > 1 || faceCount !== 1) throw unread(name, msg`several pictures`);
  if (levelCount > MAX_LEVELS) throw damaged(name, msg`too many levels`);
}

function pixelsOf(file: KTX2Container, name: LocalizedText): DecodedImage {
  const { supercompressionScheme: scheme, vkFormat, dataFormatDescriptor } = file;
  const model = dataFormatDescriptor[0]?.colorModel;
  if (scheme === BASIS_LZ && model === ETC1S) return etc1sPixels(file);
  if (scheme !== NO_COMPRESSION && scheme !== ZSTD) throw unread(name, msg`supercompression ${scheme}`);
  if (model === UASTC) return uastcPixels(file);
  const places = PLAIN_FORMATS[vkFormat];
  if (!places) throw unread(name, msg`format ${vkFormat} of Vulkan`);
  return plainPixels(file, places);
}

/** The bytes of the largest level. */
function levelBytes({ levels: [level], supercompressionScheme }: KTX2Container, size: number): Uint8Array {
  const { levelData, uncompressedByteLength } = level;
  const isCompressed = supercompressionScheme === ZSTD;
  if ((isCompressed ? uncompressedByteLength : levelData.length) < size) throw new MessageError(msg`it ends too early`);
  // Not more than that is made of it, whatever it says of itself.
  return isCompressed ? decompress(levelData, new Uint8Array(size)) : levelData;
}

function plainPixels(file: KTX2Container, places: readonly number[]): DecodedImage {
  const { pixelWidth: width, pixelHeight: height } = file;
  const from = levelBytes(file, places.length * width * height);
  const data = new Uint8Array(4 * width * height).fill(255);
  for (let i = 0; i < width * height; i++) {
    const at = places.length * i;
    // One channel is grey.
    for (let c = 0; c < 3; c++)
      data[4 * i + c] = places.length === 1 ? from[at] : c < places.length ? from[at + places[c]] : 0;
    if (places.length === 4) data[4 * i + 3] = from[at + 3];
  }
  return { width, height, data };
}

function uastcPixels(file: KTX2Container): DecodedImage {
  const picture = new BlockPicture(file);
  const { columns, rows } = picture;
  const isRedGreen = file.dataFormatDescriptor[0].samples[0]?.channelType === UASTC_RED_RED_RED_GREEN;
  decodeUastc(levelBytes(file, 16 * columns * rows), columns, rows, (x, y, pixels) => {
    picture.set(x, y, (i, c) => pixels[4 * i + c]);
  });
  return isRedGreen ? greenOfAlpha(picture.image) : picture.image;
}

function etc1sPixels(file: KTX2Container): DecodedImage {
  const { globalData, levels } = file;
  const [slices] = globalData?.imageDescs ?? [];
  if (!globalData || !slices) throw new MessageError(msg`its code books are damaged`);
  const books = readCodeBooks(globalData);
  const picture = new BlockPicture(file);
  const bytes = (from: number, length: number): Uint8Array => levels[0].levelData.subarray(from, from + length);
  const { rgbSliceByteOffset, rgbSliceByteLength, alphaSliceByteOffset, alphaSliceByteLength } = slices;
  setSlice(picture, books, bytes(rgbSliceByteOffset, rgbSliceByteLength), [0, 1, 2]);
  if (alphaSliceByteLength === 0) return picture.image;
  // Of a slice for alpha the green counts.
  setSlice(picture, books, bytes(alphaSliceByteOffset, alphaSliceByteLength), [undefined, undefined, undefined, 1]);
  const second = file.dataFormatDescriptor[0].samples[1]?.channelType;
  return second === ETC1S_GREEN ? greenOfAlpha(picture.image) : picture.image;
}

/** `from`: by channel of the picture that of the slice, if it has it. */
function setSlice(
  picture: BlockPicture,
  books: CodeBooks,
  data: Uint8Array,
  from: readonly (number | undefined)[],
): void {
  const { columns, rows } = picture;
  const blocks = readSlice(books, data, columns, rows);
  const { colors, selectors } = books;
  for (let y = 0, at = 0; y < rows; y++)
    for (let x = 0; x < columns; x++, at += 2) {
      const [endpoint, selector] = [12 * blocks[at], 16 * blocks[at + 1]];
      picture.set(x, y, (i, c) => {
        const channel = from[c];
        return channel === undefined ? undefined : colors[endpoint + 3 * selectors[selector + i] + channel];
      });
    }
}

/** Two channels, of which the second is stored as alpha. */
function greenOfAlpha({ width, height, data }: DecodedImage): DecodedImage {
  for (let i = 0; i < data.length; i += 4) {
    data[i + 1] = data[i + 3];
    data[i + 2] = 0;
    data[i + 3] = 255;
  }
  return { width, height, data };
}

/** A picture that is filled block by block; what blocks have beyond its edges is left out. */
class BlockPicture {
  readonly image: DecodedImage;
  readonly columns: number;
  readonly rows: number;

  constructor({ pixelWidth: width, pixelHeight: height }: KTX2Container) {
    this.image = { width, height, data: new Uint8Array(4 * width * height).fill(255) };
    this.columns = Math.ceil(width / 4);
    this.rows = Math.ceil(height / 4);
  }

  /** `value`: of pixel i, row by row, and channel c; undefined leaves what is there. */
  set(column: number, row: number, value: (i: number, c: number) => number | undefined): void {
    const { width, height, data } = this.image;
    const [right, bottom] = [Math.min(4, width - 4 * column), Math.min(4, height - 4 * row)];
    for (let y = 0; y < bottom; y++)
      for (let x = 0; x < right; x++) {
        const at = 4 * (width * (4 * row + y) + 4 * column + x);
        for (let c = 0; c < 4; c++) data[at + c] = value(4 * y + x, c) ?? data[at + c];
      }
  }
}

/** With its first row at the top: `rd` if rows go to the right and down, as is the default. */
function oriented({ width, height, data }: DecodedImage, orientation: string): DecodedImage {
  const [isLeft, isUp] = [orientation.startsWith('l'), orientation[1] === 'u'];
  if (!isLeft && !isUp) return { width, height, data };
  const out = new Uint8Array(data.length);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const from = 4 * (width * (isUp ? height - 1 - y : y) + (isLeft ? width - 1 - x : x));
      out.set(data.subarray(from, from + 4), 4 * (width * y + x));
    }
  return { width, height, data: out };
}
