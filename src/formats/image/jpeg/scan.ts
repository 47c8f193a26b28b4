import { damaged, EntropyBits, type HuffmanTable } from './entropyBits.ts';
import type { JpegComponent, JpegFrame } from './frame.ts';
import { type BlockPlace, inverseDct, inverseDctOfMean, SIDE } from './inverseDct.ts';

/** Place in a block, in rows, by the order in which coefficients are stored (ITU T.81 figure A.6). */
// biome-ignore format: a table
export const ZIGZAG = Uint8Array.of(
  0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7, 14, 21, 28,
  35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63,
);
const BLOCK = SIDE * SIDE;

/** What a scan has (ITU T.81 B.2.3). */
export interface JpegScan {
  readonly components: readonly JpegComponent[];
  /** Coefficients, first and last, in their order. */
  readonly band: readonly [first: number, last: number];
  /** Bits that are still missing after the scan before and after this one. */
  readonly missing: readonly [before: number, after: number];
  /** Units between restarts; 0: no restarts. */
  readonly restartInterval: number;
  /** By number. */
  readonly steps: readonly (Uint16Array | undefined)[];
}

type ReadBlock = (component: JpegComponent, block: number) => void;

/** Reads the codes of a scan, which begin at `at`; returns where they end. */
export function readScan(bytes: Uint8Array, at: number, frame: JpegFrame, scan: JpegScan): number {
  const bits = new EntropyBits(bytes, at);
  const reader = frame.progressive ? progressiveReader(bits, scan) : sequentialReader(bits, scan);
  const { components, restartInterval } = scan;
  const alone = components.length === 1 ? components[0] : undefined;
  const [across, down] = alone ? [alone.columns, alone.rows] : frame.units;
  const units = across * down;
  for (let unit = 0; unit < units; unit++) {
    if (restartInterval > 0 && unit > 0 && unit % restartInterval === 0) {
      if (!isRestart(bytes, bits.at)) break;
      bits.at += 2;
      bits.restart();
      reader.restart();
      for (const component of components) component.predicted = 0;
    }
    const [x, y] = [unit % across, Math.floor(unit / across)];
    if (alone) reader.read(alone, x + (y * alone.stride) / SIDE);
    else for (const component of components) readUnit(component, x, y, reader.read);
    bits.check();
  }
  return bits.at;
}

/** All blocks of a component in a unit. */
function readUnit(component: JpegComponent, x: number, y: number, read: ReadBlock): void {
  const { across, down, stride } = component;
  for (let v = 0; v < down; v++)
    for (let h = 0; h < across; h++) read(component, x * across + h + ((y * down + v) * stride) / SIDE);
}

const isRestart = (bytes: Uint8Array, at: number): boolean => bytes[at] === 0xff && (bytes[at + 1] & 0xf8) === 0xd0;

interface BlockReader {
  readonly read: ReadBlock;
  restart(): void;
}

/** Where the samples of a block are. */
export function blockPlace({ samples, stride }: JpegComponent, block: number): BlockPlace {
  const columns = stride / SIDE;
  return { samples, at: Math.floor(block / columns) * SIDE * stride + (block % columns) * SIDE, stride };
}

/** T.81 F.2: each block is whole, so it is transformed at once. */
function sequentialReader(bits: EntropyBits, { steps }: JpegScan): BlockReader {
  const coefficients = new Int16Array(BLOCK);
  const read: ReadBlock = (component, block) => {
    const of = needed(steps[component.quantization]);
    const waves = needed(component.waves);
    component.predicted += bits.signed(bits.symbol(needed(component.mean)));
    coefficients[0] = component.predicted;
    let isFlat = true;
    for (let k = 1; k < BLOCK; k++) {
      const code = bits.symbol(waves);
      const size = code & 15;
      if (size === 0 && code < 0xf0) break;
      k += code >> 4;
      const value = size > 0 ? bits.signed(size) : 0;
      if (k >= BLOCK || value === 0) continue;
      coefficients[ZIGZAG[k]] = value;
      isFlat = false;
    }
    if (isFlat) inverseDctOfMean(coefficients[0] * of[0], blockPlace(component, block));
    else {
      inverseDct(coefficients, 0, of, blockPlace(component, block));
      coefficients.fill(0);
    }
  };
  return { read, restart: () => {} };
}

/** T.81 G.2: each scan adds coefficients, or bits to them. */
function progressiveReader(
  bits: EntropyBits,
  { band: [first, last], missing: [before, after] }: JpegScan,
): BlockReader {
  /** Blocks that have no more in this scan. */
  let empty = 0;
  const meanFirst: ReadBlock = (component, block) => {
    component.predicted += bits.signed(bits.symbol(needed(component.mean))) << after;
    component.coefficients![BLOCK * block] = component.predicted;
  };
  const meanMore: ReadBlock = ({ coefficients }, block) => {
    coefficients![BLOCK * block] |= bits.bits(1) << after;
  };
  const wavesFirst: ReadBlock = ({ coefficients, waves }, block) => {
    if (empty > 0) {
      empty--;
      return;
    }
    const table = needed(waves);
    for (let k = first; k <= last; k++) {
      const code = bits.symbol(table);
      const size = code & 15;
      if (size === 0 && code < 0xf0) {
        empty = (1 << (code >> 4)) + bits.bits(code >> 4) - 1;
        return;
      }
      k += code >> 4;
      const value = size > 0 ? bits.signed(size) : 0;
      if (k <= last) coefficients![BLOCK * block + ZIGZAG[k]] = value * (1 << after);
    }
  };
  const wavesMore: ReadBlock = ({ coefficients, waves }, block) => {
    const of = coefficients!;
    const table = needed(waves);
    const one = 1 << after;
    /** Adds a bit to a coefficient that is not 0. */
    const refine = (i: number): void => {
      if (bits.bits(1) === 1) of[i] += of[i] > 0 ? one : -one;
    };
    let k = first;
    while (k <= last && empty === 0) {
      const code = bits.symbol(table);
      let zeros = code >> 4;
      if ((code & 15) === 0 && zeros < 15) {
        empty = (1 << zeros) + bits.bits(zeros);
        break;
      }
      const value = (code & 15) === 0 ? 0 : bits.bits(1) === 1 ? one : -one;
      // Past the zeros that are skipped, to the one that is set.
      for (; k <= last; k++) {
        const i = BLOCK * block + ZIGZAG[k];
        if (of[i] !== 0) refine(i);
        else if (zeros-- === 0) {
          of[i] = value;
          break;
        }
      }
      k++;
    }
    if (empty === 0) return;
    for (; k <= last; k++) {
      const i = BLOCK * block + ZIGZAG[k];
      if (of[i] !== 0) refine(i);
    }
    empty--;
  };
  const isFirst = before === 0;
  const read = first === 0 ? (isFirst ? meanFirst : meanMore) : isFirst ? wavesFirst : wavesMore;
  const restart = (): void => {
    empty = 0;
  };
  return { read, restart };
}

/** A table that the file has to have. */
function needed<T extends HuffmanTable | Uint16Array>(table: T | undefined): T {
  if (!table) throw damaged();
  return table;
}
