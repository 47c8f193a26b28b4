import { formatBytes, messageOf } from '../../formats/fail.ts';
import type { GraphDocument } from '../../graph/document.ts';
import { filesIn } from '../../graph/files.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { HeldFile, HeldFiles } from '../loading/held.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import { isUnsaved, type Studio, type StudioState } from '../state/studio.ts';
import type { Pilot } from '../viewport/pilot.ts';
import { projectName } from './names.ts';
import { freshId, type KeptSession, type Sessions } from './sessions.ts';

/** After the last edit, and at the latest after the first [ms]. */
const PAUSE = 300;
const LATEST = 2000;
/** Of the files that a person gave, all sets of a session together [bytes]. */
const MOST_KEPT = 2 ** 28;
/** So many projects that others took the place of, of one tab; so that they do not crowd out the work of closed tabs. */
const MOST_ASIDE = 3;

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

/** The sets of files of one session that are in the store. */
interface KeptSets {
  readonly ids: Set<string>;
  bytes: number;
}

/**
 * Keeps every edit in the browser, a moment after it was made and when the page is left; and what was not saved when another project
 * took its place, since undo begins anew where the page is loaded again.
 */
export class Autosave {
  /** Hears of what cannot be kept. */
  onUnkept: (unkept: Unkept) => void = () => {};
  /** The page came back where it was. */
  readonly isRestored: boolean;
  readonly #options: AutosaveOptions;
  readonly #keptSets: KeptSets;
  /** Put aside, the oldest first. */
  readonly #aside: string[] = [];
  readonly #told = new Set<Unkept['kind']>();
  /** Of the first edit that is not kept yet [ms]. */
  #since: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** There is something of this tab in the store, or to be put there. */
  #touched: boolean;

  constructor(options: AutosaveOptions) {
    this.#options = options;
    this.#keptSets = { ids: new Set(options.kept), bytes: 0 };
    this.isRestored = options.kept !== undefined;
    this.#touched = this.isRestored;
    const { studio } = options;
    studio.store.subscribe((now, before) => {
      if (now.history.document === before.history.document && isUnsaved(now) === isUnsaved(before)) return;
      this.#touched = true;
      if (isReplaced(now, before) && isUnsaved(before)) void this.#putAside(before);
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
      const { studio, pilot, id } = this.#options;
      const state = studio.store.getState();
      const { lock, cruise, playing, loop } = state;
      const view = state.picture && { observer: pilot.observer, lock, cruise, playing, loop };
      await this.#keep(sessions, { ...this.#session(id, state), ...(view && { view }) }, this.#keptSets);
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

  /** It is offered in the menu, as the work of closed tabs is. */
  async #putAside(state: StudioState): Promise<void> {
    const { sessions } = this.#options;
    if ('refusal' in sessions) return;
    const id = freshId();
    this.#aside.push(id);
    try {
      await this.#keep(sessions, { ...this.#session(id, state), passed: true }, { ids: new Set(), bytes: 0 });
      if (this.#aside.length > MOST_ASIDE) await sessions.forget(this.#aside.shift()!);
    } catch (error) {
      this.#tell({ kind: 'work', why: messageOf(error) });
    }
  }

  #session(id: string, state: StudioState): KeptSession {
    const { document, origin } = state.history;
    return {
      id,
      address: this.#options.address(),
      name: projectName(state),
      document,
      origin,
      unsaved: isUnsaved(state),
      at: Date.now(),
      passed: false,
    };
  }

  /** The document is written although the page may go at once. */
  async #keep(sessions: Sessions, session: KeptSession, kept: KeptSets): Promise<void> {
    const written = sessions.keep(session);
    await this.#keepFiles(sessions, session, kept);
    await written;
  }

  async #keepFiles(sessions: Sessions, { id, document, origin }: KeptSession, kept: KeptSets): Promise<void> {
    const { localFiles } = this.#options;
    for (const name of [origin, ...filesIn(document as GraphDocument, nodeLibrary)]) {
      const set = localFiles.setOf(name);
      if (!set || kept.ids.has(set.id)) continue;
      kept.ids.add(set.id);
      const size = sizeOf(set.files);
      if (kept.bytes + size > MOST_KEPT) {
        this.#tell({ kind: 'files', size: formatBytes(size) });
        continue;
      }
      kept.bytes += size;
      try {
        await sessions.keepFiles(id, set.id, set.files);
      } catch (error) {
        kept.ids.delete(set.id);
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

/** Another project was opened; not by doing again what was undone. */
function isReplaced({ history: now }: StudioState, { history: before }: StudioState): boolean {
  const step = now.past.at(-1);
  return step?.origins !== undefined && now.past.length > before.past.length && step !== before.future[0];
}

/** Archives count once, whatever of them is used. */
function sizeOf(files: HeldFiles): number {
  const blobs = new Set([...files.values()].map((file: HeldFile) => (file instanceof Blob ? file : file.archive)));
  return [...blobs].reduce((sum, { size }) => sum + size, 0);
}
