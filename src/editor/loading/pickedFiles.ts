/** Files by their paths within the selection. */
export type PickedFiles = ReadonlyMap<string, File>;

/** Files of a file dialogue; with folders, if a folder was chosen. */
export const pickedFiles = (list: Iterable<File>): PickedFiles =>
  new Map([...list].map((file) => [file.webkitRelativePath || file.name, file]));

/**
 * All dropped files, folders recursively. Must be called within the drop event, after which the browser revokes access
 * to the items.
 */
export async function droppedFiles(transfer: DataTransfer): Promise<PickedFiles> {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry());
  const files = await Promise.all(entries.map((entry) => (entry ? filesIn(entry) : [])));
  const found = new Map(files.flat());
  return found.size > 0 ? found : pickedFiles(transfer.files);
}

async function filesIn(entry: FileSystemEntry): Promise<[string, File][]> {
  if (isFile(entry)) {
    const file = await new Promise<File>((resolve, reject) => entry.file(resolve, reject));
    return [[entry.fullPath.replace(/^\//, ''), file]];
  }
  if (!isDirectory(entry)) return [];
  const reader = entry.createReader();
  const found: [string, File][] = [];
  // `readEntries` returns batches, and an empty one at the end.
  for (let part = await readDirectoryBatch(reader); part.length > 0; part = await readDirectoryBatch(reader)) {
    found.push(...(await Promise.all(part.map(filesIn))).flat());
  }
  return found;
}

const isFile = (entry: FileSystemEntry): entry is FileSystemFileEntry => entry.isFile;
const isDirectory = (entry: FileSystemEntry): entry is FileSystemDirectoryEntry => entry.isDirectory;
const readDirectoryBatch = (reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> =>
  new Promise((resolve, reject) => reader.readEntries(resolve, reject));
