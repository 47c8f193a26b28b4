import { inputError } from '../../formats/diagnostics/inputError.ts';
import type { StoredFile } from '../../scene/streaming/storedNumbers.ts';

/** Of workers alone, which the DOM library does not know. */
declare class FileReaderSync {
  readAsArrayBuffer(blob: Blob): ArrayBuffer;
}

/** Reads a part of a file that a person chose, in a worker: `setFileReader` of scene/streaming/storedNumbers.ts takes it. */
export function readBlob({ name, handle }: StoredFile, at: number, length: number): Uint8Array<ArrayBuffer> {
  const bytes = partOf(handle as Blob, at, length);
  if (bytes?.length === length) return bytes;
  throw inputError('file.changed', name, 'it is not what was opened any more, or is gone; open the scene again');
}

/** Undefined where the browser finds that the file has changed. */
function partOf(blob: Blob, at: number, length: number): Uint8Array<ArrayBuffer> | undefined {
  try {
    return new Uint8Array(new FileReaderSync().readAsArrayBuffer(blob.slice(at, at + length)));
  } catch (error) {
    if (error instanceof DOMException) return undefined;
    throw error;
  }
}
