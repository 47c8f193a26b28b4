import type { StreamedPoints } from '../../../scene/streaming/storedPoints.ts';
import { type Diagnostic, InputError } from '../../../scene/types.ts';
import { packSample, ROW_TEXELS, rowsOf } from './packedSamples.ts';

/** Messages to a worker that reads samples: each motion once, then requests for samples. */
export type SampleRequest =
  | { readonly kind: 'motion'; readonly motion: number; readonly points: StreamedPoints }
  | { readonly kind: 'sample'; readonly motion: number; readonly k: number };

/** The answer for each sample: its texels (packedSamples.ts), or why it cannot be read. */
export interface SampleReply {
  readonly motion: number;
  readonly k: number;
  readonly rows?: Float32Array<ArrayBuffer>;
  readonly failed?: { readonly message: string; readonly diagnostic?: Diagnostic };
}

/** The worker's side of a port, as far as it is used here. */
interface Port {
  addEventListener(type: 'message', listener: (event: MessageEvent<SampleRequest>) => void): void;
  postMessage(message: SampleReply, options: { transfer: ArrayBuffer[] }): void;
}

/** Makes a worker read samples off the main thread, for `SampleLoader`. Access to files must have been set up before. */
export function serveSamples(port: Port): void {
  const motions = new Map<number, StreamedPoints>();
  port.addEventListener('message', ({ data }) => {
    if (data.kind === 'motion') {
      motions.set(data.motion, data.points);
      return;
    }
    const { motion, k } = data;
    const points = motions.get(motion);
    if (!points) return;
    try {
      const rows = rowsFor(points, k);
      port.postMessage({ motion, k, rows }, { transfer: [rows.buffer] });
    } catch (error) {
      port.postMessage({ motion, k, failed: reasonOf(error) }, { transfer: [] });
    }
  });
}

function rowsFor(points: StreamedPoints, k: number): Float32Array<ArrayBuffer> {
  const rows = new Float32Array(4 * ROW_TEXELS * rowsOf(points.pointOfVertex.length));
  packSample({ points }, k, NO_NORMALS, rows);
  return rows;
}

/** Streamed points always have normals of their own. */
const NO_NORMALS = new Float32Array(0);

const reasonOf = (error: unknown): NonNullable<SampleReply['failed']> => ({
  message: error instanceof Error ? error.message : String(error),
  ...(error instanceof InputError && { diagnostic: error.diagnostic }),
});
