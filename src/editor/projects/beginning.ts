import { messageOf } from '../../formats/fail.ts';
import { isShared, readShared } from '../../graph/share.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import { type Beginning, beginningWith } from '../state/studio.ts';
import { adopted } from './adopting.ts';
import { linkProblem, type OpeningProblem, openingProblem, projectAt } from './opening.ts';
import { freshId, hold, type KeptView, ownSession, Sessions, setOwnSession } from './sessions.ts';

/** What a page shows that is asked for nothing. */
export const FIRST_SCENE = 'examples/street.usda';

/** What a page's address asks for. */
export interface Wanted {
  /** Address of a scene. */
  readonly scene?: string;
  /** Address of a project; it comes before the scene. */
  readonly project?: string;
}

/** How a tab begins, and under which key it is kept. */
export interface Begun {
  readonly beginning: Beginning;
  readonly sessions: Sessions | { readonly refusal: string };
  readonly id: string;
  /** Sets of files that are kept under this key already; undefined of a new session. */
  readonly kept?: Iterable<string>;
  readonly view?: KeptView;
  /** Why it is not what was asked for. */
  readonly problem?: OpeningProblem;
}

/** By which a session is known to be of the same page: with its query and what follows `#`. */
export const pageAddress = (): string => location.pathname + location.search + location.hash;

/** Where the tab was, if it was at this address before; else what the address asks for. */
export async function begin(wanted: Wanted, local: LocalFiles): Promise<Begun> {
  const sessions = await Sessions.open().catch((error: unknown) => ({ refusal: messageOf(error) }));
  const back = 'refusal' in sessions ? undefined : await returned(sessions, local).catch(() => undefined);
  const own = back?.id ?? freshId();
  if (!back) await hold(own);
  setOwnSession(own);
  return { sessions, id: own, ...(back ?? (await asked(wanted, local))) };
}

/** The session of this tab; of a tab that is a copy of another a copy, under a key of its own. */
async function returned(sessions: Sessions, local: LocalFiles): Promise<Omit<Begun, 'sessions'> | undefined> {
  const before = ownSession();
  const session = before === undefined ? undefined : await sessions.get(before);
  if (!session || session.address !== pageAddress()) return undefined;
  const files = await sessions.filesOf(session.id);
  const beginning = adopted(session, files, local);
  const { view } = session;
  if (await hold(session.id)) return { beginning, view, id: session.id, kept: files.keys() };
  const id = freshId();
  await hold(id);
  return { beginning, view, id, kept: [] };
}

async function asked(
  { scene = FIRST_SCENE, project }: Wanted,
  local: LocalFiles,
): Promise<Pick<Begun, 'beginning' | 'problem'>> {
  try {
    if (isShared(location.hash)) return { beginning: beginningAtLink(location.hash) };
    if (project !== undefined) return { beginning: await projectAt(project, local) };
    return { beginning: beginningWith(scene) };
  } catch (error) {
    const problem = isShared(location.hash) ? linkProblem(error) : openingProblem(project ?? scene, error);
    return { beginning: beginningWith(scene), problem };
  }
}

/** What a link carries. Throws a DocumentError where it is damaged. */
export const beginningAtLink = (fragment: string): Beginning => ({
  document: readShared(fragment),
  // Known again by its end: links of two projects differ there.
  origin: `#${fragment.slice(-24)}`,
  unsaved: false,
});
