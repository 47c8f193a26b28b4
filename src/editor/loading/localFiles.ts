import { splitAddress } from './fileSources.ts';
import type { SceneFiles } from './protocol.ts';
import type { UserFiles } from './userFiles.ts';

/**
 * Files that the user opened in this session, by the names under which documents refer to them:
 * `local:3/set/scene.usda` is a file of the third set; `local:3.1/…` is the set after one addition. A scene on the
 * server has a set for files added to it: `local:4.1@examples/scene.usda`.
 */
export class LocalFiles {
  private readonly sets = new Map<string, UserFiles>();
  private count = 0;

  /** Adds a set; returns the name of its entry. */
  add(files: UserFiles, entry: string): string {
    const id = String(++this.count);
    this.sets.set(id, files);
    return `local:${id}/${entry}`;
  }

  /** Adds files to the set of a scene; returns the scene's new name. */
  addToSet(source: string, files: UserFiles): string {
    const { id, rest } = parseLocalName(source) ?? { id: String(++this.count), rest: `@${source}` };
    const before = this.sets.get(id) ?? new Map();
    const next = `${id.split('.')[0]}.${++this.count}`;
    this.sets.set(next, new Map([...before, ...relativeToScene(files, rest)]));
    return `local:${next}${rest}`;
  }

  /** The set of a name, with its id. */
  setOf(source: string): { readonly id: string; readonly files: UserFiles } | undefined {
    const id = parseLocalName(source)?.id ?? '';
    const files = this.sets.get(id);
    return files && { id, files };
  }

  /** Finds a file by its path; of several, the most recently added. */
  find(path: string): string | undefined {
    const [id] = [...this.sets].findLast(([, files]) => files.has(path)) ?? [];
    return id === undefined ? undefined : `local:${id}/${path}`;
  }

  /** Restores a set of an earlier session, under its id if that is free; returns the id. */
  restoreSet(id: string, files: UserFiles): string {
    const key = this.sets.has(id) ? String(++this.count) : id;
    this.sets.set(key, files);
    this.reserveName(`local:${key}/`);
    return key;
  }

  /** Reserves a name's id, whether its files are available or not. */
  reserveName(source: string): void {
    const numbers = parseLocalName(source)?.id.split('.').map(Number) ?? [];
    this.count = Math.max(this.count, ...numbers);
  }

  /** Paths of the scene's set. */
  paths(source: string): string[] {
    return [...(this.sets.get(parseLocalName(source)?.id ?? '')?.keys() ?? [])];
  }

  /** Another scene of the same set. */
  sibling(source: string, entry: string): string {
    return `local:${parseLocalName(source)?.id}/${entry}`;
  }

  get(source: string): SceneFiles | undefined {
    const { id = '', rest = '' } = parseLocalName(source) ?? {};
    const files = this.sets.get(id);
    if (!files) return undefined;
    if (rest.startsWith('@')) return { files: [...files], ...splitAddress(new URL(rest.slice(1), document.baseURI)) };
    return { files: [...files], entry: rest.slice(1) };
  }
}

/** `local:3.1/set/scene.usda` → `3.1` and `/set/scene.usda`. */
export function parseLocalName(source: string): { id: string; rest: string } | undefined {
  const [, id, rest] = /^local:([\d.]+)([/@].*)$/s.exec(source) ?? [];
  return id === undefined || rest === undefined ? undefined : { id, rest };
}

/** Single files are placed beside the scene; folders and archives keep their paths. */
function relativeToScene(files: UserFiles, rest: string): UserFiles {
  const folder = rest.startsWith('@') ? '' : rest.slice(1, rest.lastIndexOf('/') + 1);
  return new Map([...files].map(([path, file]) => [path.includes('/') ? path : folder + path, file]));
}

/** Identity of a scene that does not change when files are added to it. */
export function sceneKey(source: string): string {
  const { id, rest } = parseLocalName(source) ?? {};
  if (id === undefined || rest === undefined) return source;
  return rest.startsWith('@') ? rest.slice(1) : `local:${id.split('.')[0]}${rest}`;
}

/** `local:3/set/scene.usda` → `scene.usda`. */
export const sceneName = (source: string): string => source.slice(source.lastIndexOf('/') + 1);
