import { isShareLink } from '../../graph/document/shareFragment.ts';
import type { Message } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import { type LoadedProject, projectOfScene } from '../state/editor.ts';
import { linkErrorOf, type OpenError, openErrorOf, projectFromAddress } from './projectSource.ts';
import { restoreSession } from './restoreSession.ts';
import { acquireSession, randomId, SessionStore, type SessionView, setTabSession, tabSession } from './sessionStore.ts';

/** Scene of a page whose address names none. */
export const DEFAULT_SCENE = 'examples/street.usdc';

/** What a page's address requests. */
export interface StartupRequest {
  /** Address of a scene. */
  readonly scene?: string;
  /** Address of a project; takes precedence over the scene. */
  readonly project?: string;
}

/** Initial project of a tab, and the id of its session. */
export interface StartupState {
  readonly project: LoadedProject;
  readonly sessions: SessionStore | { readonly refusal: Message };
  readonly id: string;
  /** Ids of file sets stored under this session already; undefined for a new session. */
  readonly savedSets?: Iterable<string>;
  readonly view?: SessionView;
  /** Why the requested content is not shown. */
  readonly problem?: OpenError;
}

/** Identifies a session's page: path with query and fragment. */
export const pageAddress = (): string => location.pathname + location.search + location.hash;

/** Restores the tab's session if it was at this address; otherwise opens what the address requests. */
export async function openStartupProject(wanted: StartupRequest, local: LocalFiles): Promise<StartupState> {
  const sessions = await SessionStore.open().catch((error: unknown) => ({ refusal: messageOf(error) }));
  const back = 'refusal' in sessions ? undefined : await restoreTabSession(sessions, local).catch(() => undefined);
  const own = back?.id ?? randomId();
  if (!back) await acquireSession(own);
  setTabSession(own);
  return { sessions, id: own, ...(back ?? (await openRequested(wanted, local))) };
}

/** Restores this tab's session; a duplicated tab gets a copy under an id of its own. */
async function restoreTabSession(
  sessions: SessionStore,
  local: LocalFiles,
): Promise<Omit<StartupState, 'sessions'> | undefined> {
  const before = tabSession();
  const found = before === undefined ? undefined : await sessions.get(before);
  if (!found || found.address !== pageAddress()) return undefined;
  const isOwn = await acquireSession(found.id);
  // Read again: by now the page before, if there was one, has ended, and what it stored last is there.
  const session = (await sessions.get(found.id)) ?? found;
  const files = await sessions.filesOf(session.id);
  const beginning = restoreSession(session, files, local);
  const { view } = session;
  if (isOwn) return { project: beginning, view, id: session.id, savedSets: files.keys() };
  const id = randomId();
  await acquireSession(id);
  return { project: beginning, view, id, savedSets: [] };
}

async function openRequested(
  { scene = DEFAULT_SCENE, project }: StartupRequest,
  local: LocalFiles,
): Promise<Pick<StartupState, 'project' | 'problem'>> {
  try {
    if (isShareLink(location.hash)) return { project: await projectFromLink(location.hash) };
    if (project !== undefined) return { project: await projectFromAddress(project, local) };
    return { project: projectOfScene(scene) };
  } catch (error) {
    const problem = isShareLink(location.hash) ? linkErrorOf(error) : openErrorOf(project ?? scene, error);
    return { project: projectOfScene(scene), problem };
  }
}

/** The project in a link. Throws a DocumentError if it is damaged. Unpacking is loaded when there is a link. */
export async function projectFromLink(fragment: string): Promise<LoadedProject> {
  const { decodeShareLink } = await import('../../graph/document/shareLink.ts');
  // The end identifies the link: links of different projects differ there.
  return { document: decodeShareLink(fragment), origin: `#${fragment.slice(-24)}`, unsaved: false };
}
