import { formatBytes, messageOf } from '../../formats/diagnostics/inputError.ts';
import type { GraphDocument } from '../../graph/document/document.ts';
import { referencedFiles } from '../../graph/document/fileReferences.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { ObserverController } from '../flight/observerController.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import type { UserFile, UserFiles } from '../loading/userFiles.ts';
import { type Editor, type EditorState, isUnsaved } from '../state/editor.ts';
import { projectName } from './projectNames.ts';
import { randomId, type SessionRecord, type SessionStore } from './sessionStore.ts';

/** After the last edit, and at the latest after the first [ms]. */
const SAVE_DELAY = 300;
const MAX_SAVE_DELAY = 2000;
/** Of the files that a person gave, all sets of a session together [bytes]. */
const MAX_SESSION_FILE_BYTES = 2 ** 28;
/** So many projects that others took the place of, of one tab; so that they do not crowd out the work of closed tabs. */
const MAX_REPLACED_PROJECTS = 3;

/** What cannot be kept, and why; told once each. */
export type AutosaveFailure =
  | { readonly kind: 'work'; readonly why: string }
  | { readonly kind: 'files'; readonly size: string };

export interface AutosaveOptions {
  readonly studio: Editor;
  readonly observerController: ObserverController;
  readonly localFiles: LocalFiles;
  /** Undefined: the browser keeps nothing, for this reason. */
  readonly sessions: SessionStore | { readonly refusal: string };
  readonly id: string;
  readonly address: () => string;
  /** The session is that of this tab before it was loaded again: these sets are kept already. */
  readonly savedSets?: Iterable<string>;
}

/** The sets of files of one session that are in the store. */
interface SavedSets {
  readonly ids: Set<string>;
  bytes: number;
}

/**
 * Keeps every edit in the browser, a moment after it was made and when the page is left; and what was not saved when another project
 * took its place, since undo begins anew where the page is loaded again.
 */
export class Autosave {
  /** Hears of what cannot be kept. */
  onFailure: (unkept: AutosaveFailure) => void = () => {};
  /** The page came back where it was. */
  readonly isRestored: boolean;
  private readonly options: AutosaveOptions;
  private readonly keptSets: SavedSets;
  /** Put aside, the oldest first. */
  private readonly aside: string[] = [];
  private readonly told = new Set<AutosaveFailure['kind']>();
  /** Of the first edit that is not kept yet [ms]. */
  private since: number | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** There is something of this tab in the store, or to be put there. */
  private touched: boolean;

  constructor(options: AutosaveOptions) {
    this.options = options;
    this.keptSets = { ids: new Set(options.savedSets), bytes: 0 };
    this.isRestored = options.savedSets !== undefined;
    this.touched = this.isRestored;
    const { studio } = options;
    studio.store.subscribe((now, before) => {
      if (now.history.document === before.history.document && isUnsaved(now) === isUnsaved(before)) return;
      this.touched = true;
      if (isReplaced(now, before) && isUnsaved(before)) void this.putAside(before);
      this.later();
    });
    addEventListener('pagehide', () => void this.saveNow());
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.saveNow();
    });
  }

  /** Keeps what there is; the page may go at once. Gives whether all of it is kept. */
  async saveNow(): Promise<boolean> {
    clearTimeout(this.timer);
    this.since = undefined;
    if (!this.touched) return false;
    const { sessions } = this.options;
    try {
      if ('refusal' in sessions) throw new Error(sessions.refusal);
      const { studio, observerController, id } = this.options;
      const state = studio.store.getState();
      const { lock, cruise, playing, loop } = state;
      const view = state.picture && { observer: observerController.observer, lock, cruise, playing, loop };
      await this.keep(sessions, { ...this.session(id, state), ...(view && { view }) }, this.keptSets);
      this.told.delete('work');
      return !this.told.has('files');
    } catch (error) {
      this.tell({ kind: 'work', why: messageOf(error) });
      return false;
    }
  }

  private later(): void {
    this.since ??= performance.now();
    clearTimeout(this.timer);
    const left = this.since + MAX_SAVE_DELAY - performance.now();
    this.timer = setTimeout(() => void this.saveNow(), Math.max(0, Math.min(SAVE_DELAY, left)));
  }

  /** It is offered in the menu, as the work of closed tabs is. */
  private async putAside(state: EditorState): Promise<void> {
    const { sessions } = this.options;
    if ('refusal' in sessions) return;
    const id = randomId();
    this.aside.push(id);
    try {
      await this.keep(sessions, { ...this.session(id, state), passed: true }, { ids: new Set(), bytes: 0 });
      if (this.aside.length > MAX_REPLACED_PROJECTS) await sessions.delete(this.aside.shift()!);
    } catch (error) {
      this.tell({ kind: 'work', why: messageOf(error) });
    }
  }

  private session(id: string, state: EditorState): SessionRecord {
    const { document, origin } = state.history;
    return {
      id,
      address: this.options.address(),
      name: projectName(state),
      document,
      origin,
      unsaved: isUnsaved(state),
      at: Date.now(),
      passed: false,
    };
  }

  /** The document is written although the page may go at once. */
  private async keep(sessions: SessionStore, session: SessionRecord, kept: SavedSets): Promise<void> {
    const written = sessions.save(session);
    await this.keepFiles(sessions, session, kept);
    await written;
  }

  private async keepFiles(
    sessions: SessionStore,
    { id, document, origin }: SessionRecord,
    kept: SavedSets,
  ): Promise<void> {
    const { localFiles } = this.options;
    for (const name of [origin, ...referencedFiles(document as GraphDocument, nodeLibrary)]) {
      const set = localFiles.setOf(name);
      if (!set || kept.ids.has(set.id)) continue;
      kept.ids.add(set.id);
      const size = sizeOf(set.files);
      if (kept.bytes + size > MAX_SESSION_FILE_BYTES) {
        this.tell({ kind: 'files', size: formatBytes(size) });
        continue;
      }
      kept.bytes += size;
      try {
        await sessions.saveFiles(id, set.id, set.files);
      } catch (error) {
        kept.ids.delete(set.id);
        throw error;
      }
    }
  }

  private tell(unkept: AutosaveFailure): void {
    if (this.told.has(unkept.kind)) return;
    this.told.add(unkept.kind);
    this.onFailure(unkept);
  }
}

/** Another project was opened; not by doing again what was undone. */
function isReplaced({ history: now }: EditorState, { history: before }: EditorState): boolean {
  const step = now.past.at(-1);
  return step?.origins !== undefined && now.past.length > before.past.length && step !== before.future[0];
}

/** Archives count once, whatever of them is used. */
function sizeOf(files: UserFiles): number {
  const blobs = new Set([...files.values()].map((file: UserFile) => (file instanceof Blob ? file : file.archive)));
  return [...blobs].reduce((sum, { size }) => sum + size, 0);
}
