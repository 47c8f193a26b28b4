import { type DBSchema, type IDBPDatabase, openDB } from 'idb';
import * as z from 'zod/mini';
import type { UserFiles } from '../loading/userFiles.ts';

const vector = z.readonly(z.tuple([z.number(), z.number(), z.number()]));

/** From where, when and how the project is looked at: what is in no document. */
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
  /** Of the page, with all that follows its path. */
  address: z.string(),
  name: z.string(),
  /** Read as strictly as a file. */
  document: z.unknown(),
  origin: z.string(),
  unsaved: z.boolean(),
  /** When it was kept, in milliseconds since 1970. */
  at: z.number(),
  /** A person was told of it in another tab, and went on without it. */
  passed: z.boolean(),
  view: z.optional(viewSchema),
});

export type SessionView = z.infer<typeof viewSchema>;
/** What a tab holds, so that it comes back there. */
export type SessionRecord = z.infer<typeof sessionSchema>;

/** The sets of files that a session's document refers to, by their keys. */
export type SessionFiles = ReadonlyMap<string, UserFiles>;

interface Schema extends DBSchema {
  sessions: { key: string; value: unknown };
  files: { key: [session: string, set: string]; value: UserFiles };
}

/** So many sessions are kept of tabs that are closed: of those with something to be saved, and of the others. */
const MAX_CLOSED_SESSIONS = 8;
/** How long a tab that is loaded again waits for itself to be gone [ms]. */
const LOCK_TIMEOUT = 400;

/** What is kept in the browser, of this tab and of others; no tab writes what another has open. */
export class SessionStore {
  private readonly database: IDBPDatabase<Schema>;

  /** Rejects where the browser keeps nothing. */
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

  /** Undefined also of what another version left and this one cannot read. */
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

  /** Written although the page may go at once. */
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

  /** Of tabs that are closed, those with something to be saved first, the latest first; those beyond a number are forgotten. */
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

/** Takes a session for this tab, as long as it is open; false: another tab has it. Where there are no locks it is believed to be free. */
export function acquireSession(id: string): Promise<boolean> {
  if (!navigator.locks) return Promise.resolve(true);
  return new Promise((resolve) => {
    const held = navigator.locks.request(lockName(id), { signal: AbortSignal.timeout(LOCK_TIMEOUT) }, () => {
      resolve(true);
      // Until the tab is closed.
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

/** A key that no other tab has. */
export const randomId = (): string =>
  [...crypto.getRandomValues(new Uint8Array(12))].map((byte) => byte.toString(16).padStart(2, '0')).join('');

const TAB_SESSION_KEY = 'slowlight.session';

/** The session of this tab, also after it was loaded again; undefined where there is none, or the browser does not say. */
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
    // The session is kept all the same, and offered as that of a closed tab.
  }
}
