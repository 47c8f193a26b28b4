import { inputError } from '../../formats/diagnostics/inputError.ts';
import { extensionOf } from '../../formats/files/fileSource.ts';
import type { RandomAccessFile, ZipEntry } from '../../formats/zip/directory.ts';
import { msg } from '../../messages/message.ts';

/** A file from the user, or an entry of an archive, decompressed on read in the worker. */
export type UserFile = Blob | ArchivedFile;

interface ArchivedFile {
  readonly archive: Blob;
  /** Name of the archive, for messages. */
  readonly name: string;
  readonly entry: ZipEntry;
}

/** Files by their paths within the selection. */
export type UserFiles = ReadonlyMap<string, UserFile>;

/** A blob with random access. */
const partedBlob = (blob: Blob): RandomAccessFile => ({
  size: blob.size,
  read: async (from, to) => new Uint8Array(await blob.slice(from, to).arrayBuffer()),
});

/** Reads a whole file; `report` gets received and total bytes. */
export async function readUserFile(
  file: UserFile,
  report: (received: number, total: number) => void,
): Promise<Uint8Array> {
  if (!(file instanceof Blob)) {
    // Loaded with the first archive.
    const { unpack } = await import('../../formats/zip/unpack.ts');
    return unpack(partedBlob(file.archive), file.entry, file.name);
  }
  const bytes = new Uint8Array(file.size);
  let received = 0;
  const reader = file.stream().getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    if (received + part.value.length > bytes.length)
      throw inputError('file.changed', '', msg`the file grew while it was read; open it again`);
    bytes.set(part.value, received);
    received += part.value.length;
    report(received, bytes.length);
  }
  return bytes.subarray(0, received);
}

/** Replaces every zip by a folder of its name; throws an InputError if one cannot be read. */
export async function expandArchives(files: ReadonlyMap<string, Blob>): Promise<UserFiles> {
  const found = new Map<string, UserFile>();
  for (const [path, file] of files) {
    if (extensionOf(path) !== 'zip') found.set(path, file);
    else for (const [inner, packed] of await filesInArchive(path, file)) found.set(inner, packed);
  }
  return found;
}

async function filesInArchive(path: string, archive: Blob): Promise<[string, ArchivedFile][]> {
  const { readZipDirectory } = await import('../../formats/zip/directory.ts');
  const entries = await readZipDirectory(partedBlob(archive), path);
  return entries.map((entry) => [`${path}/${entry.path}`, { archive, name: path, entry }]);
}
