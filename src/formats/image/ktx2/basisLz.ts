import type { KTX2Container } from 'ktx-parse';
import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { BitReader, HuffmanCode } from './bits.ts';

// ETC1S with BasisLZ, as of the KTX 2.0 specification: "BasisLZ Bitstream", and Basis Universal's "ETC1S Texture Video Specification".

type GlobalData = NonNullable<KTX2Container['globalData']>;

/** Most entries of a code book. */
const MAX_ENTRIES = 2 ** 16;
/** Differences from the base colour, by table, for the selectors 0 to 3. */
const INTENSITIES = [
  [-8, -2, 2, 8],
  [-17, -5, 5, 17],
  [-29, -9, 9, 29],
  [-42, -13, 13, 42],
  [-60, -18, 18, 60],
  [-80, -24, 24, 80],
  [-106, -33, 33, 106],
  [-183, -47, 47, 183],
];

/** What blocks of all pictures of a file are made of. */
export interface CodeBooks {
  /** By endpoint the four colours of a block, 3 bytes each. */
  readonly colors: Uint8Array;
  /** By selector and pixel, row by row, which of the four. */
  readonly selectors: Uint8Array;
  readonly tables: BlockTables;
}

interface BlockTables {
  readonly predictors: HuffmanCode;
  readonly endpointSteps: HuffmanCode;
  readonly selectors: HuffmanCode;
  readonly runs: HuffmanCode;
  readonly historySize: number;
}

/** Reads the code books that all pictures of a file share. */
export function readCodeBooks({ endpointCount, selectorCount, ...data }: GlobalData): CodeBooks {
  if (!(endpointCount > 0 && selectorCount > 0 && endpointCount <= MAX_ENTRIES && selectorCount <= MAX_ENTRIES))
    throw new MessageError(msg`its code books are damaged`);
  return {
    colors: readEndpoints(new BitReader(data.endpointsData), endpointCount),
    selectors: readSelectors(new BitReader(data.selectorsData), selectorCount),
    tables: readTables(new BitReader(data.tablesData)),
  };
}

/** Each endpoint is a difference from the one before; by the size of that, another code is used. */
function readEndpoints(bits: BitReader, count: number): Uint8Array {
  const steps = [readCode(bits), readCode(bits), readCode(bits)];
  const intensitySteps = readCode(bits);
  const channels = bits.read(1) === 1 ? 1 : 3;
  const out = new Uint8Array(12 * count);
  const base = [16, 16, 16];
  let table = 0;
  for (let e = 0; e < count; e++) {
    table = (table + intensitySteps.read(bits)) & 7;
    for (let c = 0; c < channels; c++) {
      const code = base[c] <= 9 ? steps[0] : base[c] <= 21 ? steps[1] : steps[2];
      base[c] = (base[c] + code.read(bits)) & 31;
    }
    if (channels === 1) base[1] = base[2] = base[0];
    for (let s = 0; s < 4; s++)
      for (let c = 0; c < 3; c++) {
        const full = (base[c] << 3) | (base[c] >> 2);
        out[12 * e + 3 * s + c] = Math.min(255, Math.max(0, full + INTENSITIES[table][s]));
      }
  }
  return out;
}

/** Four bytes each, a row of four pixels of 2 bits. */
function readSelectors(bits: BitReader, count: number): Uint8Array {
  const [isGlobal, isHybrid, isRaw] = [bits.read(1), bits.read(1), bits.read(1)];
  if (isGlobal || isHybrid) throw new MessageError(msg`its code books are damaged`);
  const changes = isRaw ? undefined : readCode(bits);
  const out = new Uint8Array(16 * count);
  const rows = [0, 0, 0, 0];
  for (let s = 0; s < count; s++)
    for (let y = 0; y < 4; y++) {
      rows[y] = s === 0 || !changes ? bits.read(8) : rows[y] ^ changes.read(bits);
      for (let x = 0; x < 4; x++) out[16 * s + 4 * y + x] = (rows[y] >> (2 * x)) & 3;
    }
  return out;
}

const readTables = (bits: BitReader): BlockTables => ({
  predictors: readCode(bits),
  endpointSteps: readCode(bits),
  selectors: readCode(bits),
  runs: readCode(bits),
  historySize: bits.read(13),
});

/** The order in which lengths of code words are described. */
const LENGTH_ORDER = [17, 18, 19, 20, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15, 16];

/** A code by the lengths of its words, which are coded themselves, with runs of zeros and of the last length. */
function readCode(bits: BitReader): HuffmanCode {
  const lengths = new Uint8Array(bits.read(14));
  if (lengths.length === 0) return new HuffmanCode(lengths);
  const described = bits.read(5);
  if (described < 1 || described > LENGTH_ORDER.length) throw new MessageError(msg`its codes are damaged`);
  const ofLengths = new Uint8Array(LENGTH_ORDER.length);
  for (let i = 0; i < described; i++) ofLengths[LENGTH_ORDER[i]] = bits.read(3);
  const code = new HuffmanCode(ofLengths);
  for (let at = 0; at < lengths.length; ) {
    const symbol = code.read(bits);
    if (symbol <= 16) lengths[at++] = symbol;
    else {
      const run = RUNS[symbol - 17];
      const value = run.repeats ? lengths[at - 1] : 0;
      const end = at + run.least + bits.read(run.bits);
      if (end > lengths.length || value === undefined || (run.repeats && value === 0))
        throw new MessageError(msg`its codes are damaged`);
      lengths.fill(value, at, end);
      at = end;
    }
  }
  return new HuffmanCode(lengths);
}

const RUNS = [
  { repeats: false, least: 3, bits: 3 },
  { repeats: false, least: 11, bits: 7 },
  { repeats: true, least: 3, bits: 2 },
  { repeats: true, least: 7, bits: 7 },
];

/** For four blocks together: that the last predictors are repeated. */
const REPEAT_PREDICTORS = 256;
const MIN_REPEATS = 3;
const MIN_RUN = 3;
const LONG_RUN = 63;

/** How the endpoint of a block is found. */
const [LEFT, ABOVE, ABOVE_LEFT] = [0, 1, 2];

/**
 * One picture of blocks, row by row: the endpoint and the selector of each. Endpoints are mostly those of neighbours, which is said for two by two blocks
 * together; selectors mostly those that were used shortly before.
 */
export function readSlice(books: CodeBooks, data: Uint8Array, columns: number, rows: number): Uint32Array {
  const { predictors, endpointSteps, selectors, runs, historySize } = books.tables;
  const [endpointCount, selectorCount] = [books.colors.length / 12, books.selectors.length / 16];
  const bits = new BitReader(data);
  const out = new Uint32Array(2 * columns * rows);
  const history = new RecentSelectors(historySize);
  /** By column, the predictors of the two blocks of the next row. */
  const below = new Uint8Array(columns + 1);
  let [repeats, lastPredictors, endpoint, run] = [0, 0, 0, 0];
  for (let y = 0; y < rows; y++)
    for (let x = 0, predictor = 0; x < columns; x++, predictor >>= 2) {
      if (x % 2 === 0) {
        if (y % 2 === 1) predictor = below[x];
        else {
          if (repeats > 0) repeats--;
          else {
            const symbol = predictors.read(bits);
            if (symbol === REPEAT_PREDICTORS) repeats = bits.readVariable(4) + MIN_REPEATS - 1;
            else lastPredictors = symbol;
          }
          predictor = lastPredictors;
          below[x] = (lastPredictors >> 4) & 15;
        }
      }
      const at = 2 * (columns * y + x);
      const how = predictor & 3;
      if ((how === LEFT && x === 0) || (how === ABOVE && y === 0) || (how === ABOVE_LEFT && (x === 0 || y === 0)))
        throw new MessageError(msg`a block is damaged`);
      if (how === ABOVE) endpoint = out[at - 2 * columns];
      else if (how === ABOVE_LEFT) endpoint = out[at - 2 * columns - 2];
      else if (how !== LEFT) endpoint = (endpoint + endpointSteps.read(bits)) % endpointCount;
      out[at] = endpoint;

      let symbol = selectorCount;
      if (run > 0) run--;
      else {
        symbol = selectors.read(bits);
        if (symbol === selectorCount + historySize) {
          const length = runs.read(bits);
          run = MIN_RUN + (length === LONG_RUN ? bits.readVariable(7) : length) - 1;
          symbol = selectorCount;
        }
      }
      if (symbol > selectorCount + historySize) throw new MessageError(msg`a block is damaged`);
      if (symbol < selectorCount) history.add(symbol);
      out[at + 1] = symbol < selectorCount ? symbol : history.use(symbol - selectorCount);
    }
  return out;
}

/** Selectors that were used before, those used most in front, approximately. */
class RecentSelectors {
  private readonly values: Uint32Array;
  private next: number;

  constructor(size: number) {
    this.values = new Uint32Array(size);
    this.next = size >> 1;
  }

  add(selector: number): void {
    if (this.values.length === 0) return;
    this.values[this.next++] = selector;
    if (this.next === this.values.length) this.next = this.values.length >> 1;
  }

  use(index: number): number {
    if (index >= this.values.length) throw new MessageError(msg`a block is damaged`);
    const selector = this.values[index];
    const ahead = index >> 1;
    this.values[index] = this.values[ahead];
    this.values[ahead] = selector;
    return selector;
  }
}
