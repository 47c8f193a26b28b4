import { type DBSchema, type IDBPDatabase, openDB } from 'idb';
import * as z from 'zod/mini';
import type { UserFiles } from '../loading/userFiles.ts';

const vector = z.readonly(z.tuple([z.number(), z.number(), z.number()]));

/** Observer, time and lock: the view state that is in no document. */
const viewSchema = z.object({
  observer: z.object({
    t: z.number(),
    position: vector,
    u: vector,
    orientation: z.readonly(z.tuple([z.number(), z.number(), z.number(), z.number()])),
    properTime: z.number(),
  }),
  lock: z.enum(['free', 'look', 'fly']),
  cruise: z.boolean(),
  playing: z.boolean(),
  loop: z.boolean(),
});

const sessionSchema = z.object({
  id: z.string(),
  /** Path, query and fragment of the page. */
  address: z.string(),
  name: z.string(),
  /** Validated like a file. */
  document: z.unknown(),
  origin: z.string(),
  unsaved: z.boolean(),
  /** Time of storing [ms since 1970]. */
  at: z.number(),
  /** Whether it was offered in another tab and not restored. */
  passed: z.boolean(),
  view: z.optional(viewSchema),
});

export type SessionView = z.infer<typeof viewSchema>;
/** The stored state of a tab. */
export type SessionRecord = z.infer<typeof sessionSchema>;

/** File sets that a session's document refers to, by id. */
export type SessionFiles = ReadonlyMap<string, UserFiles>;

interface Schema extends DBSchema {
  sessions: { key: string; value: unknown };
  files: { key: [session: string, set: string]; value: UserFiles };
}

/** Number of sessions kept for closed tabs, for those with unsaved changes and for the others each. */
const MAX_CLOSED_SESSIONS = 8;
/** How long a reloaded tab waits for its previous page to release the lock [ms]. */
const LOCK_TIMEOUT = 400;

/** Sessions stored in the browser, of this and other tabs; a tab never writes a session that another has open. */
export class SessionStore {
  private readonly database: IDBPDatabase<Schema>;

  /** Rejects if the browser provides no storage. */
  static async open(): Promise<SessionStore> {
    const database = await openDB<Schema>('slowlight', 1, {
      upgrade: (fresh) => {
        fresh.createObjectStore('sessions');
        fresh.createObjectStore('files');
      },
    });
    return new SessionStore(database);
  }

  private constructor(database: IDBPDatabase<Schema>) {
    this.database = database;
  }

  /** Undefined also for records of another version that cannot be read. */
  async get(id: string): Promise<SessionRecord | undefined> {
    return sessionSchema.safeParse(await this.database.get('sessions', id)).data;
  }

  async filesOf(id: string): Promise<SessionFiles> {
    const all = IDBKeyRange.bound([id], [id, []]);
    const [keys, values] = await Promise.all([
      this.database.getAllKeys('files', all),
      this.database.getAll('files', all),
    ]);
    return new Map(keys.map(([, set], i) => [set, values[i]!]));
  }

  /** Completes although the page may be closing. */
  async save(session: SessionRecord): Promise<void> {
    const change = this.database.transaction('sessions', 'readwrite');
    const written = change.store.put(session, session.id);
    change.commit();
    await Promise.all([written, change.done]);
  }

  async saveFiles(id: string, set: string, files: UserFiles): Promise<void> {
    await this.database.put('files', files, [id, set]);
  }

  async delete(id: string): Promise<void> {
    const change = this.database.transaction(['sessions', 'files'], 'readwrite');
    await Promise.all([
      change.objectStore('sessions').delete(id),
      change.objectStore('files').delete(IDBKeyRange.bound([id], [id, []])),
      change.done,
    ]);
  }

  /**
   * Sessions of closed tabs, those with unsaved changes first, then latest first; those beyond the limit are deleted.
   */
  async closedSessions(): Promise<readonly SessionRecord[]> {
    const [all, open] = await Promise.all([this.database.getAll('sessions'), openSessions()]);
    const found = all
      .flatMap((kept) => sessionSchema.safeParse(kept).data ?? [])
      .filter(({ id }) => !open.has(id))
      .sort((a, b) => b.at - a.at);
    const kept = [true, false].flatMap((unsaved) =>
      found.filter((session) => session.unsaved === unsaved).slice(0, MAX_CLOSED_SESSIONS),
    );
    await Promise.all(found.filter((session) => !kept.includes(session)).map(({ id }) => this.delete(id)));
    return kept;
  }
}

const lockName = (id: string): string => `slowlight.session.${id}`;

/**
 * Locks a session for this tab's lifetime; resolves to false if another tab has it. Without the Web Locks API it is
 * assumed to be free.
 */
export function acquireSession(id: string): Promise<boolean> {
  if (!navigator.locks) return Promise.resolve(true);
  return new Promise((resolve) => {
    const held = navigator.locks.request(lockName(id), { signal: AbortSignal.timeout(LOCK_TIMEOUT) }, () => {
      resolve(true);
      // Held until the tab is closed.
      return new Promise<never>(() => {});
    });
    held.catch(() => resolve(false));
  });
}

async function openSessions(): Promise<ReadonlySet<string>> {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  const prefix = lockName('');
  return new Set(held.flatMap(({ name }) => (name?.startsWith(prefix) ? [name.slice(prefix.length)] : [])));
}

/** A random session id. */
export const randomId = (): string =>
  [...crypto.getRandomValues(new Uint8Array(12))].map((byte) => byte.toString(16).padStart(2, '0')).join('');

const TAB_SESSION_KEY = 'slowlight.session';

/** Id of this tab's session, which survives a reload; undefined if there is none or storage is not accessible. */
export function tabSession(): string | undefined {
  try {
    return sessionStorage.getItem(TAB_SESSION_KEY) ?? undefined;
  } catch {
    return undefined;
  }
}

export function setTabSession(id: string): void {
  try {
    sessionStorage.setItem(TAB_SESSION_KEY, id);
  } catch {
    // The session is stored all the same, and offered as that of a closed tab.
  }
}
