import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { type ColorEncoding, jpegColors } from './colors.ts';
import { damaged, type HuffmanTable, makeHuffmanTable } from './entropyBits.ts';
import { type JpegComponent, type JpegFrame, jpegFrame } from './frame.ts';
import { inverseDct, SIDE } from './inverseDct.ts';
import { blockPlace, readScan, ZIGZAG } from './scan.ts';

/** Scans that are read: a progressive picture has about ten, and one of no bytes costs as much time as any. */
const MAX_SCANS = 256;

/** What the segments before a scan say. */
interface JpegState {
  readonly means: (HuffmanTable | undefined)[];
  readonly waves: (HuffmanTable | undefined)[];
  readonly steps: (Uint16Array | undefined)[];
  restartInterval: number;
  frame?: JpegFrame;
  hasJfif: boolean;
  /** Of the segment that Adobe's programs write. */
  adobe?: number;
  scans: number;
}

/** Decodes a JPEG to RGBA, rows from the top. `checkSize` is called before memory is taken. Throws a MessageError. */
export function decodeJpeg(
  bytes: Uint8Array,
  checkSize: (width: number, height: number) => void,
): { width: number; height: number; data: Uint8Array } {
  const state: JpegState = { means: [], waves: [], steps: [], restartInterval: 0, hasJfif: false, scans: 0 };
  let at = 2;
  for (;;) {
    at = nextMarker(bytes, at);
    const marker = bytes[at - 1];
    if (at > bytes.length || marker === END) break;
    if (marker === 0x01 || (marker >= 0xd0 && marker <= 0xd8)) continue;
    const length = (bytes[at] << 8) | bytes[at + 1];
    const payload = bytes.subarray(at + 2, at + length);
    if (!(length >= 2 && at + length <= bytes.length)) throw damaged();
    at += length;
    if (marker === START_OF_SCAN) at = readOneScan(bytes, at, payload, state);
    else readSegment(marker, payload, state, checkSize);
  }
  const { frame } = state;
  if (!frame) throw new MessageError(msg`no frame header`);
  if (state.scans === 0) throw damaged();
  if (frame.progressive) for (const component of frame.components) transform(component, state);
  return { width: frame.width, height: frame.height, data: jpegColors(frame, encodingOf(frame, state)) };
}

const [END, START_OF_SCAN] = [0xd9, 0xda];

/** The offset behind the next marker; beyond the end if there is none. */
function nextMarker(bytes: Uint8Array, from: number): number {
  let at = from;
  while (at + 1 < bytes.length && (bytes[at] !== 0xff || bytes[at + 1] === 0 || bytes[at + 1] === 0xff)) at++;
  return at + 1 < bytes.length ? at + 2 : bytes.length + 1;
}

function readSegment(
  marker: number,
  payload: Uint8Array,
  state: JpegState,
  checkSize: (width: number, height: number) => void,
): void {
  switch (marker) {
    case 0xc0:
    case 0xc1:
    case 0xc2:
      if (state.frame) throw new MessageError(msg`it has two frame headers`);
      if (payload.length < 6 || payload.length < 6 + 3 * payload[5]) throw damaged();
      checkSize((payload[3] << 8) | payload[4], (payload[1] << 8) | payload[2]);
      state.frame = jpegFrame(payload, marker === 0xc2);
      return;
    case 0xc4:
      readHuffmanTables(payload, state);
      return;
    case 0xdb:
      readSteps(payload, state);
      return;
    case 0xdd:
      state.restartInterval = (payload[0] << 8) | payload[1];
      return;
    case 0xe0:
      state.hasJfif ||= String.fromCharCode(...payload.subarray(0, 4)) === 'JFIF';
      return;
    case 0xee:
      if (String.fromCharCode(...payload.subarray(0, 5)) === 'Adobe') state.adobe = payload[11];
      return;
    default:
      if (marker > 0xc2 && marker < 0xd0 && marker !== 0xc8 && marker !== 0xcc)
        throw new MessageError(msg`it is compressed in a way that is not read (lossless, hierarchical or arithmetic)`);
  }
}

function readHuffmanTables(payload: Uint8Array, { means, waves }: JpegState): void {
  for (let at = 0; at + 17 <= payload.length; ) {
    const counts = payload.subarray(at + 1, at + 17);
    const count = counts.reduce((sum, n) => sum + n, 0);
    const values = payload.subarray(at + 17, at + 17 + count);
    if (values.length < count) throw damaged();
    (payload[at] >> 4 === 0 ? means : waves)[payload[at] & 3] = makeHuffmanTable(counts, values);
    at += 17 + count;
  }
}

function readSteps(payload: Uint8Array, { steps }: JpegState): void {
  for (let at = 0; at < payload.length; ) {
    const size = payload[at] >> 4 === 0 ? 1 : 2;
    const table = new Uint16Array(SIDE * SIDE);
    for (let k = 0; k < table.length; k++) {
      const i = at + 1 + size * k;
      table[ZIGZAG[k]] = size === 1 ? payload[i] : (payload[i] << 8) | payload[i + 1];
    }
    steps[payload[at] & 3] = table;
    at += 1 + size * table.length;
  }
}

function readOneScan(bytes: Uint8Array, at: number, payload: Uint8Array, state: JpegState): number {
  const { frame, means, waves, steps, restartInterval } = state;
  if (!frame) throw new MessageError(msg`no frame header`);
  if (++state.scans > MAX_SCANS) throw new MessageError(msg`it has more than ${MAX_SCANS} scans`);
  const count = payload[0];
  if (!(count >= 1 && payload.length >= 4 + 2 * count)) throw damaged();
  const components = Array.from({ length: count }, (_, k) => {
    const component = frame.components.find(({ id }) => id === payload[1 + 2 * k]);
    if (!component) throw damaged();
    const tables = payload[2 + 2 * k];
    return Object.assign(component, { mean: means[tables >> 4], waves: waves[tables & 15], predicted: 0 });
  });
  const [first, last, bits] = payload.subarray(1 + 2 * count);
  const band = [Math.min(first, SIDE * SIDE - 1), Math.min(last, SIDE * SIDE - 1)] as const;
  return readScan(bytes, at, frame, {
    components,
    band,
    missing: [bits >> 4, bits & 15],
    restartInterval,
    steps,
  });
}

/** The samples of a progressive picture's component, when all scans are read. */
function transform(component: JpegComponent, { steps }: JpegState): void {
  const of = steps[component.quantization];
  const { coefficients } = component;
  if (!of || !coefficients) throw damaged();
  const size = SIDE * SIDE;
  for (let block = 0; block * size < coefficients.length; block++)
    inverseDct(coefficients, block * size, of, blockPlace(component, block));
}

/** As libjpeg takes them: by Adobe's segment, else by JFIF's, else by the components' names. */
function encodingOf({ components }: JpegFrame, { adobe, hasJfif }: JpegState): ColorEncoding {
  if (components.length === 1) return 'gray';
  if (components.length === 4) return adobe === 2 ? 'ycck' : 'cmyk';
  if (adobe !== undefined) return adobe === 0 ? 'rgb' : 'ycc';
  return !hasJfif && String.fromCharCode(...components.map(({ id }) => id)) === 'RGB' ? 'rgb' : 'ycc';
}
