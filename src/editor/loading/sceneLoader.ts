import { CancelledError } from '../../graph/evaluate.ts';
import type { LoadedScene, ReadRequest, Services } from '../../nodes/services.ts';
import { InputError } from '../../scene/types.ts';
import type { HeldFiles } from './held.ts';
import type { LoaderReply, LoadRequest, SceneFiles } from './protocol.ts';
import { localSource, splitAddress, urlSource } from './sources.ts';

/**
 * The files that the person gave this session, by the name under which a document refers to them: `local:3/set/scene.usda` is
 * a file of the third set; in `local:3.1/…` others were added to it once. The set of a scene on the server holds what was
 * added: `local:4.1@examples/scene.usda`.
 */
export class LocalFiles {
  readonly #sets = new Map<string, HeldFiles>();
  #count = 0;

  /** Returns the name to open a file of a new set by. */
  add(files: HeldFiles, entry: string): string {
    const id = String(++this.#count);
    this.#sets.set(id, files);
    return `local:${id}/${entry}`;
  }

  /** Adds files to the set of a scene; returns the name to open it by from then on. */
  supply(source: string, files: HeldFiles): string {
    const { id, rest } = parts(source) ?? { id: String(++this.#count), rest: `@${source}` };
    const before = this.#sets.get(id) ?? new Map();
    const next = `${id.split('.')[0]}.${this.#sets.size}`;
    this.#sets.set(next, new Map([...before, ...beside(files, rest)]));
    return `local:${next}${rest}`;
  }

  /** Paths of the set that a scene belongs to. */
  paths(source: string): string[] {
    return [...(this.#sets.get(parts(source)?.id ?? '')?.keys() ?? [])];
  }

  /** Another scene of the same set. */
  sibling(source: string, entry: string): string {
    return `local:${parts(source)?.id}/${entry}`;
  }

  get(source: string): SceneFiles | undefined {
    const { id = '', rest = '' } = parts(source) ?? {};
    const files = this.#sets.get(id);
    if (!files) return undefined;
    if (rest.startsWith('@')) return { files: [...files], ...splitAddress(new URL(rest.slice(1), document.baseURI)) };
    return { files: [...files], entry: rest.slice(1) };
  }
}

/** `local:3.1/set/scene.usda` → `3.1` and `/set/scene.usda`. */
function parts(source: string): { id: string; rest: string } | undefined {
  const [, id, rest] = /^local:([\d.]+)([/@].*)$/s.exec(source) ?? [];
  return id === undefined || rest === undefined ? undefined : { id, rest };
}

/** Single files come beside the scene; a folder or an archive keeps its own paths. */
function beside(files: HeldFiles, rest: string): HeldFiles {
  const folder = rest.startsWith('@') ? '' : rest.slice(1, rest.lastIndexOf('/') + 1);
  return new Map([...files].map(([path, file]) => [path.includes('/') ? path : folder + path, file]));
}

/** What stays the same while files are added to a scene: by this the page knows that it is still the same one. */
export function sceneKey(source: string): string {
  const { id, rest } = parts(source) ?? {};
  if (id === undefined || rest === undefined) return source;
  return rest.startsWith('@') ? rest.slice(1) : `local:${id.split('.')[0]}${rest}`;
}

/** Reads the scene of a document's `source`: files of this session, or an address beside the page. */
export function sceneReader(local: LocalFiles): Services['readScene'] {
  return (source, how) => {
    const { variants = [], interpolation } = how;
    const files = local.get(source) ?? addressed(source);
    const request = { ...files, variants: [...variants], ...(interpolation && { interpolation }) };
    return readInWorker(request, how);
  };
}

/** Reads a small file of a document: one of this session, or at an address beside the page. */
export function fileReader(local: LocalFiles): Services['readFile'] {
  return async (source) => {
    const { files, base, entry } = local.get(source) ?? addressed(source);
    const others = base === undefined ? undefined : urlSource(base, () => {});
    const bytes = await localSource(new Map(files), () => {}, others).read(entry);
    if (bytes) return bytes;
    const message = 'there is no such file; put it beside the project, or open it';
    throw new InputError({ severity: 'error', code: 'file.missing', place: sceneName(source), message });
  };
}

function addressed(source: string): SceneFiles {
  if (source.startsWith('local:')) {
    const message = 'the file was opened in an earlier session; open it again';
    throw new InputError({ severity: 'error', code: 'file.forgotten', place: sceneName(source), message });
  }
  return { files: [], ...splitAddress(new URL(source, document.baseURI)) };
}

/** `local:3/set/scene.usda` → `scene.usda`. */
export const sceneName = (source: string): string => source.slice(source.lastIndexOf('/') + 1);

/** One worker per scene: to cancel is to end it, whatever it is doing. */
function readInWorker(request: LoadRequest, { signal, progress }: ReadRequest): Promise<LoadedScene> {
  const worker = new Worker(new URL('./loader.worker.ts', import.meta.url), { type: 'module' });
  const reading = new Promise<LoadedScene>((resolve, reject) => {
    signal?.addEventListener('abort', () => reject(new CancelledError()));
    worker.addEventListener('error', (event) => reject(new Error(event.message || 'the reader could not be started')));
    worker.addEventListener('message', ({ data }: MessageEvent<LoaderReply>) => {
      if (data.kind === 'progress') progress(data.part, data.stage);
      else if (data.kind === 'done') resolve(data.loaded);
      else reject(data.diagnostic ? new InputError(data.diagnostic) : new Error(data.message));
    });
    progress(undefined, 'fetch');
    worker.postMessage(request);
  });
  return reading.finally(() => worker.terminate());
}
