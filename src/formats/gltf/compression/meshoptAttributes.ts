import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { ByteReader, unzigzag } from './meshoptBytes.ts';

/**
 * The attribute codec of EXT_meshopt_compression (appendix A, mode 0), and its second version of KHR_meshopt_compression:
 * bytes as differences from the element before, byte plane by byte plane, in blocks of at most 256 elements and groups of 16.
 */

const GROUP = 16;
const BLOCK_BYTES = 8192;
const BLOCK_ELEMENTS = 256;
/** The end of the data is padded to this many bytes, by version. */
const TAIL_BYTES = [32, 24] as const;
/** Bits per difference for each of a group's four modes: version 0, and version 1 with plane control 0 and 1. */
const GROUP_BITS = [
  [0, 2, 4, 8],
  [0, 1, 2, 4],
  [1, 2, 4, 8],
] as const;
/** Control codes of version 1 for a whole byte plane. */
const ALL_ZERO = 2;
const VERBATIM = 3;

interface Layout {
  readonly version: number;
  readonly stride: number;
  /** The element before the first one. */
  readonly baseline: Uint8Array;
  /** Version 1: how each run of four bytes is differenced. */
  readonly channels: Uint8Array | undefined;
  readonly dataEnd: number;
}

/**
 * Elements of `stride` bytes (a multiple of 4, at most 256). Throws an Error that names the byte where the data is damaged.
 *
 * @returns count × stride bytes
 */
export function decodeAttributes(data: Uint8Array, count: number, stride: number): Uint8Array<ArrayBuffer> {
  const layout = readLayout(data, stride);
  const out = new Uint8Array(count * stride);
  const blockSize = Math.min(Math.floor(BLOCK_BYTES / stride) & ~(GROUP - 1), BLOCK_ELEMENTS);
  const planes = new Uint8Array(blockSize * stride);
  const reader = new ByteReader(data, 1, layout.dataEnd);
  const before = layout.baseline.slice();
  for (let first = 0; first < count; first += blockSize) {
    const size = Math.min(count - first, blockSize);
    readPlanes(reader, layout, planes, size, blockSize);
    for (let i = 0; i < size; i++) {
      addDifferences(layout, planes, blockSize, i, before);
      out.set(before, (first + i) * stride);
    }
  }
  if (reader.at !== layout.dataEnd)
    throw new MessageError(msg`holds ${layout.dataEnd - reader.at} bytes more than it needs`);
  return out;
}

function readLayout(data: Uint8Array, stride: number): Layout {
  const version = data[0] - 0xa0;
  if (version !== 0 && version !== 1) throw new MessageError(msg`begins with byte ${data[0]}, not with 160 or 161`);
  const used = version === 0 ? stride : stride + stride / 4;
  const dataEnd = data.length - Math.max(used, TAIL_BYTES[version]);
  if (dataEnd < 1) throw new MessageError(msg`of ${data.length} bytes is shorter than its own end`);
  const tail = data.subarray(data.length - used);
  const channels = version === 0 ? undefined : tail.subarray(stride);
  const odd = channels?.findIndex((channel) => (channel & 3) === 3) ?? -1;
  if (odd >= 0) throw new MessageError(msg`differences channel ${odd} in an unknown way`);
  return { version, stride, baseline: tail.subarray(0, stride), channels, dataEnd };
}

/** Differences of one block: plane after plane, `blockSize` apart. */
function readPlanes(
  reader: ByteReader,
  { version, stride }: Layout,
  planes: Uint8Array,
  size: number,
  blockSize: number,
): void {
  const controls = version === 0 ? undefined : reader.take(stride / 4);
  planes.fill(0);
  for (let plane = 0; plane < stride; plane++) {
    const control = controls ? (controls[plane >> 2] >> (2 * (plane & 3))) & 3 : 0;
    if (control === ALL_ZERO) continue;
    if (control === VERBATIM) planes.set(reader.take(size), plane * blockSize);
    else readGroups(reader, GROUP_BITS[version === 0 ? 0 : control + 1], planes, plane * blockSize, size);
  }
}

function readGroups(
  reader: ByteReader,
  bitsOfMode: readonly number[],
  planes: Uint8Array,
  start: number,
  size: number,
): void {
  const groups = Math.ceil(size / GROUP);
  const modes = reader.take(Math.ceil(groups / 4));
  for (let g = 0; g < groups; g++) {
    const bits = bitsOfMode[(modes[g >> 2] >> (2 * (g & 3))) & 3];
    const at = start + g * GROUP;
    if (bits === 8) planes.set(reader.take(GROUP), at);
    else if (bits > 0) readPacked(reader, bits, planes, at);
  }
}

/** Sixteen differences of `bits` bits; the maximum value is an escape for a following byte. */
function readPacked(reader: ByteReader, bits: number, planes: Uint8Array, at: number): void {
  const packed = reader.take((GROUP * bits) / 8);
  const perByte = 8 / bits;
  const whole = (1 << bits) - 1;
  for (let i = 0; i < GROUP; i++) {
    const place = i % perByte;
    // Single bits are packed from the lowest, wider ones from the highest.
    const shift = bits === 1 ? place : 8 - bits * (place + 1);
    const value = (packed[Math.floor(i / perByte)] >> shift) & whole;
    planes[at + i] = value === whole ? reader.byte() : value;
  }
}

/** Updates `before` to the block's element `i`. */
function addDifferences(
  { stride, channels }: Layout,
  planes: Uint8Array,
  blockSize: number,
  i: number,
  before: Uint8Array,
): void {
  const difference = (k: number): number => planes[k * blockSize + i];
  for (let k = 0; k < stride; k += 4) {
    const channel = channels ? channels[k >> 2] : 0;
    if ((channel & 3) === 0) for (let j = k; j < k + 4; j++) before[j] += unzigzag(difference(j));
    else if ((channel & 3) === 1) for (let j = k; j < k + 4; j += 2) addWord(before, j, difference);
    else flipBits(before, k, difference, channel >> 4);
  }
}

function addWord(before: Uint8Array, k: number, difference: (k: number) => number): void {
  const sum = (before[k] | (before[k + 1] << 8)) + unzigzag(difference(k) | (difference(k + 1) << 8));
  before[k] = sum;
  before[k + 1] = sum >> 8;
}

/** Four bytes as XOR, rotated left by `turn` bits. */
function flipBits(before: Uint8Array, k: number, difference: (k: number) => number, turn: number): void {
  const turned = difference(k) | (difference(k + 1) << 8) | (difference(k + 2) << 16) | (difference(k + 3) << 24);
  const flipped = turn === 0 ? turned : (turned >>> turn) | (turned << (32 - turn));
  for (let j = 0; j < 4; j++) before[k + j] ^= flipped >>> (8 * j);
}
