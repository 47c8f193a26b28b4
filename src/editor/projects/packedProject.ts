import { formatBytes } from '../../formats/diagnostics/inputError.ts';
import { scenesIn } from '../../formats/entry.ts';
import { resolvePath } from '../../formats/files/fileSource.ts';
import type { GraphDocument } from '../../graph/document/document.ts';
import { referencedFiles, renameFiles } from '../../graph/document/fileReferences.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { parseVariants } from '../../nodes/geometry/read.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { readNodeParams } from '../../nodes/project/outputChain.ts';
import { packProjectArchive } from '../../nodes/project/projectArchive.ts';
import { type LocalFiles, parseLocalName } from '../loading/localFiles.ts';
import { collectServerFiles, fileReader } from '../loading/sceneLoader.ts';
import { readUserFile, type UserFiles } from '../loading/userFiles.ts';
import { exportedName, isProject } from './projectNames.ts';

/** Limit on what the page packs, since it holds it twice [bytes]. */
const MAX_PACKED_BYTES = 2 ** 29;

/** The project's files exceed the limit. */
export class ProjectTooLargeToPack extends MessageError {
  constructor(bytes: number) {
    super(
      msg`Its files are ${formatBytes(bytes)}, more than the ${formatBytes(MAX_PACKED_BYTES)} that the page can pack. Save the project alone, and keep the files beside it.`,
    );
  }
}

/**
 * A project with its files as one zip: complete sets of user files; of files on the server, those that reading
 * requests. Throws ProjectTooLargeToPack, or an InputError if a file cannot be read.
 */
export async function packedProject(document: GraphDocument, origin: string, local: LocalFiles): Promise<Uint8Array> {
  const packing = new ProjectPacker(document, origin, local);
  const names = new Map<string, string>();
  for (const source of referencedFiles(document, nodeLibrary)) names.set(source, await packing.add(source));
  // File records describe files under their old names and are dropped.
  const named = renameFiles({ ...document, files: {} }, nodeLibrary, (source) => names.get(source) ?? source);
  return packProjectArchive(named, packing.files);
}

class ProjectPacker {
  readonly files = new Map<string, Uint8Array>();
  private readonly document: GraphDocument;
  private readonly origin: string;
  private readonly local: LocalFiles;
  /** Folder of each set in the archive, by its id: the root, or on name clashes a folder. */
  private readonly folders = new Map<string, string>();
  private size = 0;

  constructor(document: GraphDocument, origin: string, local: LocalFiles) {
    this.document = document;
    this.origin = origin;
    this.local = local;
  }

  /** Adds what a node reads; returns its name in the archive. */
  async add(source: string): Promise<string> {
    const parts = parseLocalName(source);
    const path = parts?.rest.slice(1) ?? source;
    if (parts && !parts.rest.startsWith('@')) {
      const folder = await this.addSet(source, (inner) => this.plain(`local:${parts.id}/${inner}`));
      return folder + this.plain(source);
    }
    const scene = archivePathOf(path);
    if (parts) await this.addSet(source, (inner) => resolvePath(scene, inner));
    if (scenesIn([path]).length === 0) {
      this.put(scene, await fileReader(this.local)(source));
      return scene;
    }
    const params = Object.values(readNodeParams(this.document)).find((read) => read.source === source);
    const variants = parseVariants(Array.isArray(params?.variants) ? params.variants.map(String) : []);
    for (const [inner, bytes] of await collectServerFiles(this.local, source, { variants }))
      this.put(archivePathOf(resolvePath(scene, inner)), bytes);
    return scene;
  }

  /** Drops archive names, since archives are extracted into folders. */
  private plain(source: string): string {
    return exportedName(source, this.origin)
      .replace(/\.zip\[(.*)\]$/i, '/$1')
      .replaceAll(/\.zip\//gi, '/');
  }

  private async addSet(source: string, nameOf: (path: string) => string): Promise<string> {
    const { id, files } = this.local.setOf(source) ?? { id: '', files: new Map() as UserFiles };
    const known = this.folders.get(id);
    if (known !== undefined) return known;
    const wanted = [...files].filter(([path]) => !isProject(path));
    const clash = wanted.some(([path]) => this.files.has(nameOf(path)));
    const folder = clash ? `files${this.folders.size + 1}/` : '';
    this.folders.set(id, folder);
    for (const [path, file] of wanted) {
      this.count(file instanceof Blob ? file.size : file.entry.size);
      this.files.set(folder + nameOf(path), await readUserFile(file, () => {}));
    }
    return folder;
  }

  private put(path: string, bytes: Uint8Array): void {
    if (this.files.has(path)) return;
    this.count(bytes.length);
    this.files.set(path, bytes);
  }

  private count(bytes: number): void {
    this.size += bytes;
    if (this.size > MAX_PACKED_BYTES) throw new ProjectTooLargeToPack(this.size);
  }
}

/** Archive path of a file at an address. */
const archivePathOf = (address: string): string =>
  address
    .replace(/^[a-z]+:\/\/[^/]*\//i, '')
    .replace(/[?#].*$/, '')
    .replace(/^(\.{0,2}\/)+/, '');
