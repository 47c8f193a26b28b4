import { type FileSource, normalizePath } from '../../formats/files/fileSource.ts';
import { nearestPath } from '../../formats/files/nearestPath.ts';
import { RangedFile } from '../../formats/files/rangedFile.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { fetchFile } from './fetchFile.ts';
import { readUserFile, type UserFile } from './userFiles.ts';

type ReportProgress = (received: number, total: number) => void;

/**
 * Files relative to a base address; `read` returns undefined for what the server does not have. Reports the received
 * bytes of each file.
 */
export function urlSource(base: string, report: ReportProgress): FileSource {
  return {
    read: async (path) => {
      const response = await fetchFile(new URL(encodePath(normalizePath(path)), base), path);
      if (response.status === 404) return undefined;
      if (!response.ok)
        throw new MessageError(msg`${path}: the server answers ${response.status} ${response.statusText}`);
      return readAll(response, report);
    },
  };
}

const encodePath = (path: string): string => path.split('/').map(encodeURIComponent).join('/');

/** Splits an address into the folder that files are read from, ending with '/', and the file name. */
export function splitAddress(url: URL): { readonly base: string; readonly entry: string } {
  const slash = url.pathname.lastIndexOf('/') + 1;
  return {
    base: new URL(url.pathname.slice(0, slash), url).href,
    entry: decodeURIComponent(url.pathname.slice(slash)),
  };
}

async function readAll(response: Response, report: ReportProgress): Promise<Uint8Array> {
  const total = Number(response.headers.get('content-length') ?? 0);
  const chunks: Uint8Array[] = [];
  let received = 0;
  for await (const chunk of streamOf(response)) {
    chunks.push(chunk);
    received += chunk.length;
    report(received, Math.max(total, received));
  }
  const bytes = new Uint8Array(received);
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.length;
  }
  return bytes;
}

async function* streamOf(response: Response): AsyncGenerator<Uint8Array> {
  const reader = response.body?.getReader();
  if (!reader) return;
  for (let part = await reader.read(); !part.done; part = await reader.read()) yield part.value;
}

/**
 * Files that the user chose, by path, preferred to those of `others`. A reference that matches none is resolved to the
 * most likely file.
 */
export function localSource(
  files: ReadonlyMap<string, UserFile>,
  report: ReportProgress,
  others?: FileSource,
): FileSource {
  const byPath = new Map([...files].map(([path, file]) => [normalizePath(path), file]));
  const nearest = (path: string): UserFile | undefined => byPath.get(nearestPath(byPath.keys(), path) ?? '');
  return {
    open: async (path) => {
      const wanted = normalizePath(path);
      const handle = byPath.get(wanted) ?? (others ? undefined : nearest(wanted));
      return handle instanceof Blob ? new RangedFile({ name: path, handle }, handle.size) : undefined;
    },
    read: async (path) => {
      const wanted = normalizePath(path);
      const exact = byPath.get(wanted);
      const other = exact ? undefined : await others?.read(path);
      const file = exact ?? (other ? undefined : nearest(wanted));
      return file ? readUserFile(file, report) : other;
    },
    list: async () => [...byPath.keys()],
  };
}
