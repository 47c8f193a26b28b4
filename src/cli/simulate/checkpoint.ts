import { createHash } from 'node:crypto';
import { closeSync, ftruncateSync, openSync, readFileSync, writeSync } from 'node:fs';
import { endianness } from 'node:os';
import type { RunTally, SimulationFrame } from '../../dynamics/run.ts';
import type { State } from '../../dynamics/system.ts';
import { msg } from '../../messages/message.ts';
import { inputProblem } from '../terminal/exitCodes.ts';

/**
 * First line of a checkpoint, as JSON. Frames follow as f64: t, steps, energy taken by drag, corrected steps (NaN where
 * absent), x (3 per point), p (3 per point).
 */
interface CheckpointHeader {
  readonly slowlight: 'checkpoint';
  readonly version: 2;
  /** Content hash of the simulation's inputs. */
  readonly content: string;
  readonly points: number;
  readonly littleEndian: boolean;
}

export interface CheckpointFrame {
  readonly state: State;
  readonly tally: RunTally;
}

/** Numbers of a frame before its positions. */
const FRAME_HEAD = 4;

const LITTLE_ENDIAN = endianness() === 'LE';

const sha256Hex = (bytes: string | Uint8Array): string => createHash('sha256').update(bytes).digest('hex');

/** SHA-256 of plain data; equal data has equal hashes. */
export const contentHash = (what: unknown): string =>
  sha256Hex(
    JSON.stringify(what, (_, value) =>
      ArrayBuffer.isView(value) ? sha256Hex(new Uint8Array(value.buffer, value.byteOffset, value.byteLength)) : value,
    ),
  );

/** Appends every frame to a file as soon as it is computed, so that no frame is lost however the program ends. */
export class Checkpoint {
  private readonly file: number;

  /** `after`: length of the existing content to keep [bytes]; if absent the file is started anew. */
  constructor(path: string, content: string, points: number, after?: number) {
    this.file = openForWriting(path, after === undefined ? 'w' : 'r+');
    if (after === undefined) {
      const head: CheckpointHeader = {
        slowlight: 'checkpoint',
        version: 2,
        content,
        points,
        littleEndian: LITTLE_ENDIAN,
      };
      writeSync(this.file, `${JSON.stringify(head)}\n`);
    } else {
      ftruncateSync(this.file, after);
      this.at = after;
    }
  }

  private at: number | null = null;

  add({ state: { t, x, p }, steps, dragLoss, corrected }: Omit<SimulationFrame, 'quantities'>): void {
    const numbers = new Float64Array(FRAME_HEAD + x.length + p.length);
    numbers.set([t, steps, dragLoss ?? Number.NaN, corrected ?? Number.NaN]);
    numbers.set(x, FRAME_HEAD);
    numbers.set(p, FRAME_HEAD + x.length);
    writeSync(this.file, new Uint8Array(numbers.buffer), 0, numbers.byteLength, this.at);
    if (this.at !== null) this.at += numbers.byteLength;
  }

  close(): void {
    closeSync(this.file);
  }
}

function openForWriting(path: string, how: 'w' | 'r+'): number {
  try {
    return openSync(path, how);
  } catch (error) {
    throw inputProblem(msg`${path} cannot be written (${(error as Error).message}); name another file`);
  }
}

/** The complete frames of a checkpoint and the byte offset of their end; the last frame may be incomplete. */
export function readCheckpoint(
  path: string,
  content: string,
  points: number,
): { readonly frames: readonly CheckpointFrame[]; readonly end: number } {
  const bytes = readBytes(path);
  const newline = bytes.indexOf(10);
  const head = parseHeader(bytes.subarray(0, Math.max(0, newline)));
  if (!head) throw inputProblem(msg`${path} is no checkpoint of a simulation; leave --resume out to begin anew`);
  if (head.content !== content || head.points !== points || head.littleEndian !== LITTLE_ENDIAN)
    throw inputProblem(
      msg`${path} was made of another simulation: its things, numbers, method or pace were others; set them as they were, or leave --resume out to begin anew`,
    );
  const size = FRAME_HEAD + 6 * points;
  const body = bytes.slice(newline + 1);
  const count = Math.floor(body.length / (8 * size));
  const numbers = new Float64Array(body.buffer, 0, count * size);
  const frames = Array.from({ length: count }, (_, k): CheckpointFrame => {
    const [t, steps, dragLoss, corrected] = numbers.subarray(k * size);
    const positions = k * size + FRAME_HEAD;
    const x = numbers.slice(positions, positions + 3 * points);
    const p = numbers.slice(positions + 3 * points, (k + 1) * size);
    const tally = {
      steps,
      ...(!Number.isNaN(dragLoss) && { dragLoss }),
      ...(!Number.isNaN(corrected) && { corrected }),
    };
    return { state: { t, x, p }, tally };
  });
  return { frames, end: newline + 1 + 8 * count * size };
}

function readBytes(path: string): Uint8Array {
  try {
    return new Uint8Array(readFileSync(path));
  } catch (error) {
    throw inputProblem(msg`${path} cannot be read (${(error as Error).message}); leave --resume out to begin anew`);
  }
}

function parseHeader(bytes: Uint8Array): CheckpointHeader | undefined {
  try {
    const head = JSON.parse(new TextDecoder().decode(bytes)) as CheckpointHeader;
    return head.slowlight === 'checkpoint' && head.version === 2 ? head : undefined;
  } catch {
    return undefined;
  }
}
