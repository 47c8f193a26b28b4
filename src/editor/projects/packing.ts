import { scenesIn } from '../../formats/entry.ts';
import { formatBytes } from '../../formats/fail.ts';
import { resolvePath } from '../../formats/source.ts';
import type { GraphDocument } from '../../graph/document.ts';
import { filesIn, withFiles } from '../../graph/files.ts';
import { readsIn } from '../../nodes/chain.ts';
import { chosenOf } from '../../nodes/geometry/read.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { packProject } from '../../nodes/projectArchive.ts';
import { type HeldFiles, readHeld } from '../loading/held.ts';
import { type LocalFiles, localParts } from '../loading/localFiles.ts';
import { collected, fileReader } from '../loading/sceneLoader.ts';
import { isProject, outsideName } from './names.ts';

/** What the page holds twice while it packs [bytes]. */
const MOST_PACKED = 2 ** 29;

/** The files of a project are more than the page packs; `size` and `most` for people. */
export class TooMuchToPack extends Error {
  readonly size: string;
  readonly most = formatBytes(MOST_PACKED);
  constructor(bytes: number) {
    super(`${formatBytes(bytes)} are more than a page packs`);
    this.size = formatBytes(bytes);
  }
}

/**
 * A project with its files as one zip: of those that a person gave the whole set, of those on the server what reading them asks for. Throws
 * a TooMuchToPack; an InputError where a file cannot be read.
 */
export async function packedProject(document: GraphDocument, origin: string, local: LocalFiles): Promise<Uint8Array> {
  const packing = new Packing(document, origin, local);
  const names = new Map<string, string>();
  for (const source of filesIn(document, nodeLibrary)) names.set(source, await packing.add(source));
  // What is known of files that are not packed would be of others.
  const named = withFiles({ ...document, files: {} }, nodeLibrary, (source) => names.get(source) ?? source);
  return packProject(named, packing.files);
}

class Packing {
  readonly files = new Map<string, Uint8Array>();
  readonly #document: GraphDocument;
  readonly #origin: string;
  readonly #local: LocalFiles;
  /** Where the files of a set are, by its key: in the archive itself, or where paths clash, in a folder. */
  readonly #folders = new Map<string, string>();
  #size = 0;

  constructor(document: GraphDocument, origin: string, local: LocalFiles) {
    this.#document = document;
    this.#origin = origin;
    this.#local = local;
  }

  /** Adds what a node reads; returns what it is called in the archive. */
  async add(source: string): Promise<string> {
    const parts = localParts(source);
    const path = parts?.rest.slice(1) ?? source;
    if (parts && !parts.rest.startsWith('@')) {
      const folder = await this.#addSet(source, (inner) => this.#plain(`local:${parts.id}/${inner}`));
      return folder + this.#plain(source);
    }
    const scene = withoutHost(path);
    if (parts) await this.#addSet(source, (inner) => resolvePath(scene, inner));
    if (scenesIn([path]).length === 0) {
      this.#put(scene, await fileReader(this.#local)(source));
      return scene;
    }
    const params = Object.values(readsIn(this.#document)).find((read) => read.source === source);
    const variants = chosenOf(Array.isArray(params?.variants) ? params.variants.map(String) : []);
    for (const [inner, bytes] of await collected(this.#local, source, { variants }))
      this.#put(withoutHost(resolvePath(scene, inner)), bytes);
    return scene;
  }

  /** Without the names of archives: what lay in them lies in folders now. */
  #plain(source: string): string {
    return outsideName(source, this.#origin)
      .replace(/\.zip\[(.*)\]$/i, '/$1')
      .replaceAll(/\.zip\//gi, '/');
  }

  async #addSet(source: string, nameOf: (path: string) => string): Promise<string> {
    const { id, files } = this.#local.setOf(source) ?? { id: '', files: new Map() as HeldFiles };
    const known = this.#folders.get(id);
    if (known !== undefined) return known;
    const wanted = [...files].filter(([path]) => !isProject(path));
    const clash = wanted.some(([path]) => this.files.has(nameOf(path)));
    const folder = clash ? `files${this.#folders.size + 1}/` : '';
    this.#folders.set(id, folder);
    for (const [path, file] of wanted) {
      this.#count(file instanceof Blob ? file.size : file.entry.size);
      this.files.set(folder + nameOf(path), await readHeld(file, () => {}));
    }
    return folder;
  }

  #put(path: string, bytes: Uint8Array): void {
    if (this.files.has(path)) return;
    this.#count(bytes.length);
    this.files.set(path, bytes);
  }

  #count(bytes: number): void {
    this.#size += bytes;
    if (this.#size > MOST_PACKED) throw new TooMuchToPack(this.#size);
  }
}

/** A path in the archive for what is at an address. */
const withoutHost = (address: string): string =>
  address
    .replace(/^[a-z]+:\/\/[^/]*\//i, '')
    .replace(/[?#].*$/, '')
    .replace(/^(\.{0,2}\/)+/, '');
