import { closeSync, fstatSync, ftruncateSync, openSync, readSync, writeSync } from 'node:fs';
import type { FileEdit } from '../../formats/spherical/sphericalMp4.ts';

/** How much is moved at once [bytes]. */
const BLOCK = 2 ** 24;

/** Carries out an edit in the file itself, which may be larger than memory; what follows it is moved where its length changes. The file is damaged if this is interrupted. */
export function applyFileEdit(path: string, { at, removed, bytes }: FileEdit, block = BLOCK): void {
  const file = openSync(path, 'r+');
  try {
    const { size } = fstatSync(file);
    const shift = bytes.length - removed;
    moveBytes(file, at + removed, size, shift, block);
    writeAll(file, bytes, at);
    if (shift < 0) ftruncateSync(file, size + shift);
  } finally {
    closeSync(file);
  }
}

/** Moves bytes `from` … `to` by `shift`, block by block, so that none is overwritten before it is read. */
function moveBytes(file: number, from: number, to: number, shift: number, block: number): void {
  if (shift === 0) return;
  const buffer = new Uint8Array(Math.min(block, to - from));
  for (let done = 0; done < to - from; ) {
    const length = Math.min(block, to - from - done);
    const start = shift > 0 ? to - done - length : from + done;
    const part = buffer.subarray(0, length);
    readAll(file, part, start);
    writeAll(file, part, start + shift);
    done += length;
  }
}

function readAll(file: number, into: Uint8Array, at: number): void {
  for (let done = 0; done < into.length; ) {
    const read = readSync(file, into, done, into.length - done, at + done);
    if (read === 0) throw new Error(`the file ended at byte ${at + done} while it was edited`);
    done += read;
  }
}

function writeAll(file: number, bytes: Uint8Array, at: number): void {
  for (let done = 0; done < bytes.length; ) done += writeSync(file, bytes, done, bytes.length - done, at + done);
}
