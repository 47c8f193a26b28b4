import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import type { HuffmanTable } from './entropyBits.ts';
import { SIDE } from './inverseDct.ts';

/** A picture as its frame header says (ITU T.81 B.2.2). */
export interface JpegFrame {
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
  readonly progressive: boolean;
  /** Units of all components together, a row and a column. */
  readonly units: readonly [across: number, down: number];
  readonly components: readonly JpegComponent[];
}

/** A colour component: its blocks, in whole units. */
export interface JpegComponent {
  readonly id: number;
  readonly quantization: number;
  /** Blocks of a unit. */
  readonly across: number;
  readonly down: number;
  /** Blocks that have a part of the picture. */
  readonly columns: number;
  readonly rows: number;
  /** Samples, in rows `stride` long. */
  readonly samples: Uint8Array;
  readonly stride: number;
  /** Of a progressive picture: coefficients of all blocks, 64 each, in rows. */
  readonly coefficients: Int16Array | undefined;
  /** Of the scan that is read. */
  mean?: HuffmanTable;
  waves?: HuffmanTable;
  /** The last block's mean. */
  predicted: number;
}

/** Components and sampling factors that are read. */
const MAX_COMPONENTS = 4;
const MAX_SAMPLING = 4;

/** The frame in the payload of a SOF marker. */
export function jpegFrame(payload: Uint8Array, progressive: boolean): JpegFrame {
  const [bits, h1, h0, w1, w0, count] = payload;
  if (bits !== 8) throw new MessageError(msg`it has ${bits} bits a channel; 8 are read`);
  const [height, width] = [(h1 << 8) | h0, (w1 << 8) | w0];
  if (!(count >= 1 && count <= MAX_COMPONENTS && count !== 2)) throw channelsNotRead(count);
  const parts = Array.from({ length: count }, (_, k) => payload.subarray(6 + 3 * k, 9 + 3 * k));
  const factors = parts.map(([, sampling]) => [sampling >> 4, sampling & 15]);
  if (!factors.flat().every((n) => n >= 1 && n <= MAX_SAMPLING))
    throw new MessageError(msg`its frame header is damaged`);
  const [maxAcross, maxDown] = [0, 1].map((k) => Math.max(...factors.map((factor) => factor[k])));
  const units = [Math.ceil(width / (SIDE * maxAcross)), Math.ceil(height / (SIDE * maxDown))] as const;
  const components = parts.map(([id, , quantization], k): JpegComponent => {
    const [across, down] = factors[k];
    const stride = SIDE * units[0] * across;
    const size = stride * SIDE * units[1] * down;
    return {
      id,
      quantization,
      across,
      down,
      columns: Math.ceil(Math.ceil((width * across) / maxAcross) / SIDE),
      rows: Math.ceil(Math.ceil((height * down) / maxDown) / SIDE),
      samples: new Uint8Array(size),
      stride,
      coefficients: progressive ? new Int16Array(size) : undefined,
      predicted: 0,
    };
  });
  return { width, height, progressive, units, components };
}

export const channelsNotRead = (count: number): MessageError =>
  new MessageError(msg`it has ${count} channels; 1, 3 or 4 are read`);
