/** Files by their paths within what was chosen. */
export type PickedFiles = ReadonlyMap<string, File>;

/** Of a file dialogue: with their folders, where a folder was chosen. */
export const pickedFiles = (list: Iterable<File>): PickedFiles =>
  new Map([...list].map((file) => [file.webkitRelativePath || file.name, file]));

/**
 * Everything that was dropped, folders with all that is in them. To be called within the drop event: the browser takes the
 * items back when it ends.
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
  // A reader gives its entries in portions, and an empty one at the end.
  for (let part = await readDirectoryBatch(reader); part.length > 0; part = await readDirectoryBatch(reader)) {
    found.push(...(await Promise.all(part.map(filesIn))).flat());
  }
  return found;
}

const isFile = (entry: FileSystemEntry): entry is FileSystemFileEntry => entry.isFile;
const isDirectory = (entry: FileSystemEntry): entry is FileSystemDirectoryEntry => entry.isDirectory;
const readDirectoryBatch = (reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> =>
  new Promise((resolve, reject) => reader.readEntries(resolve, reject));
