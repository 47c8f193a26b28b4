import { inputError } from '../../formats/diagnostics/inputError.ts';
import { msg } from '../../messages/message.ts';
import type { StoredFile } from '../../scene/streaming/storedNumbers.ts';

/** Available in workers only, and missing from the DOM library. */
declare class FileReaderSync {
  readAsArrayBuffer(blob: Blob): ArrayBuffer;
}

/** Reads a part of a user's file, in a worker; for `setFileReader` of scene/streaming/storedNumbers.ts. */
export function readBlob({ name, handle }: StoredFile, at: number, length: number): Uint8Array<ArrayBuffer> {
  const bytes = partOf(handle as Blob, at, length);
  if (bytes?.length === length) return bytes;
  throw inputError('file.changed', name, msg`it is not what was opened any more, or is gone; open the scene again`);
}

/** Undefined if the browser reports that the file has changed. */
function partOf(blob: Blob, at: number, length: number): Uint8Array<ArrayBuffer> | undefined {
  try {
    return new Uint8Array(new FileReaderSync().readAsArrayBuffer(blob.slice(at, at + length)));
  } catch (error) {
    if (error instanceof DOMException) return undefined;
    throw error;
  }
}
