import { formatBytes, messageOf } from '../../formats/fail.ts';
import type { GraphDocument } from '../../graph/document.ts';
import { filesIn } from '../../graph/files.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { HeldFile, HeldFiles } from '../loading/held.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import { isUnsaved, type Studio } from '../state/studio.ts';
import type { Pilot } from '../viewport/pilot.ts';
import { projectName } from './names.ts';
import type { KeptSession, Sessions } from './sessions.ts';

/** After the last edit, and at the latest after the first [ms]. */
const PAUSE = 300;
const LATEST = 2000;
/** Of the files that a person gave, all sets of a session together [bytes]. */
const MOST_KEPT = 2 ** 28;

/** What cannot be kept, and why; told once each. */
export type Unkept =
  | { readonly kind: 'work'; readonly why: string }
  | { readonly kind: 'files'; readonly size: string };

export interface AutosaveOptions {
  readonly studio: Studio;
  readonly pilot: Pilot;
  readonly localFiles: LocalFiles;
  /** Undefined: the browser keeps nothing, for this reason. */
  readonly sessions: Sessions | { readonly refusal: string };
  readonly id: string;
  readonly address: () => string;
  /** The session is that of this tab before it was loaded again: these sets are kept already. */
  readonly kept?: Iterable<string>;
}

/** Keeps every edit in the browser, a moment after it was made and when the page is left. */
export class Autosave {
  /** Hears of what cannot be kept. */
  onUnkept: (unkept: Unkept) => void = () => {};
  /** The page came back where it was. */
  readonly isRestored: boolean;
  readonly #options: AutosaveOptions;
  readonly #keptSets: Set<string>;
  readonly #told = new Set<Unkept['kind']>();
  /** Of the first edit that is not kept yet [ms]. */
  #since: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** There is something of this tab in the store, or to be put there. */
  #touched: boolean;
  #keptBytes = 0;

  constructor(options: AutosaveOptions) {
    this.#options = options;
    this.#keptSets = new Set(options.kept);
    this.isRestored = options.kept !== undefined;
    this.#touched = this.isRestored;
    const { studio } = options;
    studio.store.subscribe((now, before) => {
      if (now.history.document === before.history.document && isUnsaved(now) === isUnsaved(before)) return;
      this.#touched = true;
      this.#later();
    });
    addEventListener('pagehide', () => void this.now());
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.now();
    });
  }

  /** Keeps what there is; the page may go at once. Gives whether all of it is kept. */
  async now(): Promise<boolean> {
    clearTimeout(this.#timer);
    this.#since = undefined;
    if (!this.#touched) return false;
    const { sessions } = this.#options;
    try {
      if ('refusal' in sessions) throw new Error(sessions.refusal);
      const session = this.#session();
      const written = sessions.keep(session);
      await this.#keepFiles(sessions, session);
      await written;
      this.#told.delete('work');
      return !this.#told.has('files');
    } catch (error) {
      this.#tell({ kind: 'work', why: messageOf(error) });
      return false;
    }
  }

  #later(): void {
    this.#since ??= performance.now();
    clearTimeout(this.#timer);
    const left = this.#since + LATEST - performance.now();
    this.#timer = setTimeout(() => void this.now(), Math.max(0, Math.min(PAUSE, left)));
  }

  #session(): KeptSession {
    const { studio, pilot, id, address } = this.#options;
    const state = studio.store.getState();
    const { lock, cruise, playing, loop } = state;
    return {
      id,
      address: address(),
      name: projectName(state),
      document: state.history.document,
      origin: state.history.origin,
      unsaved: isUnsaved(state),
      at: Date.now(),
      passed: false,
      ...(state.picture && { view: { observer: pilot.observer, lock, cruise, playing, loop } }),
    };
  }

  async #keepFiles(sessions: Sessions, { document, origin }: KeptSession): Promise<void> {
    const { localFiles, id } = this.#options;
    for (const name of [origin, ...filesIn(document as GraphDocument, nodeLibrary)]) {
      const set = localFiles.setOf(name);
      if (!set || this.#keptSets.has(set.id)) continue;
      this.#keptSets.add(set.id);
      const size = sizeOf(set.files);
      if (this.#keptBytes + size > MOST_KEPT) {
        this.#tell({ kind: 'files', size: formatBytes(size) });
        continue;
      }
      this.#keptBytes += size;
      try {
        await sessions.keepFiles(id, set.id, set.files);
      } catch (error) {
        this.#keptSets.delete(set.id);
        throw error;
      }
    }
  }

  #tell(unkept: Unkept): void {
    if (this.#told.has(unkept.kind)) return;
    this.#told.add(unkept.kind);
    this.onUnkept(unkept);
  }
}

/** Archives count once, whatever of them is used. */
function sizeOf(files: HeldFiles): number {
  const blobs = new Set([...files.values()].map((file: HeldFile) => (file instanceof Blob ? file : file.archive)));
  return [...blobs].reduce((sum, { size }) => sum + size, 0);
}
