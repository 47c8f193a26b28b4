import { messageOf } from '../../formats/diagnostics/inputError.ts';
import { decodeShareLink, isShareLink } from '../../graph/document/shareLink.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import { type LoadedProject, projectOfScene } from '../state/editor.ts';
import { linkErrorOf, type OpenError, openErrorOf, projectFromAddress } from './projectSource.ts';
import { restoreSession } from './restoreSession.ts';
import { acquireSession, randomId, SessionStore, type SessionView, setTabSession, tabSession } from './sessionStore.ts';

/** What a page shows that is asked for nothing. */
export const DEFAULT_SCENE = 'examples/street.usda';

/** What a page's address asks for. */
export interface StartupRequest {
  /** Address of a scene. */
  readonly scene?: string;
  /** Address of a project; it comes before the scene. */
  readonly project?: string;
}

/** How a tab begins, and under which key it is kept. */
export interface StartupState {
  readonly project: LoadedProject;
  readonly sessions: SessionStore | { readonly refusal: string };
  readonly id: string;
  /** Sets of files that are kept under this key already; undefined of a new session. */
  readonly savedSets?: Iterable<string>;
  readonly view?: SessionView;
  /** Why it is not what was asked for. */
  readonly problem?: OpenError;
}

/** By which a session is known to be of the same page: with its query and what follows `#`. */
export const pageAddress = (): string => location.pathname + location.search + location.hash;

/** Where the tab was, if it was at this address before; else what the address asks for. */
export async function openStartupProject(wanted: StartupRequest, local: LocalFiles): Promise<StartupState> {
  const sessions = await SessionStore.open().catch((error: unknown) => ({ refusal: messageOf(error) }));
  const back = 'refusal' in sessions ? undefined : await restoreTabSession(sessions, local).catch(() => undefined);
  const own = back?.id ?? randomId();
  if (!back) await acquireSession(own);
  setTabSession(own);
  return { sessions, id: own, ...(back ?? (await openRequested(wanted, local))) };
}

/** The session of this tab; of a tab that is a copy of another a copy, under a key of its own. */
async function restoreTabSession(
  sessions: SessionStore,
  local: LocalFiles,
): Promise<Omit<StartupState, 'sessions'> | undefined> {
  const before = tabSession();
  const session = before === undefined ? undefined : await sessions.get(before);
  if (!session || session.address !== pageAddress()) return undefined;
  const files = await sessions.filesOf(session.id);
  const beginning = restoreSession(session, files, local);
  const { view } = session;
  if (await acquireSession(session.id)) return { project: beginning, view, id: session.id, savedSets: files.keys() };
  const id = randomId();
  await acquireSession(id);
  return { project: beginning, view, id, savedSets: [] };
}

async function openRequested(
  { scene = DEFAULT_SCENE, project }: StartupRequest,
  local: LocalFiles,
): Promise<Pick<StartupState, 'project' | 'problem'>> {
  try {
    if (isShareLink(location.hash)) return { project: projectFromLink(location.hash) };
    if (project !== undefined) return { project: await projectFromAddress(project, local) };
    return { project: projectOfScene(scene) };
  } catch (error) {
    const problem = isShareLink(location.hash) ? linkErrorOf(error) : openErrorOf(project ?? scene, error);
    return { project: projectOfScene(scene), problem };
  }
}

/** What a link carries. Throws a DocumentError where it is damaged. */
export const projectFromLink = (fragment: string): LoadedProject => ({
  document: decodeShareLink(fragment),
  // Known again by its end: links of two projects differ there.
  origin: `#${fragment.slice(-24)}`,
  unsaved: false,
});
