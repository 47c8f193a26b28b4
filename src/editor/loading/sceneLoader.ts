import { CancelledError } from '../../graph/evaluate.ts';
import type { LoadedScene, Services } from '../../nodes/services.ts';
import { InputError } from '../../scene/types.ts';
import type { LoaderReply, SceneFiles } from './protocol.ts';
import { splitAddress } from './sources.ts';

type ReadOptions = Parameters<Services['readScene']>[1];

/** The files that the person gave this session, by the name under which a document refers to them. */
export class LocalFiles {
  readonly #sets = new Map<string, SceneFiles>();

  /** Returns the name to open it by. */
  add(files: ReadonlyMap<string, File>, entry: string): string {
    const source = `local:${this.#sets.size + 1}/${entry}`;
    this.#sets.set(source, { kind: 'local', files: [...files], entry });
    return source;
  }

  get(source: string): SceneFiles | undefined {
    return this.#sets.get(source);
  }
}

/** Reads the scene of a document's `source`: files of this session, or an address beside the page. */
export function sceneReader(local: LocalFiles): Services['readScene'] {
  return (source, options) => readInWorker(local.get(source) ?? addressed(source), options);
}

function addressed(source: string): SceneFiles {
  if (source.startsWith('local:')) {
    const message = 'the file was opened in an earlier session; open it again';
    throw new InputError({ severity: 'error', code: 'file.forgotten', place: sceneName(source), message });
  }
  return { kind: 'url', ...splitAddress(new URL(source, document.baseURI)) };
}

/** `local:3/set/scene.usda` → `scene.usda`. */
export const sceneName = (source: string): string => source.slice(source.lastIndexOf('/') + 1);

/** One worker per scene: to cancel is to end it, whatever it is doing. */
function readInWorker(files: SceneFiles, { signal, progress }: ReadOptions): Promise<LoadedScene> {
  const worker = new Worker(new URL('./loader.worker.ts', import.meta.url), { type: 'module' });
  const reading = new Promise<LoadedScene>((resolve, reject) => {
    signal?.addEventListener('abort', () => reject(new CancelledError()));
    worker.addEventListener('error', (event) => reject(new Error(event.message || 'the reader could not be started')));
    worker.addEventListener('message', ({ data }: MessageEvent<LoaderReply>) => {
      if (data.kind === 'progress') progress(data.part, data.stage);
      else if (data.kind === 'done') resolve(data.loaded);
      else reject(data.diagnostic ? new InputError(data.diagnostic) : new Error(data.message));
    });
    worker.postMessage(files);
  });
  return reading.finally(() => worker.terminate());
}
