import { formatBytes } from '../../formats/diagnostics/inputError.ts';
import type { GraphDocument } from '../../graph/document/document.ts';
import { referencedFiles } from '../../graph/document/fileReferences.ts';
import type { LocalizedText, Message } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import type { ObserverController } from '../flight/observerController.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import type { UserFile, UserFiles } from '../loading/userFiles.ts';
import { type Editor, type EditorState, isUnsaved } from '../state/editor.ts';
import { projectName } from './projectNames.ts';
import { randomId, type SessionRecord, type SessionStore } from './sessionStore.ts';

/** Delay after the last edit, and maximum delay after the first [ms]. */
const SAVE_DELAY = 300;
const MAX_SAVE_DELAY = 2000;
/** Limit on the user files stored for one session [bytes]. */
const MAX_SESSION_FILE_BYTES = 2 ** 28;
/** Number of replaced projects stored per tab, so that they do not displace those of closed tabs. */
const MAX_REPLACED_PROJECTS = 3;

/** What cannot be stored, and why; reported once each. */
export type AutosaveFailure =
  | { readonly kind: 'work'; readonly why: LocalizedText }
  | { readonly kind: 'files'; readonly size: LocalizedText };

export interface AutosaveOptions {
  readonly editor: Editor;
  readonly observerController: ObserverController;
  readonly localFiles: LocalFiles;
  /** A `refusal` if the browser provides no storage. */
  readonly sessions: SessionStore | { readonly refusal: Message };
  readonly id: string;
  readonly address: () => string;
  /** Ids of file sets already stored, when the tab's session was restored. */
  readonly savedSets?: Iterable<string>;
}

/** The file sets of a session that are in the store. */
interface SavedSets {
  readonly ids: Set<string>;
  bytes: number;
}

/**
 * Stores every edit in the browser shortly after it was made and when the page is closed; also projects with unsaved
 * changes that were replaced, since undo history does not survive a reload.
 */
export class Autosave {
  /** Called when something cannot be stored. */
  onFailure: (failure: AutosaveFailure) => void = () => {};
  /** Whether the page restored its previous session. */
  readonly isRestored: boolean;
  private readonly options: AutosaveOptions;
  private readonly storedSets: SavedSets;
  /** Ids of replaced projects, oldest first. */
  private readonly replaced: string[] = [];
  private readonly reported = new Set<AutosaveFailure['kind']>();
  /** Time of the first edit that is not stored yet [ms]. */
  private firstUnsavedEdit: number | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Whether this tab has something in the store, or to be stored. */
  private hasWork: boolean;

  constructor(options: AutosaveOptions) {
    this.options = options;
    this.storedSets = { ids: new Set(options.savedSets), bytes: 0 };
    this.isRestored = options.savedSets !== undefined;
    this.hasWork = this.isRestored;
    const { editor } = options;
    editor.store.subscribe((now, before) => {
      if (now.history.document === before.history.document && isUnsaved(now) === isUnsaved(before)) return;
      this.hasWork = true;
      if (isReplaced(now, before) && isUnsaved(before)) void this.storeReplaced(before);
      this.scheduleSave();
    });
    addEventListener('pagehide', () => void this.saveNow());
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.saveNow();
    });
  }

  /**
   * Stores the current state; the page may be closed right after the call. Resolves to whether everything was stored.
   */
  async saveNow(): Promise<boolean> {
    clearTimeout(this.timer);
    this.firstUnsavedEdit = undefined;
    if (!this.hasWork) return false;
    const { sessions } = this.options;
    try {
      if ('refusal' in sessions) throw new MessageError(sessions.refusal);
      const { editor, observerController, id } = this.options;
      const state = editor.store.getState();
      const { lock, cruise, playing, loop } = state;
      const view = state.picture && { observer: observerController.observer, lock, cruise, playing, loop };
      await this.store(sessions, { ...this.session(id, state), ...(view && { view }) }, this.storedSets);
      this.reported.delete('work');
      return !this.reported.has('files');
    } catch (error) {
      this.report({ kind: 'work', why: messageOf(error) });
      return false;
    }
  }

  private scheduleSave(): void {
    this.firstUnsavedEdit ??= performance.now();
    clearTimeout(this.timer);
    const left = this.firstUnsavedEdit + MAX_SAVE_DELAY - performance.now();
    this.timer = setTimeout(() => void this.saveNow(), Math.max(0, Math.min(SAVE_DELAY, left)));
  }

  /** Listed in the menu together with the sessions of closed tabs. */
  private async storeReplaced(state: EditorState): Promise<void> {
    const { sessions } = this.options;
    if ('refusal' in sessions) return;
    const id = randomId();
    this.replaced.push(id);
    try {
      await this.store(sessions, { ...this.session(id, state), passed: true }, { ids: new Set(), bytes: 0 });
      if (this.replaced.length > MAX_REPLACED_PROJECTS) await sessions.delete(this.replaced.shift()!);
    } catch (error) {
      this.report({ kind: 'work', why: messageOf(error) });
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

  /** The write of the document is started first: it completes even while the page is being closed. */
  private async store(sessions: SessionStore, session: SessionRecord, stored: SavedSets): Promise<void> {
    const written = sessions.save(session);
    await this.storeFiles(sessions, session, stored);
    await written;
  }

  private async storeFiles(
    sessions: SessionStore,
    { id, document, origin }: SessionRecord,
    stored: SavedSets,
  ): Promise<void> {
    const { localFiles } = this.options;
    for (const name of [origin, ...referencedFiles(document as GraphDocument, nodeLibrary)]) {
      const set = localFiles.setOf(name);
      if (!set || stored.ids.has(set.id)) continue;
      stored.ids.add(set.id);
      const size = sizeOf(set.files);
      if (stored.bytes + size > MAX_SESSION_FILE_BYTES) {
        this.report({ kind: 'files', size: formatBytes(size) });
        continue;
      }
      stored.bytes += size;
      try {
        await sessions.saveFiles(id, set.id, set.files);
      } catch (error) {
        stored.ids.delete(set.id);
        throw error;
      }
    }
  }

  private report(failure: AutosaveFailure): void {
    if (this.reported.has(failure.kind)) return;
    this.reported.add(failure.kind);
    this.onFailure(failure);
  }
}

/** Whether another project was opened (not by undo or redo). */
function isReplaced({ history: now }: EditorState, { history: before }: EditorState): boolean {
  const step = now.past.at(-1);
  return step?.origins !== undefined && now.past.length > before.past.length && step !== before.future[0];
}

/** An archive counts once, however many of its entries are used. */
function sizeOf(files: UserFiles): number {
  const blobs = new Set([...files.values()].map((file: UserFile) => (file instanceof Blob ? file : file.archive)));
  return [...blobs].reduce((sum, { size }) => sum + size, 0);
}
