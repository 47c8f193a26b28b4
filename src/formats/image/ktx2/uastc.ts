import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { BitReader } from './bits.ts';

// UASTC LDR 4 × 4: a subset of ASTC with modes of its own. Khronos Data Format Specification 1.3, "UASTC Compressed Texture Image Format" and "ASTC".

/** How a block of a mode is divided into bits. */
interface BlockMode {
  /** Its prefix code, the first bit lowest. */
  readonly code: number;
  /** [bits] */
  readonly codeLength: number;
  /** Bits for other programs that come next. */
  readonly hints: number;
  /** 2: luminance and alpha. */
  readonly components: 2 | 3 | 4;
  /** How endpoints are coded: the number of their levels is 2^bits, 3 · 2^bits or 5 · 2^bits. */
  readonly endpoints: { readonly bits: number; readonly digits: 1 | 3 | 5 };
  /** [bits] */
  readonly weights: number;
  /** Seeds of the ways in which blocks are divided into parts; absent for a single part. */
  readonly partitions?: { readonly parts: 2 | 3; readonly seeds: readonly number[]; readonly bits: number };
  /** One component has weights of its own: the one that is said, or alpha. */
  readonly plane?: 'said' | 'alpha';
}

// prettier-ignore
const TWO_PARTS = {
  parts: 2,
  bits: 5,
  seeds: [
    28, 20, 16, 29, 91, 9, 107, 72, 149, 204, 50, 114, 496, 17, 78, 39, 252, 828, 43, 156, 116, 210, 476, 273, 684, 359,
    246, 195, 694, 524,
  ],
} as const;
// prettier-ignore
const TWO_PARTS_OF_BC7_3 = {
  parts: 2,
  bits: 5,
  seeds: [36, 48, 61, 137, 161, 183, 226, 281, 302, 307, 479, 495, 593, 594, 605, 799, 812, 988, 993],
} as const;
const THREE_PARTS = { parts: 3, bits: 4, seeds: [260, 74, 32, 156, 183, 15, 745, 0, 335, 902, 254] } as const;

const levels = (bits: number, digits: 1 | 3 | 5 = 1) => ({ bits, digits });

/** The mode of one colour for all pixels. */
const SOLID = 8;
const MODES: readonly BlockMode[] = [
  { code: 0x01, codeLength: 4, hints: 15, components: 3, endpoints: levels(6, 3), weights: 4 },
  { code: 0x35, codeLength: 6, hints: 15, components: 3, endpoints: levels(8), weights: 2 },
  { code: 0x1d, codeLength: 5, hints: 15, components: 3, endpoints: levels(4), weights: 3, partitions: TWO_PARTS },
  { code: 0x03, codeLength: 5, hints: 15, components: 3, endpoints: levels(2, 3), weights: 2, partitions: THREE_PARTS },
  { code: 0x13, codeLength: 5, hints: 15, components: 3, endpoints: levels(3, 5), weights: 2, partitions: TWO_PARTS },
  { code: 0x0b, codeLength: 5, hints: 15, components: 3, endpoints: levels(8), weights: 3 },
  { code: 0x1b, codeLength: 5, hints: 15, components: 3, endpoints: levels(5, 5), weights: 2, plane: 'said' },
  {
    code: 0x07,
    codeLength: 5,
    hints: 15,
    components: 3,
    endpoints: levels(3, 5),
    weights: 2,
    partitions: TWO_PARTS_OF_BC7_3,
  },
  { code: 0x17, codeLength: 5, hints: 0, components: 4, endpoints: levels(8), weights: 0 },
  { code: 0x0f, codeLength: 5, hints: 23, components: 4, endpoints: levels(4), weights: 2, partitions: TWO_PARTS },
  { code: 0x02, codeLength: 3, hints: 17, components: 4, endpoints: levels(4, 3), weights: 4 },
  { code: 0x00, codeLength: 2, hints: 17, components: 4, endpoints: levels(4, 3), weights: 2, plane: 'said' },
  { code: 0x06, codeLength: 3, hints: 17, components: 4, endpoints: levels(6, 3), weights: 3 },
  { code: 0x1f, codeLength: 5, hints: 23, components: 4, endpoints: levels(8), weights: 1, plane: 'said' },
  { code: 0x0d, codeLength: 5, hints: 23, components: 4, endpoints: levels(8), weights: 2 },
  { code: 0x05, codeLength: 7, hints: 23, components: 2, endpoints: levels(8), weights: 4 },
  { code: 0x15, codeLength: 6, hints: 23, components: 2, endpoints: levels(8), weights: 2, partitions: TWO_PARTS },
  { code: 0x25, codeLength: 6, hints: 23, components: 2, endpoints: levels(8), weights: 2, plane: 'alpha' },
  { code: 0x09, codeLength: 4, hints: 15, components: 3, endpoints: levels(5), weights: 5 },
];

/** The longest prefix code [bits]. */
const PREFIX = 7;
/** By the first bits of a block its mode; undefined where there is none. */
const MODE_OF_PREFIX = Array.from({ length: 1 << PREFIX }, (_, bits) =>
  MODES.find(({ code, codeLength }) => (bits & ((1 << codeLength) - 1)) === code),
);

const BLOCK_BYTES = 16;
const PIXELS = 16;

/** Decodes blocks of 4 × 4 pixels to RGBA. `write`: is given the place of a block and its 16 pixels row by row, in one array for all. */
export function decodeUastc(
  data: Uint8Array,
  columns: number,
  rows: number,
  write: (column: number, row: number, pixels: Uint8Array) => void,
): void {
  if (data.length < BLOCK_BYTES * columns * rows) throw new MessageError(msg`it ends too early`);
  const pixels = new Uint8Array(4 * PIXELS);
  for (let y = 0, at = 0; y < rows; y++)
    for (let x = 0; x < columns; x++, at += BLOCK_BYTES) {
      decodeBlock(data.subarray(at, at + BLOCK_BYTES), pixels);
      write(x, y, pixels);
    }
}

function decodeBlock(block: Uint8Array, out: Uint8Array): void {
  const mode = MODE_OF_PREFIX[block[0] & ((1 << PREFIX) - 1)];
  if (!mode) throw new MessageError(msg`a block is damaged`);
  const bits = new BitReader(block);
  bits.read(mode.codeLength);
  if (mode === MODES[SOLID]) {
    const color = [bits.read(8), bits.read(8), bits.read(8), bits.read(8)];
    for (let i = 0; i < 4 * PIXELS; i++) out[i] = color[i % 4];
    return;
  }
  bits.read(mode.hints);
  const { partitions, plane, components } = mode;
  const part = partitions && partitionOf(partitions, bits.read(partitions.bits));
  const separate = plane === 'said' ? bits.read(2) : plane === 'alpha' ? 3 : -1;
  const endpoints = readEndpoints(bits, mode, 2 * components * (partitions?.parts ?? 1));
  const planes = plane ? 2 : 1;
  let seen = 0;
  for (let i = 0; i < PIXELS; i++) {
    const own = part?.[i] ?? 0;
    // The first pixel of each part has a bit less, which is 0.
    const isFirst = (seen & (1 << own)) === 0;
    seen |= 1 << own;
    const weight = [0, 0];
    for (let p = 0; p < planes; p++)
      weight[p] = expandedWeight(bits.read(mode.weights - (isFirst ? 1 : 0)), mode.weights);
    for (let c = 0; c < 4; c++) {
      const w = c === separate ? weight[1] : weight[0];
      out[4 * i + c] = componentAt(endpoints, 2 * components * own, components, c, w);
    }
  }
}

/** Between the two endpoints of a component; luminance counts for red, green and blue, and what is not there is 255. */
function componentAt(endpoints: Uint8Array, from: number, components: number, c: number, weight: number): number {
  const index = components === 2 ? (c === 3 ? 1 : 0) : c;
  if (index >= components) return 255;
  const [low, high] = [257 * endpoints[from + 2 * index], 257 * endpoints[from + 2 * index + 1]];
  return ((low * (64 - weight) + high * weight + 32) >> 6) >> 8;
}

/** 0 to 64: six bits, of which the upper half is moved up by 1. */
function expandedWeight(value: number, bits: number): number {
  const six = repeated(value, bits, 6);
  return six > 32 ? six + 1 : six;
}

/** The bits of a number over and over, as many as are wanted, from the highest. */
function repeated(value: number, bits: number, wanted: number): number {
  let out = 0;
  for (let shift = wanted - bits; shift > -bits; shift -= bits) out |= shift >= 0 ? value << shift : value >> -shift;
  return out;
}

/** Endpoints to 0 … 255. Digits of base 3 or 5, five or three together, come before the bits of all. */
function readEndpoints(bits: BitReader, { endpoints: { bits: low, digits } }: BlockMode, count: number): Uint8Array {
  const together = digits === 3 ? 5 : 3;
  const groups: number[] = [];
  if (digits > 1)
    for (let left = count; left > 0; left -= together)
      groups.push(bits.read(Math.ceil(Math.min(left, together) * Math.log2(digits))));
  const out = new Uint8Array(count);
  for (let i = 0; i < count; i++) {
    const digit = digits > 1 ? Math.floor(groups[Math.floor(i / together)] / digits ** (i % together)) % digits : 0;
    out[i] = expandedEndpoint(bits.read(low), digit, low, digits);
  }
  return out;
}

/** By number of bits and base: the factor of the digit; and which bit, from the lowest as 1, is at each of the nine places from the highest. */
const DIGIT_ENDPOINTS: Readonly<Record<string, { readonly factor: number; readonly places: readonly number[] }>> = {
  '2 3': { factor: 93, places: [2, 0, 0, 0, 2, 0, 2, 2, 0] },
  '4 3': { factor: 22, places: [4, 3, 2, 0, 0, 0, 4, 3, 2] },
  '6 3': { factor: 5, places: [6, 5, 4, 3, 2, 0, 0, 0, 6] },
  '3 5': { factor: 26, places: [3, 2, 0, 0, 0, 0, 3, 2, 3] },
  '5 5': { factor: 6, places: [5, 4, 3, 2, 0, 0, 0, 0, 5] },
};

/** ASTC, "Endpoint Unquantization". */
function expandedEndpoint(value: number, digit: number, bits: number, digits: number): number {
  if (digits === 1) return repeated(value, bits, 8);
  const { factor, places } = DIGIT_ENDPOINTS[`${bits} ${digits}`];
  const all = (value & 1) * 511;
  const b = places.reduce((sum, place) => (sum << 1) | (place > 0 ? (value >> (place - 1)) & 1 : 0), 0);
  const t = (digit * factor + b) ^ all;
  return (all & 0x80) | (t >> 2);
}

const PARTITIONS = new Map<string, Uint8Array>();

/** By pixel its part. */
function partitionOf({ seeds, parts }: NonNullable<BlockMode['partitions']>, index: number): Uint8Array {
  const seed = seeds[index];
  if (seed === undefined) throw new MessageError(msg`a block is damaged`);
  const key = `${parts} ${seed}`;
  const known =
    PARTITIONS.get(key) ?? Uint8Array.from({ length: PIXELS }, (_, i) => partAt(seed, i % 4, i >> 2, parts));
  PARTITIONS.set(key, known);
  return known;
}

/** ASTC, "Partition Pattern Generation", for small blocks. */
function partAt(seed: number, x: number, y: number, parts: 2 | 3): number {
  const number = hash(seed + 1024 * (parts - 1));
  const square = (shift: number): number => ((number >>> shift) & 15) ** 2;
  const small = (seed & 2) === 0 ? 5 : 4;
  const large = parts === 3 ? 6 : 5;
  const [even, odd] = (seed & 1) === 1 ? [small, large] : [large, small];
  const plane = (first: number, add: number): number =>
    ((square(first) >> even) * 2 * x + (square(first + 4) >> odd) * 2 * y + (number >>> add)) & 63;
  const [a, b, c] = [plane(0, 14), plane(8, 10), parts === 3 ? plane(16, 6) : 0];
  if (a >= b && a >= c) return 0;
  return b >= c ? 1 : 2;
}

function hash(seed: number): number {
  let p = seed;
  p ^= p >>> 15;
  p = (p - (p << 17)) >>> 0;
  p = (p + (p << 7)) >>> 0;
  p = (p + (p << 4)) >>> 0;
  p ^= p >>> 5;
  p = (p + (p << 16)) >>> 0;
  p ^= p >>> 7;
  p ^= p >>> 3;
  p ^= p << 6;
  p ^= p >>> 17;
  return p >>> 0;
}
